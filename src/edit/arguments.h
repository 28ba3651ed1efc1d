#pragma once
// An edit's arguments as written, read against its table of parameters.

#include <map>
#include <string>
#include <vector>

#include "edit/operation.h"

namespace toile {

// Every parameter of the operation once, given or by default.
struct ReadArguments {
  std::map<std::string, double> numbers;     // unit "m" in metres, unit "" as they are
  std::map<std::string, std::string> names;  // unit "loop"
};

// Throws BadInput: edit.unknown-parameter, edit.missing-parameter, edit.bad-length (no unit, not a number), edit.bad-number,
// edit.out-of-range.
ReadArguments read_arguments(const std::string& operation, const std::vector<Parameter>& parameters,
                             const EditArguments& arguments);

}  // namespace toile
