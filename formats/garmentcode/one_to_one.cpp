#include "formats/garmentcode/one_to_one.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include "geometry/polyline.h"

namespace toile {
namespace {

constexpr double same_place = 1e-6;  // of an edge's length
constexpr int most_rounds = 60;

using EdgeOfCopy = std::tuple<int, int, int>;  // piece, copy, edge

// Fractions at which edges are cut, sorted, 0 and 1 among them.
class Cuts {
 public:
  bool add(const EdgeOfCopy& edge, double at) {
    std::vector<double>& here = of(edge);
    const auto next = std::lower_bound(here.begin(), here.end(), at);
    if (next != here.end() && *next - at < same_place) return false;
    if (next != here.begin() && at - *std::prev(next) < same_place) return false;
    here.insert(next, at);
    return true;
  }
  std::vector<double>& of(const EdgeOfCopy& edge) {
    auto& here = at_[edge];
    if (here.empty()) here = {0, 1};
    return here;
  }

 private:
  std::map<EdgeOfCopy, std::vector<double>> at_;
};

struct Side {
  EdgeOfCopy edge;
  double begin, end;
};

class Splitter {
 public:
  Splitter(const Pattern& pattern, double tolerance) : pattern_(pattern), tolerance_(tolerance) {
    for (const Seam& seam : pattern.seams) seams_.emplace_back(side(seam.a), side(seam.b));
  }

  OneToOne split() {
    for (const auto& [a, b] : seams_)
      for (const Side& each : {a, b}) cuts_.add(each.edge, each.begin), cuts_.add(each.edge, each.end);
    bool more = true;
    for (int round = 0; more && round < most_rounds; ++round) {
      more = false;
      for_edges([&](const EdgeOfCopy& edge) { more = cut_at_curves(edge) || more; });
      for (const auto& [a, b] : seams_) more = mirror(a, b) || mirror(b, a) || more;
    }
    return made();
  }

 private:
  Side side(const EdgeSpan& span) const {
    for (std::size_t p = 0; p < pattern_.pieces.size(); ++p)
      for (std::size_t e = 0; e < pattern_.pieces[p].outline.size(); ++e)
        if (pattern_.pieces[p].name == span.piece && pattern_.pieces[p].outline[e].id == span.edge && span.copy >= 1 &&
            span.copy <= copies(pattern_.pieces[p]))
          return {{static_cast<int>(p), span.copy, static_cast<int>(e)}, span.begin, span.end};
    throw std::invalid_argument("one_to_one: there is no edge '" + span.edge + "' of piece '" + span.piece + "'");
  }

  template <class Act>
  void for_edges(Act act) const {
    for (std::size_t p = 0; p < pattern_.pieces.size(); ++p)
      for (int copy = 1; copy <= copies(pattern_.pieces[p]); ++copy)
        for (std::size_t e = 0; e < pattern_.pieces[p].outline.size(); ++e)
          act(EdgeOfCopy{static_cast<int>(p), copy, static_cast<int>(e)});
  }

  Points<2> line(const EdgeOfCopy& edge) const {
    return positions(
        pattern_.pieces[static_cast<std::size_t>(std::get<0>(edge))].outline[static_cast<std::size_t>(std::get<2>(edge))]);
  }

  bool cut_at_curves(const EdgeOfCopy& edge) {
    const Points<2> whole = line(edge);
    bool more = false;
    const std::vector<double> before = cuts_.of(edge);
    for (std::size_t i = 0; i + 1 < before.size(); ++i) {
      const Points<2> part = part_of<2>(whole, before[i], before[i + 1]);
      std::size_t at = 0;
      if ((part.front() - part.back()).norm() < 1e-5)
        at = part.size() / 2;
      else if (const FittedCurve fit = fit_curve(part); fit.departure > tolerance_)
        at = fit.farthest;
      if (at == 0 || at + 1 >= part.size()) continue;
      const double run = polyline_length<2>(Points<2>(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(at) + 1));
      more = cuts_.add(edge, before[i] + (before[i + 1] - before[i]) * run / polyline_length<2>(part)) || more;
    }
    return more;
  }

