#include "pairing/symmetry.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

std::size_t u(int i) { return static_cast<std::size_t>(i); }

std::vector<int> walk(const PanelEdges& all, int panel) {
  std::vector<int> edges;
  const int first = all.panels[u(panel)].first;
  int edge = first;
  do {
    edges.push_back(edge);
    edge = all.edges[u(edge)].next;
  } while (edge != first);
  return edges;
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-3 + 2e-3 * std::max(a, b); }

bool alike(const PanelEdge& a, const PanelEdge& b, bool mirrored) {
  if (!near(a.length, b.length)) return false;
  const std::size_t n = a.heading.size();
  for (std::size_t k = 0; k < n; ++k)
    if (std::abs(mirrored ? a.heading[k] + b.heading[n - 1 - k] : a.heading[k] - b.heading[k]) > .06) return false;
  // The grain is kept: reflected left to right.
  const Eigen::Vector2d image = mirrored ? Eigen::Vector2d(b.along.x(), -b.along.y()) : b.along;
  return a.along.dot(image) > .98;
}

// Shift by which the edges of b, walked backwards when mirrored, agree with those of a; -1: none.
int shift_of(const PanelEdges& all, const std::vector<int>& a, const std::vector<int>& b, bool mirrored) {
  if (a.size() != b.size()) return -1;
  const int n = static_cast<int>(a.size());
  for (int shift = 0; shift < n; ++shift) {
    bool good = true;
    for (int k = 0; good && k < n; ++k) {
      const int other = mirrored ? (shift - k + 2 * n) % n : (shift + k) % n;
      good = alike(all.edges[u(a[u(k)])], all.edges[u(b[u(other)])], mirrored);
    }
    if (good) return shift;
  }
  return -1;
}

}  // namespace

int same_outline(const PanelEdges& all, int a, int b) {
  const auto edges_b = walk(all, b);
  const int shift = shift_of(all, walk(all, a), edges_b, false);
  return shift < 0 ? -1 : edges_b[u(shift)];
}

std::vector<int> mirror_images(const PanelEdges& all, const std::vector<PieceName>& names) {
  const int count = static_cast<int>(all.panels.size());
  std::vector<int> image(all.edges.size(), -1), partner(u(count), -1);
  const auto name = [&](int panel) -> const PieceName& { return names[u(all.panels[u(panel)].piece)]; };
  const auto pair = [&](int a, int b) {
    const auto ea = walk(all, a), eb = walk(all, b);
    const int shift = shift_of(all, ea, eb, true);
    if (shift < 0) return false;
    const int n = static_cast<int>(ea.size());
    for (int k = 0; k < n; ++k) {
      const int other = eb[u((shift - k + 2 * n) % n)];
      image[u(ea[u(k)])] = other;
      image[u(other)] = ea[u(k)];
    }
    partner[u(a)] = b;
    partner[u(b)] = a;
    return true;
  };
  const auto fits = [&](int a, int b) { return shift_of(all, walk(all, a), walk(all, b), true) >= 0; };
  // Named left and right, or cut as a pair.
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count && partner[u(a)] < 0; ++b) {
      if (partner[u(b)] >= 0) continue;
      const bool copies = all.panels[u(a)].piece == all.panels[u(b)].piece;
      const bool hands = !name(a).hand.empty() && !name(b).hand.empty() && name(a).hand != name(b).hand &&
                         name(a).face == name(b).face && name(a).role == name(b).role;
      int twins = 0;
      for (int c = 0; c < count; ++c) twins += c != a && fits(a, c);
      if ((hands || (copies && twins == 1)) && fits(a, b)) pair(a, b);
    }
  for (int a = 0; a < count; ++a) {
    if (partner[u(a)] >= 0) continue;
    std::vector<int> twins;
    for (int c = 0; c < count; ++c)
      if (c != a && partner[u(c)] < 0 && fits(a, c)) twins.push_back(c);
    if (fits(a, a)) {
      if (twins.size() <= 1 && name(a).hand.empty()) pair(a, a);
    } else if (twins.size() == 1) {
      pair(a, twins.front());
    }
  }
  return image;
}

}  // namespace toile
