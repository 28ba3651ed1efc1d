#pragma once
// The sides of a piece as its outline is fitted: between corners that may move, straight lines and curves.

#include <Eigen/Core>
#include <vector>

#include "garment/pattern.h"

namespace toile {

// A straight line, maybe of several edges in line, or a curved edge; one that turns back on itself is cut into several.
struct Run {
  struct Part {
    int edge = 0;                         // index into Piece::outline
    double edge_begin = 0, edge_end = 1;  // the fractions of that edge ...
    double begin = 0, end = 1;            // ... which lie at these fractions of the run
  };
  bool straight = true;
  double length = 0;  // m
  std::vector<Part> parts;
  std::vector<double> at;              // curves: fractions of the run's length, 0 .. 1
  std::vector<Eigen::Vector2d> shape;  // curves: the points there, in the frame of the chord: (0, 0) .. (1, 0)
};

struct Sides {
  std::vector<Eigen::Vector2d> corners;  // corners[i] starts runs[i]
  std::vector<Run> runs;
};

Sides sides_of(const Piece& piece);

// The chord-frame point of a curve at fraction `t`.
Eigen::Vector2d shape_at(const Run& run, double t);

// a * b as complex numbers: the chord-frame point `a` on the chord `b`.
inline Eigen::Vector2d on_chord(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return {a.x() * b.x() - a.y() * b.y(), a.x() * b.y() + a.y() * b.x()};
}

}  // namespace toile
