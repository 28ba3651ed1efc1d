#pragma once
// Room for the panels that go round one part of the body.

#include <cstddef>
#include <vector>

namespace toile {

// A panel rolled round an axis: how far it reaches to both sides of its middle, m, by row below the top.
struct RolledPanel {
  double angle = 0;  // of its middle, radians, growing to its right
  std::vector<double> left, right;
};

// Turns the panels no farther than is needed, and widens the circles (`radii`, m, by row, as many as the longest panel has)
// where they are too narrow for all of them, so that neighbours are `gap` (m) apart in every row. Panels keep their order.
void give_room(std::vector<RolledPanel>& panels, double gap, std::vector<double>& radii);

}  // namespace toile
