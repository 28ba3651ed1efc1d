#pragma once
// In which unit a pattern file is drawn. Files often do not say, and "METRIC" has been seen to mean mm and cm.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formats/dxf_aama/drawn_piece.h"
#include "formats/dxf_aama/texts.h"
#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile::aama {

// What the file gives away about its unit, in file units.
struct UnitEvidence {
  StyleTexts style;
  std::map<std::string, std::string> header;
  double largest = 0;                // the largest piece's longer side
  std::vector<double> notch_depths;  // those given, > 0
  std::vector<double> allowances;    // distance of the boxes round cut and sew line, > 0
};

// What the sizes of a piece, sorted in file units, say.
void add_evidence(UnitEvidence& evidence, const DrawnPiece& piece);

// Metres per file unit. In this order: `override_unit`; the text "Units"; $INSUNITS; $MEASUREMENT = 1; size alone. A statement
// is believed when the largest piece is then 150 mm .. 2.5 m and notches (1 .. 15 mm) and allowances (2 .. 80 mm) are too;
// METRIC means mm, else cm, else m, the first that fits. The decision is the finding "aama.units" (a warning where METRIC is
// not mm); when nothing or more than one unit fits (of several inches where $MEASUREMENT = 0), the error "aama.units-ambiguous"
// (Fault::ambiguous) asks.
std::optional<FileUnits> decide_unit(const UnitEvidence& evidence, std::optional<double> override_unit, const std::string& name,
                                     Report& report);

}  // namespace toile::aama
