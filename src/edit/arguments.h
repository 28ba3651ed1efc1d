#pragma once
// An edit's arguments as written, read against its table of parameters.

#include <map>
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

}  // namespace toile
