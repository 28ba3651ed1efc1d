#pragma once
// All pieces of a pattern file on one picture.

#include <string>

#include "garment/pattern_file.h"
#include "picture/image.h"

namespace toile {

// Pieces side by side at one scale, the tallest first, with a bar of 10 cm: sew line with its corners, notches inwards, grain
// line, internal lines, cut-outs and drill holes, names with copies and mm. With `all_sizes` the other sizes of a graded file
// lie thin behind. 1200 pixels wide, as high as it takes.
Image contact_sheet(const PatternFile& file, const std::string& title, bool all_sizes);

}  // namespace toile
