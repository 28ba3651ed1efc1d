#pragma once

#include "formats/svg_read/grouping.h"
#include "formats/svg_read/label.h"

namespace toile::svg {

// When no line of the piece is known as its grain line: the longest straight line inside that has arrow heads or a text about
// the grain beside it gets Role::grain.
void find_grain(const Drawing& drawing, const PieceParts& parts, const Label& label, std::vector<Role>& roles);

}  // namespace toile::svg
