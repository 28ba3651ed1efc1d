#pragma once
// The verb `toile grade`: a recipe in a range of sizes.

#include <string>

#include "cli/run.h"

namespace toile {

struct GradeOptions : RunOptions {
  std::string sizes;  // of the recipe's chart, separated by commas
};

// Drapes the recipe's size once, carries the edited garment over to the body of every size, and does for each what a run does,
// in a folder of its own; then writes what compares them. Returns the gravest of the sizes' exit codes. Throws BadInput; sizes
// that were finished stay.
int grade_recipe(const GradeOptions& options);

}  // namespace toile