  // Cuts `to` where `from` is cut.
  bool mirror(const Side& from, const Side& to) {
    bool more = false;
    for (const double at : std::vector<double>(cuts_.of(from.edge))) {
      const double along = (at - from.begin) / (from.end - from.begin);
      if (along > same_place && along < 1 - same_place)
        more = cuts_.add(to.edge, to.begin + along * (to.end - to.begin)) || more;
    }
    return more;
  }

  OneToOne made() {
    OneToOne all;
    std::map<EdgeOfCopy, std::vector<int>> numbers;  // edge of the panel by part
    std::map<std::pair<int, int>, int> panel_number;
    for (std::size_t p = 0; p < pattern_.pieces.size(); ++p) {
      const Piece& piece = pattern_.pieces[p];
      for (int copy = 1; copy <= copies(piece); ++copy) {
        FlatPanel panel{piece.name + (copies(piece) > 1 ? ":" + std::to_string(copy) : ""), static_cast<int>(p), copy, {}};
        const bool mirrored = is_mirrored(piece, copy);
        for (std::size_t k = 0; k < piece.outline.size(); ++k) {
          const std::size_t e = mirrored ? piece.outline.size() - 1 - k : k;
          const EdgeOfCopy edge{static_cast<int>(p), copy, static_cast<int>(e)};
          const std::vector<double>& cuts = cuts_.of(edge);
          auto& parts = numbers[edge];
          parts.assign(cuts.size() - 1, 0);
          for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const std::size_t part = mirrored ? cuts.size() - 2 - i : i;
            parts[part] = static_cast<int>(panel.edges.size());
            PanelEdge drawn{piece.outline[e].id, cuts.size() == 2, part_of<2>(line(edge), cuts[part], cuts[part + 1]), {}};
            if (mirrored) {
              std::reverse(drawn.points.begin(), drawn.points.end());
              for (Eigen::Vector2d& point : drawn.points) point.x() = -point.x();
            }
            drawn.curve = fit_curve(drawn.points);
            panel.edges.push_back(std::move(drawn));
          }
        }
        panel_number[{static_cast<int>(p), copy}] = static_cast<int>(all.panels.size());
        all.panels.push_back(std::move(panel));
      }
    }
    for (std::size_t s = 0; s < seams_.size(); ++s) {
      const auto& [a, b] = seams_[s];
      const std::vector<int> parts_a = parts_of(a, numbers), parts_b = parts_of(b, numbers);
      const auto forward = [&](const Side& side) {
        const auto& [p, copy, e] = side.edge;
        return (side.begin < side.end) != is_mirrored(pattern_.pieces[static_cast<std::size_t>(p)], copy);
      };
      for (std::size_t i = 0; i < std::min(parts_a.size(), parts_b.size()); ++i)
        all.stitches.push_back({panel_number[{std::get<0>(a.edge), std::get<1>(a.edge)}], parts_a[i],
                                panel_number[{std::get<0>(b.edge), std::get<1>(b.edge)}], parts_b[i], forward(a) == forward(b),
                                static_cast<int>(s)});
    }
    return all;
  }

  // The panel's edges that a side of a seam runs along, in its direction.
  std::vector<int> parts_of(const Side& side, std::map<EdgeOfCopy, std::vector<int>>& numbers) {
    const std::vector<double>& cuts = cuts_.of(side.edge);
    std::vector<int> parts;
    const double low = std::min(side.begin, side.end), high = std::max(side.begin, side.end);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      if (const double middle = (cuts[i] + cuts[i + 1]) / 2; middle > low && middle < high)
        parts.push_back(numbers[side.edge][i]);
    if (side.begin > side.end) std::reverse(parts.begin(), parts.end());
    return parts;
  }

  const Pattern& pattern_;
  double tolerance_;
  std::vector<std::pair<Side, Side>> seams_;
  Cuts cuts_;
};

}  // namespace

OneToOne one_to_one(const Pattern& pattern, double tolerance) { return Splitter(pattern, tolerance).split(); }

}  // namespace toile
