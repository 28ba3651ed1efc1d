#pragma once
// An edit's arguments as written, read against its table of parameters.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edit/operation.h"

namespace toile {

// Every parameter of the operation once, given or by default; of two that stand for each other the one that is given.
struct ReadArguments {
  std::map<std::string, double> numbers;     // unit "m" in metres, "deg" in radians, "" as they are
  std::map<std::string, std::string> names;  // units "loop", "size", "file"
};

// Throws BadInput: edit.unknown-parameter, edit.missing-parameter, edit.two-parameters (that stand for each other),
// edit.bad-length, edit.bad-angle (no unit, not a number), edit.bad-number, edit.bad-name (empty), edit.out-of-range.
ReadArguments read_arguments(const std::string& operation, const std::vector<Parameter>& parameters,
                             const EditArguments& arguments);

// The body that the arguments of `operation` name, when one of its parameters is a "size" or a "file". Throws BadInput
// edit.two-parameters for a skeleton without its body.
std::optional<BodyName> body_name(const std::string& operation, const ReadArguments& read);

}  // namespace toile
