#pragma once
// The net line of a piece whose cut line alone is drawn, when its allowance is known.

#include <optional>

#include "formats/svg_read/grouping.h"

namespace toile::svg {

// `cut`, counter-clockwise, moved inwards by `width` metres: edges parallel, corners where they meet. Nothing when the result
// crosses itself or is nowhere as far from `cut` as it should be.
std::optional<Ring> inset(const Ring& cut, double width);

}  // namespace toile::svg
