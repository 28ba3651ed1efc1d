#include "triangulate/stitching.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "triangulate/seam_places.h"

namespace toile {
namespace {

// Vertices of the loop from `begin` to `end` of edge `edge`, each end taken by the vertex nearest to it.
std::vector<int> run_of(const PanelLoop& panel, int edge, int edges, double begin, double end) {
  std::vector<std::pair<double, int>> run;
  for (const BoundaryVertex& v : panel.vertices) {
    if (v.edge == edge) run.emplace_back(v.at, v.vertex);
    if (v.at == 0 && v.edge == (edge + 1) % edges) run.emplace_back(1.0, v.vertex);
  }
  std::sort(run.begin(), run.end());
  if (run.size() < 2) throw std::invalid_argument("matings: a panel has no vertices on an edge that is sewn");
  const auto nearest = [&](double at) {
    return std::min_element(run.begin(), run.end(),
                            [&](const auto& x, const auto& y) { return std::abs(x.first - at) < std::abs(y.first - at); }) -
           run.begin();
  };
  const auto low = nearest(std::min(begin, end)), high = nearest(std::max(begin, end));
  std::vector<int> vertices;
  for (auto i = low; i <= high; ++i) vertices.push_back(run[static_cast<std::size_t>(i)].second);
  if (begin > end) std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

}  // namespace

std::vector<PanelLoop> panel_loops(const std::vector<PanelMesh>& panels) {
  std::vector<PanelLoop> loops;
  for (const PanelMesh& panel : panels) loops.push_back({panel.piece, panel.copy, panel.boundary});
  return loops;
}

std::vector<Mating> matings(const Pattern& pattern, const std::vector<PanelLoop>& panels) {
  std::map<std::pair<int, int>, int> panel_of;
  for (std::size_t p = 0; p < panels.size(); ++p) panel_of[{panels[p].piece, panels[p].copy}] = static_cast<int>(p);
  const auto run = [&](const SpanPlace& span, int& panel) {
    const auto found = panel_of.find({span.piece, span.copy});
    if (found == panel_of.end()) throw std::invalid_argument("matings: a copy of a sewn piece has no panel");
    panel = found->second;
    const auto edges = static_cast<int>(pattern.pieces[static_cast<std::size_t>(span.piece)].outline.size());
    return run_of(panels[static_cast<std::size_t>(panel)], span.edge, edges, span.begin, span.end);
  };
  std::vector<Mating> result;
  const std::vector<SeamPlace> places = seam_places(pattern);
  for (std::size_t s = 0; s < places.size(); ++s) {
    Mating mating;
    mating.seam = static_cast<int>(s);
    mating.a = run(places[s].a, mating.panel_a);
    mating.b = run(places[s].b, mating.panel_b);
    if (mating.a.size() != mating.b.size())
      throw std::invalid_argument("matings: the two sides of " + seam_in_words(pattern.seams[s]) +
                                  " have different numbers of vertices");
    result.push_back(std::move(mating));
  }
  return result;
}

std::vector<int> welded_to(const std::vector<Mating>& matings, const std::vector<int>& first, int count) {
  std::vector<int> parent(static_cast<std::size_t>(count));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  for (const Mating& mating : matings)
    for (std::size_t i = 0; i < mating.a.size(); ++i) {
      const int a = root(first[static_cast<std::size_t>(mating.panel_a)] + mating.a[i]);
      const int b = root(first[static_cast<std::size_t>(mating.panel_b)] + mating.b[i]);
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  for (int i = 0; i < count; ++i) parent[static_cast<std::size_t>(i)] = root(i);
  return parent;
}

MatedSides mated_sides(const std::vector<Mating>& matings, const std::vector<int>& first) {
  MatedSides mates;
  const auto side = [&](int panel, const std::vector<int>& run, std::size_t i) {
    const auto ends = std::minmax(run[i - 1], run[i]);
    const int shift = first[static_cast<std::size_t>(panel)];
    return std::pair(shift + ends.first, shift + ends.second);
  };
  for (const Mating& mating : matings)
    for (std::size_t i = 1; i < mating.a.size(); ++i) {
      const auto a = side(mating.panel_a, mating.a, i), b = side(mating.panel_b, mating.b, i);
      mates.insert({a.first, a.second, b.first, b.second});
      mates.insert({b.first, b.second, a.first, a.second});
    }
  return mates;
}

bool sewn_together(const std::vector<WeldedSide>& sides, const MatedSides& mates) {
  const auto mated = [&](const WeldedSide& a, const WeldedSide& b) {
    const auto [a_low, a_high] = std::minmax(a.from, a.to);
    const auto [b_low, b_high] = std::minmax(b.from, b.to);
    return mates.count({a_low, a_high, b_low, b_high}) > 0;
  };
  std::vector<bool> reached(sides.size(), false);
  std::vector<std::size_t> at{0};
  reached[0] = true;
  for (std::size_t k = 0; k < at.size(); ++k)
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const WeldedSide &here = sides[at[k]], &there = sides[i];
      if (i != at[k] && here.panel == there.panel && here.edge == there.edge && !mated(here, there)) return false;
      if (reached[i] || !mated(here, there)) continue;
      reached[i] = true;
      at.push_back(i);
    }
  return at.size() == sides.size();
}

}  // namespace toile
