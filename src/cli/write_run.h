#pragma once
// The files of a run: everything from the edit on, made and written.

#include <chrono>
#include <string>

#include "cli/job.h"
#include "cli/output_folder.h"

namespace toile {

// File name of the pattern, without extension: the recipe's, kept to what every CAD can open.
std::string file_stem(const std::filesystem::path& recipe);

// Adjusts the target of `job`, proves the result and writes every file of a run to `out`, which is not kept yet. `recipe_text`
// is shown in the report; `began`: when the job did. Throws BadInput.
void finish_run(Job& job, const OutputFolder& out, const std::string& recipe_text, std::chrono::steady_clock::time_point began,
                Progress& progress);

// Findings on standard error: all of them, or errors alone when `quiet`.
void say(const Job& job, bool quiet);

}  // namespace toile
