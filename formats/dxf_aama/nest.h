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

// The blocks of one piece: one for each size the file draws it in.
struct PieceGroup {
  std::string name;
  std::vector<PieceBlock> sizes;  // in file order
  std::size_t sample = 0;
  const PieceBlock& sample_block() const { return sizes[sample]; }
};

// Whether the block is a piece: it has lines on layer 1, 14, 84 or 87. Layout blocks have none.
bool has_outline(const dxf::Block& block);

// The pieces among `blocks`, in file order. A block without a text "Size" is of the size that follows the piece's name in the
// block's, if that is all they differ in. The sample size is the style's, else that with the most turn points and notches.
// Warnings "aama.sample-size" and "aama.piece-renamed" (pieces of one name, and unnamed ones in blocks of one name, are
// numbered).
std::vector<PieceGroup> piece_groups(const std::vector<dxf::Block>& blocks, const StyleTexts& style, const std::string& file,
                                     Report& report);

// Every size of the groups, in file order.
std::vector<std::string> sizes_of(const std::vector<PieceGroup>& groups);

}  // namespace toile::aama
