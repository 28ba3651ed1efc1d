#pragma once
// What every simulator's result goes through, whoever made it: penetration, inverted triangles, slip. None is silent.

#include "drape/simulator.h"

namespace toile {

// Fills max_penetration, slipped and inverted_triangles of `drape`. Throws std::runtime_error when the positions are not finite
// or of the wrong number: a simulator that gives that back has failed.
void measure_guards(const DrapeRequest& request, Drape& drape);

// m, deepest point inside the body over vertices, edge midpoints and triangle centres; 0 when all are outside.
double max_penetration(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Body& body);

// Triangles turned over against their neighbours: more than 150 degrees from the mean normal of the triangles around.
int inverted_triangles(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions);

}  // namespace toile
