#include "cli/run.h"

#include <chrono>
#include <cstdio>

#include "cli/account.h"
#include "cli/job.h"
#include "cli/output_folder.h"
#include "cli/recipe_file.h"
#include "cli/stuck.h"
#include "cli/write_run.h"
#include "cut/cut.h"
#include "formats/formats.h"

namespace toile {

int run_recipe(const RunOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  Progress progress(options.progress);
  Job job;
  job.recipe_file = options.recipe;
  job.recipe = value_or_throw(read_recipe(options.recipe));
  OutputFolder out(options.out, options.force);
  load(job, progress);
  lay_out(job.pattern, job.recipe.cut);  // what cannot be cut as it is read is said before the work
  try {
    drape(job, progress, with_stuck_picture(watched(progress), job, out));
    make_target(job, progress);
    finish_run(job, out, value_or_throw(read_whole_file(options.recipe)), began, progress);
  } catch (const BadInput&) {
    keep_stuck_picture(job, out);
    throw;
  }
  out.keep();
  say(job, options.quiet);
  std::printf("%s; files in %s\n", verdict(job).c_str(), out.folder().string().c_str());
  return exit_code(job);
}

}  // namespace toile
