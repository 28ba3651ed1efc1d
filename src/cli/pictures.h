#pragma once
// The pictures of a run or of a drape.

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

struct ShownPictures {
  std::vector<Picture> views;
  std::vector<Picture> maps;  // of stretch, ease and pressure
};

// Of a run: source, target, re-drape with its distance to the target, flattening beside it on the same scale, outlines; maps of
// the re-drape.
ShownPictures write_run_pictures(const Job& job, const OutputFolder& out);
// Of edits alone: source and target.
ShownPictures write_edit_pictures(const Job& job, const OutputFolder& out);
// Of the source drape alone.
ShownPictures write_drape_pictures(const Job& job, const OutputFolder& out);

}  // namespace toile
