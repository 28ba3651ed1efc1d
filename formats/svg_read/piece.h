#pragma once
// The parts of one piece as a piece of the pattern.

#include <optional>

#include "formats/svg_read/grouping.h"
#include "formats/svg_read/label.h"
#include "garment/pattern_file.h"

namespace toile::svg {

struct ReadPiece {
  Piece piece;
  PieceFacts facts;
};

// `roles` of the drawing's lines; `name` of the file; `everywhere`: what texts outside the pieces say of the allowance.
// Nothing, with an error, when there is no outline.
std::optional<ReadPiece> read_piece(const Drawing& drawing, std::vector<Role> roles, const PieceParts& parts,
                                    const Label& label, const std::string& piece_name, const Producer& producer,
                                    const std::optional<AllowanceText>& everywhere, const std::string& name, Report& report);

}  // namespace toile::svg
