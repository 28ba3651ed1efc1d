#pragma once
// ARC, CIRCLE, ELLIPSE and SPLINE.

#include <span>
#include <string>

#include "formats/dxf/drawing.h"
#include "formats/dxf/tags.h"

namespace toile::dxf {

bool is_curve(std::string_view type);

// Fills `entity`, whose type is_curve, from its tags; what cannot be drawn (knots that do not fit the points, no radius)
// becomes Kind::other. Error "dxf.not-a-number".
void read_curve(std::span<const Tag> tags, Entity& entity, const std::string& name, Report& report);

}  // namespace toile::dxf
