#pragma once
// What each line of a drawing is, as far as data attributes, classes, markers and names of elements, groups and layers tell.

#include <vector>

#include "formats/svg_read/drawing.h"
#include "formats/svg_read/page.h"
#include "formats/svg_read/words.h"

namespace toile::svg {

// One for each line of the drawing.
std::vector<Role> line_roles(const Drawing& drawing, const Producer& producer);

// The group that holds one piece, by its data-type or FreeSewing's id, round `group`; -1: none.
int piece_group(const Drawing& drawing, int group, const Producer& producer);

}  // namespace toile::svg
