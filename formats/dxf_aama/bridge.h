#pragma once
// A sew line drawn seam by seam, with nothing where the piece is cut net.

#include <optional>
#include <vector>

#include "formats/dxf_aama/chains.h"

namespace toile::aama {

// The open `parts` joined along the closed line `cut`, when the ends of every part lie on it (within closing_gap) and the parts
// do not overlap; in the direction of `cut`, beginning with the first part. Nothing otherwise.
std::optional<Points<2>> bridged(const std::vector<Chain>& parts, const Points<2>& cut);

}  // namespace toile::aama
