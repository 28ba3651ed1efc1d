#pragma once
// Closed lines out of the runs a file draws them in.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "formats/dxf_aama/drawn_piece.h"

namespace toile::aama {

constexpr double closing_gap = 0.5e-3;  // m, runs nearer than this are meant to join
constexpr double same_vertex = 5e-6;    // m, consecutive vertices nearer than this are one

// Runs joined end to end. A closed chain does not repeat its first point.
struct Chain {
  Points<2> points;
  bool closed = false;
  int line = 0;    // of the file, of its first run
  double gap = 0;  // m, of an open chain: from its end to the nearest end it could go on to
  Eigen::Vector2d gap_from = Eigen::Vector2d::Zero();
  Eigen::Vector2d gap_to = Eigen::Vector2d::Zero();
  int gap_line = 0;  // of the run at `gap_from`
};

// Every run used once; in file order and file direction as far as they join that way. Runs without length are dropped.
std::vector<Chain> chains(const std::vector<Run>& runs);

double signed_area(const Points<2>& ring);                                  // m^2, > 0 counter-clockwise
double distance_to_ring(const Points<2>& ring, const Eigen::Vector2d& at);  // m
Points<2> closed_polyline(Points<2> ring);                                  // with the first point repeated at the end
Points<2> without_repeats(const Points<2>& points, bool closed);            // consecutive vertices that are one

// Where a ring crosses itself, if it does; lines that only touch do not cross.
std::optional<Eigen::Vector2d> crossing(const Points<2>& ring);

}  // namespace toile::aama
