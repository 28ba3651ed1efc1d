#pragma once
// An edit of several handles that are not one chain of edges: levels of both arms, a hem and a level.

#include <functional>
#include <string>
#include <vector>

#include "edit/operation.h"

namespace toile {

// The names of a list "a, b, c" that are looked up by themselves: its edges together, as they may close with each other, then
// every other name.
std::vector<std::string> names_apart(const EditInput& input, const std::string& list);

// `apply` with each name as the argument "loop" in turn, on what the one before made; one target of it all. What `input`
// remembers is used for the first only.
Target apply_in_turn(const EditInput& input, const EditArguments& arguments, const std::vector<std::string>& names,
                     const std::function<Target(const EditInput&, const EditArguments&)>& apply);

}  // namespace toile
