#pragma once
// Which blocks of a file are pieces, and which of them are of the sample size.

#include <string>
#include <vector>

#include "formats/dxf/drawing.h"
#include "formats/dxf_aama/texts.h"
#include "garment/report.h"

namespace toile::aama {

struct PieceBlock {
  const dxf::Block* block = nullptr;
  std::string name;  // unique: the text "Piece Name", else the block's name
  PieceTexts texts;
};

// Blocks with an outline (layers 1, 14, 84, 87), one per piece name, in file order: of several sizes the sample size, else the
// one with the most turn points and notches. Findings: note "aama.sizes-ignored", warning "aama.sample-size", warning
// "aama.piece-renamed" (unnamed pieces whose blocks have one name), errors "aama.duplicate-piece" and "aama.no-piece".
std::vector<PieceBlock> sample_size_blocks(const dxf::Drawing& drawing, const StyleTexts& style, const std::string& file,
                                           Report& report);

}  // namespace toile::aama
