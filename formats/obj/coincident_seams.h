#pragma once
// Seams where the outlines of a draped garment's pieces lie on one another.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "garment/mesh.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

// One number for each place of `positions` (m): vertices that `where` lists and that lie within `near` of one another share
// one. Numbers go up from 0 in the order of the vertices.
std::vector<int> joined_where_near(const Eigen::Matrix3Xd& positions, const std::vector<int>& where, double near);

// Runs of boundary along which `garment` is welded, as seams of `pattern`: each once, as long as it goes on along one edge on
// either side, right to right as the faces show it. A warning "obj.three-layers" names pieces of which more than two meet along
// a seam; only the first two are sewn there.
std::vector<Seam> welded_seams_of(const GarmentMesh& garment, const Pattern& pattern, const std::string& place, Report& report);

}  // namespace toile
