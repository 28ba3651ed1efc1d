#pragma once
// What a run has to say for itself: one line, the report for people, the summary for programs.

#include <string>
#include <vector>

#include "cli/job.h"
#include "cli/pictures.h"
#include "formats/html/report.h"
#include "formats/summary/summary.h"

namespace toile {

// What a pattern maker wants to know, in one line.
std::string verdict(const Job& job);

// What every verb says that drapes: all up to the source drape, the findings and the files. Not the verdict.
RunSummary summary_of_drape(const Job& job, const std::vector<std::string>& files);
RunSummary summary_of(const Job& job, const std::vector<std::string>& files);
// Likewise.
RunReport report_of_drape(const Job& job, const ShownPictures& pictures, const std::vector<std::string>& files);
RunReport report_of(const Job& job, const std::string& recipe_text, const ShownPictures& pictures,
                    const std::vector<std::string>& files);

}  // namespace toile
