#include "drape/side_by_side.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr int most_pushes = 2000;

double reach_at(const std::vector<double>& reach, std::size_t row) { return row < reach.size() ? reach[row] : 0; }

}  // namespace

void give_room(std::vector<RolledPanel>& panels, double gap, std::vector<double>& radii) {
  if (panels.empty()) return;
  for (std::size_t row = 0; row < radii.size(); ++row) {
    double round = 0;
    for (const RolledPanel& panel : panels)
      if (row < panel.left.size()) round += panel.left[row] + panel.right[row] + gap;
    radii[row] = std::max(radii[row], round / turn);
  }
  const std::size_t count = panels.size();
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  const auto place = [&](std::size_t i) { return panels[i].angle - turn * std::floor(panels[i].angle / turn); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
  // From the middle of each to the middle of the next, all the way round.
  std::vector<double> needed(count, 0.0);
  double total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const RolledPanel& one = panels[order[i]];
    const RolledPanel& next = panels[order[(i + 1) % count]];
    for (std::size_t row = 0; row < radii.size(); ++row) {
      if (row >= one.right.size() || row >= next.left.size()) continue;
      needed[i] = std::max(needed[i], (reach_at(one.right, row) + reach_at(next.left, row) + gap) / radii[row]);
    }
    total += needed[i];
  }
  if (total > turn) {
    for (double& radius : radii) radius *= total / turn;
    for (double& room : needed) room *= turn / total;
  }
  if (count == 1) return;
  std::vector<double> at;
  for (const std::size_t i : order) at.push_back(place(i));
  for (int push = 0; push < most_pushes; ++push) {
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      const double lack = needed[i] - (at[next] + (next == 0 ? turn : 0) - at[i]);
      most = std::max(most, lack);
      if (lack <= 0) continue;
      at[i] -= lack / 2;
      at[next] += lack / 2;
    }
    if (most < 1e-6) break;
  }
  for (std::size_t i = 0; i < count; ++i) panels[order[i]].angle = at[i];
}

}  // namespace toile
