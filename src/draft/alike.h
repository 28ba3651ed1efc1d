#pragma once
// Which pieces of a pattern are drawn alike, and which are symmetric in themselves.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "draft/runs.h"
#include "garment/pattern.h"

namespace toile {

// x -> turn * x + shift; a reflection when det(turn) < 0.
struct Isometry {
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  Eigen::Vector2d operator()(const Eigen::Vector2d& x) const { return turn * x + shift; }
  Isometry inverse() const { return {turn.transpose(), -(turn.transpose() * shift)}; }
  Isometry after(const Isometry& first) const { return {turn * first.turn, turn * first.shift + shift}; }
};

// How a piece lies on the shape it shares with others. Run i of the piece is run `shift + i` of the shape or, reversed,
// `shift - i` run backwards (modulo their number).
struct Lay {
  int shape = 0;
  Isometry to_shape;  // from the piece's frame
  int offset = 0;
  bool reversed = false;
};

int run_of(const Lay& lay, int run, int count);

// What one or more congruent pieces share. With `mirror`, run i is the reflection x -> -x of run `mirror - i` run backwards, so
// the frame of the shape has its y axis on the axis of symmetry; corners and curves are then exactly symmetric.
struct SharedShape {
  Sides sides;  // in the frame of the shape
  std::vector<int> pieces;
  std::optional<int> mirror;
};

struct Likeness {
  std::vector<SharedShape> shapes;
  std::vector<Lay> lays;  // by piece
};

// Pieces count as alike when their outlines (turn points on a straight line aside) coincide within `tolerance` (m) after a
// motion or a reflection that keeps the line of the grain, and the same sides are sewn; symmetric in themselves when a
// reflection about the grain does that, or one across the grain whose sides are sewn to the same pieces. Tolerance 0: none is.
Likeness find_likeness(const Pattern& pattern, double tolerance);

// The piece alone again.
SharedShape on_its_own(const Piece& piece, int index);

}  // namespace toile
