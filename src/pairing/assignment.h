#pragma once
// All seams of a garment chosen together: the best total of what every pair says and of how the whole comes together.

#include <optional>
#include <vector>

#include "pairing/sewn.h"

namespace toile {

struct Problem {
  const PanelEdges* all = nullptr;
  std::vector<std::vector<double>> pair;  // symmetric; `impossible` or below: never
  std::vector<std::vector<int>> once;     // which kind of seam that two panels have along one line only; -1: none
  std::vector<int> image;                 // mirror images, -1: none
  std::vector<int> openings;
};

struct Assignment {
  Mates mates;
  double score = 0;
};

double score(const Problem& problem, const Mates& mates);

// Simulated annealing by seams, runs of neighbouring seams and their mirror images, `rounds` times from `start` (default:
// nothing sewn), always with the same dice; the best is then climbed from.
Assignment assign(const Problem& problem, int rounds, const Mates& start = {});

// By edge that is sewn: how much the best garment without that seam scores below `found`; 0 for open edges.
std::vector<double> margins(const Problem& problem, const Assignment& found);

}  // namespace toile
