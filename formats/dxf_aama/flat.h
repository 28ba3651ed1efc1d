#pragma once
// Flat drawings: no block is a piece, everything lies in one plane. Markers, Valentina's flat DXF, drawing programs.

#include <string>
#include <vector>

#include "formats/dxf/drawing.h"
#include "garment/report.h"

namespace toile::aama {

// The pieces of a flat drawing as blocks with their outlines on layer 1: closed lines that lie in no other, of at least 4 % of
// the largest one's size; a rectangle round all of it is the sheet. What lies inside goes with the piece: lines (joined where
// they meet) to layer 8 unless their layer has a meaning, texts to layer 1, the first without a key as the piece's name. Only
// lines on the best of these layers are taken for outlines: 1 or 84; 14 or 87; those without a meaning.
// Findings: warning "aama.flat-drawing"; notes "aama.lettering" (closed lines too small to be of the cut), "aama.sheet-frame"
// and "aama.outside-pieces". No block when there is no closed line. Error "dxf.too-large" beyond 20000 lines.
std::vector<dxf::Block> pieces_by_containment(const std::vector<dxf::Entity>& entities, const std::string& file,
                                              Report& report);

}  // namespace toile::aama
