#include "draft/pattern_model.h"

#include <cmath>
#include <map>

#include "draft/locked.h"

namespace toile {
namespace {

Coordinate constant(double value) { return {-1, 0, value}; }
Coordinate from_other_end(const Coordinate& c) { return {c.unknown, -c.factor, 1 - c.offset}; }

ModelPoint blend(const ModelPoint& a, const ModelPoint& b, double f) {
  ModelPoint result{(1 - f) * a.at + f * b.at, {}};
  for (const auto& [unknown, slope] : a.slopes) result.slopes.emplace_back(unknown, (1 - f) * slope);
  for (const auto& [unknown, slope] : b.slopes) result.slopes.emplace_back(unknown, f * slope);
  return result;
}

}  // namespace

PatternModel::PatternModel(const Pattern& original, const Likeness& likeness, const std::vector<PanelOutline>& panels,
                           double tolerance)
    : original_(original), likeness_(likeness) {
  for (const Piece& piece : original.pieces) {
    sides_.push_back(sides_of(piece));
    fractions.emplace_back();
    for (const Edge& edge : piece.outline) {
      std::vector<double>& at = fractions.back().emplace_back(1, 0.0);
      const std::vector<Eigen::Vector2d> points = positions(edge);
      for (std::size_t i = 1; i < points.size(); ++i) at.push_back(at.back() + (points[i] - points[i - 1]).norm());
      for (double& f : at) f /= at.back();
      at.back() = 1;
    }
  }
  std::vector<double> values;
  for (const SharedShape& shape : likeness.shapes) {
    std::vector<int> bends = bend_counts(shape, likeness.lays, sides_, panels, tolerance);
    const int count = static_cast<int>(bends.size());
    for (const int p : shape.pieces)
      for (int i = 0; i < count; ++i) {
        const auto piece = static_cast<std::size_t>(p);
        if (!is_locked(original.pieces[piece], sides_[piece].runs[static_cast<std::size_t>(i)])) continue;
        const int r = run_of(likeness.lays[piece], i, count);
        bends[static_cast<std::size_t>(r)] = 0;
        if (shape.mirror) bends[static_cast<std::size_t>((((*shape.mirror - r) % count) + count) % count)] = 0;
      }
    models.push_back(model_of(shape, bends, values));
  }
  add_turns(values);
  unknowns = Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// Turn points along straight runs: one unknown where congruent pieces (or halves) have one at the same place.
void PatternModel::add_turns(std::vector<double>& values) {
  struct Known {
    double at;
    Coordinate place;
  };
  std::map<std::pair<int, int>, std::vector<Known>> known;  // by (shape, run)
  for (std::size_t p = 0; p < sides_.size(); ++p) {
    const Lay& lay = likeness_.lays[p];
    const SharedShape& shape = models[static_cast<std::size_t>(lay.shape)].shape;
    const int count = static_cast<int>(sides_[p].runs.size());
    turns_.emplace_back();
    for (int i = 0; i < count; ++i) {
      const Run& run = sides_[p].runs[static_cast<std::size_t>(i)];
      const int r = run_of(lay, i, count);
      const double same = 1e-4 / run.length;
      auto& turns = turns_.back().emplace_back();
      turns.push_back(constant(lay.reversed ? 1 : 0));
      for (std::size_t k = 0; k + 1 < run.parts.size(); ++k) {
        const double at = lay.reversed ? 1 - run.parts[k].end : run.parts[k].end;
        const auto find = [&](int where, double f) -> const Known* {
          for (const Known& other : known[{lay.shape, where}])
            if (std::abs(other.at - f) < same) return &other;
          return nullptr;
        };
        const int twin = shape.mirror ? (((*shape.mirror - r) % count) + count) % count : -1;
        Coordinate place;
        if (const Known* here = find(r, at))
          place = here->place;
        else if (const Known* there = twin >= 0 ? find(twin, 1 - at) : nullptr)
          place = from_other_end(there->place);
        else if (twin == r && std::abs(at - .5) < same)
          place = constant(.5);
        else {
          values.push_back(at);
          place = {static_cast<int>(values.size()) - 1, 1, 0};
        }
        known[{lay.shape, r}].push_back({at, place});
        turns.push_back(place);
      }
      turns.push_back(constant(lay.reversed ? 0 : 1));
    }
  }
}

std::pair<const Run*, std::pair<int, const Run::Part*>> PatternModel::part(int piece, int edge, double at) const {
  const Sides& sides = sides_[static_cast<std::size_t>(piece)];
  std::pair<const Run*, std::pair<int, const Run::Part*>> best{nullptr, {0, nullptr}};
  for (std::size_t r = 0; r < sides.runs.size(); ++r)
    for (const Run::Part& candidate : sides.runs[r].parts)
      if (candidate.edge == edge && candidate.edge_begin <= at && at <= candidate.edge_end)
        best = {&sides.runs[r], {static_cast<int>(r), &candidate}};
  return best;
}

ModelPoint PatternModel::on_edge(int piece, int edge, double at) const {
  const auto [run, place] = part(piece, edge, at);
  const auto& [r, found] = place;
  const auto p = static_cast<std::size_t>(piece);
  const ShapeModel& model = models[static_cast<std::size_t>(lay(piece).shape)];
  const int shape_run = run_of(lay(piece), r, static_cast<int>(sides_[p].runs.size()));
  const double u = (at - found->edge_begin) / (found->edge_end - found->edge_begin);
  if (!run->straight) return point_on(model, shape_run, constant(lay(piece).reversed ? 1 - u : u), unknowns);
  const auto index = static_cast<std::size_t>(found - run->parts.data());
  const auto& turns = turns_[p][static_cast<std::size_t>(r)];
  return blend(point_on(model, shape_run, turns[index], unknowns), point_on(model, shape_run, turns[index + 1], unknowns), u);
}

std::vector<ModelPoint> PatternModel::edge_points(int piece, int edge) const {
  std::vector<ModelPoint> points;
  for (const double at : fractions[static_cast<std::size_t>(piece)][static_cast<std::size_t>(edge)])
    points.push_back(on_edge(piece, edge, at));
  return points;
}

// Adds points to curves until their chords keep within the tolerance.
void PatternModel::set_points_for(double chord_tolerance) {
  for (std::size_t p = 0; p < fractions.size(); ++p)
    for (std::size_t e = 0; e < fractions[p].size(); ++e) {
      const int piece = static_cast<int>(p), edge = static_cast<int>(e);
      if (is_straight_edge(piece, edge)) continue;
      std::vector<double>& at = fractions[p][e];
      for (int round = 0; round < 6; ++round) {
        std::vector<double> finer{at.front()};
        for (std::size_t i = 1; i < at.size(); ++i) {
          const double middle = (at[i - 1] + at[i]) / 2;
          const Eigen::Vector2d a = on_edge(piece, edge, at[i - 1]).at, b = on_edge(piece, edge, at[i]).at;
          if ((on_edge(piece, edge, middle).at - (a + b) / 2).norm() > chord_tolerance) finer.push_back(middle);
          finer.push_back(at[i]);
        }
        if (finer.size() == at.size()) break;
        at = std::move(finer);
      }
    }
}

}  // namespace toile
