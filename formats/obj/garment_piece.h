#pragma once
// An island as a pattern piece and as a panel of the garment.

#include <optional>
#include <string>

#include "formats/obj/islands.h"
#include "garment/mesh.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

struct IslandPiece {
  Piece piece;      // corners found by angle; straight edges of two points; holes as cut-outs
  PanelMesh panel;  // of the first copy; `piece` is left 0
};

// Of an island laid out in metres. Error "obj.overlapping-island" when its outline crosses itself; note "obj.hole".
std::optional<IslandPiece> island_piece(const Island& island, const std::string& place, Report& report);

// The boundary of a mirrored copy of `panel` whose outline runs the other way round.
std::vector<BoundaryVertex> mirrored_boundary(const std::vector<BoundaryVertex>& boundary);

}  // namespace toile
