#pragma once
// Which boundary vertices of which panels meet along the seams.

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

// The boundary of a panel as far as sewing is concerned; `vertex` is any number the caller likes,
// unique in its panel.
struct PanelLoop {
  int piece = 0;
  int copy = 1;
  std::vector<BoundaryVertex> vertices;
};

// Vertices that meet along a seam, in order from the start of the seam.
struct Mating {
  int seam = 0;
  int panel_a = 0, panel_b = 0;
  std::vector<int> a, b;  // BoundaryVertex::vertex
};

std::vector<PanelLoop> panel_loops(const std::vector<PanelMesh>& panels);

// One per seam. Throws std::invalid_argument when a panel is missing or the two sides have different numbers of vertices.
std::vector<Mating> matings(const Pattern& pattern, const std::vector<PanelLoop>& panels);

// For each of `count` vertices, numbered through all panels, the smallest one it is welded to; `first[p]` is added to the
// vertices of panel p.
std::vector<int> welded_to(const std::vector<Mating>& matings, const std::vector<int>& first, int count);

// Sides of panels, each from its smaller to its larger vertex as `welded_to` numbers them, that a seam joins, both ways round.
using MatedSides = std::set<std::array<int, 4>>;
MatedSides mated_sides(const std::vector<Mating>& matings, const std::vector<int>& first);

// A side of a panel's boundary, numbered likewise, and which panel edge it is on.
struct WeldedSide {
  int from = 0, to = 0, panel = 0, edge = 0;
};

// Whether sides that meet are meant to, however many they are: seams lead from one to every other, and two on one edge are sewn
// to each other, as where it is folded.
bool sewn_together(const std::vector<WeldedSide>& sides, const MatedSides& mates);

}  // namespace toile
