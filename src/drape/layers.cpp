#include "drape/layers.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "garment/welds.h"

namespace toile {
namespace {

constexpr double placed_apart = 5e-3;  // m, along the way two panels face

using Pairs = std::set<std::pair<int, int>>;

// Numbers of the seams along every edge of every panel, in the order in which they are written: twice the place in the list,
// one more on the second side.
class SeamOrder {
 public:
  SeamOrder(const Pattern& pattern, const GarmentMesh& garment) {
    for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
      const int number = 2 * static_cast<int>(s);
      note(pattern, garment, pattern.seams[s].a, number);
      note(pattern, garment, pattern.seams[s].b, number + 1);
    }
  }
  int first_at(const BoundarySegment& segment) const {
    const auto found = on_edge_.find({segment.panel, segment.edge});
    const double middle = (segment.begin + segment.end) / 2;
    if (found != on_edge_.end())
      for (const auto& [low, high, number] : found->second)
        if (low <= middle && middle <= high) return number;
    return -1;
  }

 private:
  void note(const Pattern& pattern, const GarmentMesh& garment, const EdgeSpan& span, int number) {
    for (std::size_t p = 0; p < garment.panels.size(); ++p) {
      const Piece& piece = pattern.pieces[static_cast<std::size_t>(garment.panels[p].piece)];
      if (piece.name != span.piece || garment.panels[p].copy != span.copy) continue;
      for (std::size_t e = 0; e < piece.outline.size(); ++e)
        if (piece.outline[e].id == span.edge)
          on_edge_[{static_cast<int>(p), static_cast<int>(e)}].emplace_back(std::min(span.begin, span.end),
                                                                            std::max(span.begin, span.end), number);
    }
  }
  std::map<std::pair<int, int>, std::vector<std::tuple<double, double, int>>> on_edge_;
};

const Placement* placement_of(const Piece& piece, const PanelMesh& panel) {
  const auto copy = static_cast<std::size_t>(panel.copy - 1);
  return copy < piece.placement.size() && piece.placement[copy] ? &*piece.placement[copy] : nullptr;
}

// How far a panel is placed outside another that faces the same way, m; 0 when nothing says.
double placed_outside(const Pattern& pattern, const PanelMesh& one, const PanelMesh& other) {
  const Placement* a = placement_of(pattern.pieces[static_cast<std::size_t>(one.piece)], one);
  const Placement* b = placement_of(pattern.pieces[static_cast<std::size_t>(other.piece)], other);
  if (!a || !b || a->rotation.col(2).dot(b->rotation.col(2)) < 0.7) return 0;
  const auto middle = [](const Placement& at, const PanelMesh& panel) -> Eigen::Vector3d {
    const Eigen::Vector2d flat = panel.rest.rowwise().mean();
    return at.rotation * Eigen::Vector3d(flat.x(), flat.y(), 0) + at.translation;
  };
  const Eigen::Vector3d out = (a->rotation.col(2) + b->rotation.col(2)).normalized();
  return out.dot(middle(*a, one) - middle(*b, other));
}

// Of two panels on the same side of a seam, the second of which is written later.
bool later_lies_over(const Pattern& pattern, const PanelMesh& earlier, const PanelMesh& later) {
  const auto& inner = pattern.pieces[static_cast<std::size_t>(earlier.piece)].layer;
  const auto& outer = pattern.pieces[static_cast<std::size_t>(later.piece)].layer;
  if (inner && outer && *inner != *outer) return *inner < *outer;
  if (inner && !outer) return *inner == 0;
  if (!inner && outer) return *outer > 0;
  const double outside = placed_outside(pattern, later, earlier);
  return std::abs(outside) < placed_apart || outside > 0;
}

// Panels of one side of a seam, with the numbers of their seams, from the body outwards.
std::vector<int> from_the_body(const Pattern& pattern, const GarmentMesh& garment, std::vector<std::pair<int, int>> numbered) {
  std::sort(numbered.begin(), numbered.end());
  std::vector<int> order;
  for (const auto& [number, panel] : numbered) {
    if (std::find(order.begin(), order.end(), panel) != order.end()) continue;
    const auto at = std::find_if(order.begin(), order.end(), [&](int inner) {
      return !later_lies_over(pattern, garment.panels[static_cast<std::size_t>(inner)],
                              garment.panels[static_cast<std::size_t>(panel)]);
    });
    order.insert(at, panel);
  }
  return order;
}

struct Relations {
  Pairs alike;       // of one layer
  Pairs level_with;  // likewise, across a seam of several layers
  Pairs over;        // the second lies over the first
};

Relations relations(const Pattern& pattern, const GarmentMesh& garment) {
  const SeamOrder order(pattern, garment);
  const std::vector<BoundarySegment> segments = boundary_segments(garment);
  const auto layer_of = [&](int panel) {
    return pattern.pieces[static_cast<std::size_t>(garment.panels[static_cast<std::size_t>(panel)].piece)].layer;
  };
  Relations found;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const BoundarySegment& segment = segments[s];
    if (segment.mates.empty() || segment.mates.front() < static_cast<int>(s)) continue;
    std::vector<int> together{static_cast<int>(s)};
    together.insert(together.end(), segment.mates.begin(), segment.mates.end());
    if (together.size() == 2) {
      const int a = segment.panel, b = segments[static_cast<std::size_t>(together[1])].panel;
      const auto la = layer_of(a), lb = layer_of(b);
      if (la && lb && *la != *lb)
        found.over.insert(*la < *lb ? std::pair(a, b) : std::pair(b, a));
      else
        found.alike.insert(std::minmax(a, b));
      continue;
    }
    std::array<std::vector<std::pair<int, int>>, 2> numbered;
    for (const int t : together) {
      const BoundarySegment& side = segments[static_cast<std::size_t>(t)];
      const Eigen::VectorXi& welded = garment.welded[static_cast<std::size_t>(side.panel)];
      numbered[welded(side.from) < welded(side.to)].emplace_back(order.first_at(side), side.panel);
    }
    std::array<std::vector<int>, 2> outwards;
    for (std::size_t k = 0; k < 2; ++k) {
      outwards[k] = from_the_body(pattern, garment, numbered[k]);
      for (std::size_t i = 1; i < outwards[k].size(); ++i) found.over.insert({outwards[k][i - 1], outwards[k][i]});
    }
    for (std::size_t i = 0; i < std::min(outwards[0].size(), outwards[1].size()); ++i)
      found.level_with.insert(std::minmax(outwards[0][i], outwards[1][i]));
  }
  return found;
}

}  // namespace

