#pragma once
// Small patterns and their meshes, made by hand: four-sided pieces as grids.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

using Line = std::vector<Eigen::Vector2d>;

// An edge through `points`, whose ends are turn points.
Edge edge(const std::string& id, const Line& points);

// Points of a parabola from a to b that bulges `rise` (m) to the right of its chord.
Line bulge(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double rise, int segments = 24);

// How a piece is gridded: its four sides (bottom, right, top, left) as runs of edges, and the number of mesh edges along each
// edge.
struct Grid {
  std::array<std::vector<int>, 4> sides{{{0}, {1}, {2}, {3}}};
  std::vector<int> divisions{8, 12, 8, 12};
};

struct HandMade {
  Pattern pattern;
  std::vector<Grid> grids;  // by piece
  GarmentMesh garment;
};

// Meshes all copies of all pieces and welds them along the seams.
void mesh(HandMade& made);

// Eight gores, one piece: curved hem, straight sides (or sides that bulge by `hip`), and a waistband sewn to all of them by
// eighths.
HandMade gored_skirt(double hip = 0);

// As GarmentCode writes it: four gores as pieces of their own, the last with a turn point within its waist edge, and two
// waistbands whose lower edges are divided to meet them.
HandMade gores_one_by_one();

// A front cut twice, once mirrored, with a deep armhole and a bent side, sewn to a back cut once along both sides, with ease.
HandMade curved_bodice(double ease = 1.02);

// Every panel's rest shape mapped in the frame of its piece (mirrored copies reflected there and back).
RestShape mapped(const GarmentMesh& garment, const std::function<Eigen::Vector2d(int panel, const Eigen::Vector2d&)>& map);

// Moves boundary vertices by up to `size` (m), other ones by as much as their neighbours at most; the same on every call.
RestShape shaken(const GarmentMesh& garment, double size, unsigned seed = 1);

}  // namespace toile
