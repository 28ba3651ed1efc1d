#pragma once
// Which convention a DXF follows, and how that shows.

#include <string>
#include <vector>

#include "formats/dxf/drawing.h"
#include "formats/dxf_aama/texts.h"

namespace toile::aama {

struct Dialect {
  std::string name;  // "AAMA", "ASTM", "AutoCAD drawing"
  std::string because;
};

// By the texts; else by the layers of `blocks`, the pieces: 80 to 87 are ASTM's. `flat`: the pieces were found by containment.
Dialect dialect_of(const StyleTexts& style, const std::vector<dxf::Block>& blocks, bool flat);

}  // namespace toile::aama
