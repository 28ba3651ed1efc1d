#pragma once
// What the pieces of an OBJ are called.

#include <string>
#include <vector>

#include "formats/obj/line_check.h"

namespace toile {

// By island, each once: the group of most of its faces, else object, else material - of the first of these that tells all
// islands apart, else of the first there is, numbered "-2", "-3", ...; "piece 1", ... where the file names nothing.
// `members`: triangles by island; `face`: by triangle.
std::vector<std::string> island_names(const std::vector<std::vector<int>>& members, const std::vector<int>& face,
                                      const ObjLines& lines);

}  // namespace toile
