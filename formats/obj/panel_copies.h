#pragma once
// Islands that are copies of one piece.

#include <string>
#include <vector>

#include "formats/obj/islands.h"

namespace toile {

struct PanelCopies {
  std::string name;
  std::vector<int> islands;  // as drawn, then mirrored about the y axis
  int mirrored = 0;          // how many of them are
};

// Islands "NAME:1", "NAME:2", ... of the same vertices and triangles, as write_obj writes a piece that is cut several times,
// are one piece; every other island is a piece of its own, also one that another is like: front and back are.
std::vector<PanelCopies> panel_copies(const std::vector<Island>& islands);

}  // namespace toile