std::vector<int> panel_layers(const Pattern& pattern, const GarmentMesh& garment) {
  const Relations found = relations(pattern, garment);
  std::vector<int> layer(garment.panels.size(), 0);
  if (found.over.empty()) return layer;
  std::vector<int> part(garment.panels.size());
  std::iota(part.begin(), part.end(), 0);
  const auto of = [&](int panel) { return part[static_cast<std::size_t>(panel)]; };
  for (const Pairs* pairs : {&found.alike, &found.level_with})
    for (const auto& [a, b] : *pairs) {
      const int one = of(a), other = of(b);
      const bool apart = std::any_of(found.over.begin(), found.over.end(), [&](const auto& pair) {
        return std::minmax(of(pair.first), of(pair.second)) == std::minmax(one, other);
      });
      if (!apart) std::replace(part.begin(), part.end(), std::max(one, other), std::min(one, other));
    }
  for (std::size_t round = 0; round < layer.size(); ++round)  // ends early unless layers lie over each other in a circle
    for (const auto& [inner, outer] : found.over) {
      const int least = layer[static_cast<std::size_t>(of(inner))] + 1;
      int& own = layer[static_cast<std::size_t>(of(outer))];
      if (of(inner) != of(outer)) own = std::min(std::max(own, least), static_cast<int>(layer.size()) - 1);
    }
  std::vector<int> by_panel;
  for (std::size_t p = 0; p < layer.size(); ++p) by_panel.push_back(layer[static_cast<std::size_t>(part[p])]);
  return by_panel;
}

}  // namespace toile
