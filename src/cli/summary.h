#pragma once

#include <string>
#include <vector>

#include "cli/job.h"

namespace toile {

// summary.json, schema 1: metres and seconds where the key says nothing, else mm or percent of the mannequin's height.
std::string summary_json(const Job& job, const std::vector<std::string>& files);

// What a pattern maker wants to know, in one line.
std::string verdict(const Job& job);

}  // namespace toile
