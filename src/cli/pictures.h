#pragma once
// The pictures of a run.

#include <string>
#include <vector>

#include "cli/job.h"
#include "cli/output_folder.h"

namespace toile {

struct Picture {
  std::string file;  // in the output folder
  std::string caption;
  std::string png;  // its bytes
};

// Draws and writes source, target, re-drape with its distance to the target, flattening beside it on the same scale, outlines.
std::vector<Picture> write_pictures(const Job& job, const OutputFolder& out);

}  // namespace toile
