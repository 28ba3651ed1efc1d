#pragma once

#include "garment/pattern.h"

namespace toile::svg {

// Whether the outline is its own mirror image (within 2 mm) about a line along or across its grain.
bool is_symmetric(const Piece& piece);

}  // namespace toile::svg
