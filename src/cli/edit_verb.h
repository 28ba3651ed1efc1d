#pragma once
// The verb `toile edit`: a recipe's edits in 3D, without the adjustment.

#include "cli/run.h"

namespace toile {

// Drapes, makes the edits and writes source and target; returns the exit code. Throws BadInput as run_recipe does.
int edit_recipe(const RunOptions& options);

}  // namespace toile
