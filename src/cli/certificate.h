#pragma once
// What every file that leaves a run says of it: how near the re-drape came to the target, and from what it was made.

#include <string>
#include <vector>

#include "cli/job.h"

namespace toile {

// Lines for sheet, DXF and report, after prove(); without times, so that the same run says the same.
std::vector<std::string> certificate(const Job& job);

// "Made by toile 0.1.0 from a.dxf (SHA-256 1f0c93ab52e4), ...", in lines of at most 200 characters.
std::vector<std::string> made_from(const Job& job);

}  // namespace toile
