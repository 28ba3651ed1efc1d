#pragma once
// How large a draped garment in an OBJ is: the unit of its vertices, and how much cloth one unit of its texture is.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "formats/obj/islands.h"
#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile {

// m, cm or mm: that in which the garment is .3 to 3 m large. Errors "obj.units" (ambiguous) when there is none. A note
// "obj.units" says what was taken; a warning "obj.not-upright" when it seems to stand on another axis than Y.
std::optional<FileUnits> garment_units(const Eigen::Matrix3Xd& positions, std::optional<double> unit_in_metres,
                                       const std::string& place, Report& report);

// Lays the islands out in metres: `flat` times the median of the lengths of its edges in 3D and in the texture. That is taken
// as m, cm, mm or inch where it is within 3 % of one, because cloth stretches and textures fitted to a square are none of them.
// Notes and warnings: "obj.vt-scale", "obj.uneven-texture" (u and v of different scale), "obj.island-scale" (an island of its
// own), "obj.stretched" (8 % and more); error "obj.not-flat" when an island is no flat of its 3D shape (25 %). `positions`: m,
// by vertex of the file.
void lay_flat(std::vector<Island>& islands, const Eigen::Matrix3Xd& positions, const std::string& place, Report& report);

}  // namespace toile
