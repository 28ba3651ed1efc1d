#pragma once
// A pattern in several sizes as DXF: all sizes drawn (a nest), or one size with the rules that grade it to the others.

#include <string>

#include "cut/cut.h"
#include "garment/pattern_file.h"

namespace toile {

struct GradedFiles {
  std::string nest;  // every size of every piece in a block of its own, the sample size first
  std::string base;  // the sample size, its points with the numbers of rules
  std::string rules;
};

// The sizes of `graded` as DXF (AAMA) and rule table named `name`, allowances and page by `rules`. The sizes must have the same
// pieces, edges and points, and pattern.sample_size be one of them: throws std::invalid_argument. Throws BadInput "cut.*".
GradedFiles graded_files(const PatternFile& graded, const std::string& name, const SheetRules& rules);

// Throws BadInput "export.changed" unless `read`, the file read back from the bytes of `graded`, has every size of every piece:
// outlines within 0.05 mm, the same corners, as many notches. `file` is what the finding names.
void check_graded(const PatternFile& graded, const PatternFile& read, const std::string& file);

}  // namespace toile
