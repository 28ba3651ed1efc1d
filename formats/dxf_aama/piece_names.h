#pragma once

#include <string>
#include <vector>

#include "garment/cut_sheet.h"

namespace toile::aama {

struct NamedPiece {
  const CutPiece* piece;
  std::string name;  // ASCII, each once within a size
};

// The pieces of `sheet` under the names a DXF of it has. A piece placed twice is one piece; one piece in several sizes is a
// nest, whose blocks share the piece's name.
std::vector<NamedPiece> named_pieces(const CutSheet& sheet);

// `wanted`, or with "-2", "-3", ... the first that is not taken, no longer than `longest`; from then on it is taken.
std::string unique_name(const std::string& wanted, std::vector<std::string>& taken, std::size_t longest);

}  // namespace toile::aama
