#pragma once
// One entity out of the tags that describe it.

#include <span>
#include <string>

#include "formats/dxf/drawing.h"
#include "formats/dxf/tags.h"

namespace toile::dxf {

// `tags` begins with the 0 tag. A POLYLINE comes without its vertices, which follow as entities of their own (type "VERTEX",
// one point, one bulge). Errors "dxf.not-a-number" and "dxf.incomplete-entity" go to `report`.
Entity read_entity(std::span<const Tag> tags, const std::string& name, Report& report);

// Mirrored in the y axis, as what is drawn with the extrusion (0, 0, -1).
void mirror(Entity& entity);

}  // namespace toile::dxf
