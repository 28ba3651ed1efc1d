#pragma once
// What a pattern file holds: the pattern of one size, what the file says about itself, and the other sizes it is graded to.

#include <string>
#include <vector>

#include "garment/drape.h"
#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

// What a file says of one piece that the piece itself does not.
struct PieceFacts {
  std::string piece;            // its name in the pattern
  bool has_sew_line = false;    // drawn in the file, or what the file draws is the sew line
  std::string sew_line_source;  // where the outline came from: "layer 14", "cut line", "cut line less 10 mm", "data-role", ...
  bool unfolded = false;        // drawn as a half on a fold
  int graded_points = 0;        // outline points with a grade rule
  bool operator==(const PieceFacts&) const = default;
};

struct FileUnits {
  std::string name;  // "mm", "cm", "m", "inch", "px"
  double in_metres = 0;
  std::string decided_by;  // "override", "text", "$INSUNITS", "$MEASUREMENT", "plausibility", "format"
  bool operator==(const FileUnits&) const = default;
};

// A garment that came already draped (OBJ with vt): its own mesh and positions.
struct DrapedGarment {
  GarmentMesh garment;
  Eigen::Matrix3Xd positions;  // m, one column per garment vertex
};

struct PatternFile {
  std::string format;   // "DXF", "SVG", "GarmentCode", "OBJ"
  std::string dialect;  // "AAMA", "ASTM", "Valentina", ...
  std::string author;   // the program that wrote it, as the file says
  FileUnits units;
  Pattern pattern;                   // of the size asked for, else the sample size
  std::vector<std::string> sizes;    // all the file holds, in its order, the sample size among them; empty: it names none
  std::string sample_size;           // the one of `sizes` the others are graded from; pattern.sample_size says which it is
  std::string graded_by;             // "nest", "rules", or empty
  std::vector<Pattern> graded;       // one for each of `sizes`, with the same pieces, edges and points; empty without grading
  std::vector<PieceFacts> facts;     // one for each piece of `pattern`
  std::vector<DrapedGarment> drape;  // one, or none
};

}  // namespace toile
