#pragma once
// The verb `toile run`.

#include <filesystem>

#include "cli/progress.h"

namespace toile {

struct RunOptions {
  std::filesystem::path recipe;
  std::filesystem::path out;
  bool force = false;
  bool quiet = false;
  ProgressStyle progress = ProgressStyle::automatic;
};

// Does what the recipe says and writes the folder; returns the exit code. Throws BadInput, then nothing is left behind but the
// picture of dressing that got stuck.
int run_recipe(const RunOptions& options);

}  // namespace toile
