#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "edit/mix/min_cut.h"

namespace toile {
namespace {

double cost_of(const std::vector<int>& sides, const std::vector<CutEdge>& edges) {
  double cost = 0;
  for (const CutEdge& edge : edges)
    if (sides[static_cast<std::size_t>(edge.a)] != sides[static_cast<std::size_t>(edge.b)]) cost += edge.cost;
  return cost;
}

double cheapest(const std::vector<int>& must, const std::vector<CutEdge>& edges) {
  double best = std::numeric_limits<double>::infinity();
  for (unsigned mask = 0; mask < 1u << must.size(); ++mask) {
    std::vector<int> sides;
    bool allowed = true;
    for (std::size_t i = 0; i < must.size(); ++i) {
      sides.push_back((mask >> i) & 1);
      allowed = allowed && (must[i] < 0 || must[i] == sides[i]);
    }
    if (allowed) best = std::min(best, cost_of(sides, edges));
  }
  return best;
}

TEST(MinCut, CutsAChainAtItsCheapestLink) {
  const std::vector<int> sides = min_cut({0, -1, -1, -1, 1}, {{0, 1, 3}, {1, 2, 2}, {3, 2, 1}, {3, 4, 5}});
  EXPECT_EQ(sides, (std::vector<int>{0, 0, 0, 1, 1}));
}

TEST(MinCut, IsAsCheapAsTheBestOfAllCutsOfSmallGraphs) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    const int nodes = 4 + static_cast<int>(random() % 8);
    std::vector<int> must(static_cast<std::size_t>(nodes), -1);
    must.front() = 0;
    must.back() = 1;
    std::vector<CutEdge> edges;
    for (int a = 0; a < nodes; ++a)
      for (int b = a + 1; b < nodes; ++b)
        if (random() % 3 > 0) edges.push_back({a, b, static_cast<double>(random() % 1000) / 100});
    const std::vector<int> sides = min_cut(must, edges);
    EXPECT_EQ(sides.front(), 0);
    EXPECT_EQ(sides.back(), 1);
    EXPECT_NEAR(cost_of(sides, edges), cheapest(must, edges), 1e-3) << "graph " << round;
  }
}

TEST(MinCut, RefusesCostsThatAreNone) {
  EXPECT_THROW(min_cut({0, 1}, {{0, 1, -1}}), std::invalid_argument);
  EXPECT_THROW(min_cut({0, 1}, {{0, 1, std::numeric_limits<double>::quiet_NaN()}}), std::invalid_argument);
}

}  // namespace
}  // namespace toile
