#pragma once
// Lines across triangles as cuts across panels.

#include <map>
#include <utility>
#include <vector>

#include "edit/mix/parting.h"
#include "garment/welds.h"

namespace toile {

// Where a panel's boundary edges lie on the outline of its piece.
class BoundaryPlaces {
 public:
  explicit BoundaryPlaces(const GarmentMesh& garment);
  // Between panel vertices `from` and `to`, `at` of the way; absent when they are not neighbours on the panel's boundary.
  std::optional<OutlinePlace> find(int panel, int from, int to, double at) const;

 private:
  std::vector<std::map<std::pair<int, int>, std::pair<OutlinePlace, double>>> edges_;  // [panel]: begin, and `at` at the end
};

struct PanelChord {
  int panel = 0;
  Chord chord;
};

// In the order of the line. Throws BadInput edit.cut-inside-panel when the line crosses no seam.
std::vector<PanelChord> chords_of(const GarmentMesh& garment, const BoundaryPlaces& places, const CutLine& line, int loop,
                                  const std::string& place);

}  // namespace toile
