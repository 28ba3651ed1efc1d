#include "draft/outline_fit.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include "draft/locked.h"
#include "draft/pattern_model.h"
#include "garment/units.h"

namespace toile {
namespace {

constexpr double smooth_angle = 20 * units::degree;  // a turn drawn smaller than this is meant to be smooth
constexpr double smooth_lever = 0.02;                // m: a radian of kink counts as much as this distance

Coordinate constant(double value) { return {-1, 0, value}; }

// A square root of the objective and the constraints, linearised: rows of J dx = -r and C dx = -c.
struct Linearised {
  std::vector<Eigen::Triplet<double>> normal;  // J^T J
  Eigen::VectorXd descent;                     // -J^T r
  std::vector<Eigen::Triplet<double>> constraints;
  std::vector<double> violations;

  void add(const std::vector<std::pair<int, double>>& slopes, double residual, double weight) {
    for (const auto& [i, si] : slopes) {
      descent(i) -= weight * si * residual;
      for (const auto& [j, sj] : slopes) normal.emplace_back(i, j, weight * si * sj);
    }
  }
  void add(const ModelPoint& point, const Eigen::Vector2d& wanted, double weight) {
    for (int axis = 0; axis < 2; ++axis) {
      std::vector<std::pair<int, double>> slopes;
      for (const auto& [unknown, slope] : point.slopes) slopes.emplace_back(unknown, slope(axis));
      add(slopes, point.at(axis) - wanted(axis), weight);
    }
  }
};

// Turn of the outline at the start of run `k` of a shape, read over a tenth of curved sides; with derivatives.
ModelLength turn_at(const ShapeModel& model, int k, const Eigen::VectorXd& unknowns) {
  const int count = static_cast<int>(model.corners.size()), before = (k + count - 1) % count;
  const auto& runs = model.shape.sides.runs;
  const bool bent_before = !runs[static_cast<std::size_t>(before)].straight, bent = !runs[static_cast<std::size_t>(k)].straight;
  const ModelPoint here = point_on(model, k, constant(0), unknowns);
  const ModelPoint from = point_on(model, before, constant(bent_before ? .9 : 0), unknowns);
  const ModelPoint to = point_on(model, k, constant(bent ? .1 : 1), unknowns);
  const Eigen::Vector2d u = here.at - from.at, v = to.at - here.at;
  ModelLength turn{std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v)), {}};
  const auto add = [&](const ModelPoint& point, const Eigen::Vector2d& along, double sign) {
    const Eigen::Vector2d across = Eigen::Vector2d(-along.y(), along.x()) / along.squaredNorm();
    for (const auto& [unknown, slope] : point.slopes) turn.slopes.emplace_back(unknown, sign * across.dot(slope));
  };
  add(to, v, 1);
  add(here, v, -1);
  add(here, u, -1);
  add(from, u, 1);
  return turn;
}

struct Junction {
  std::size_t model;
  int corner;
  double turn;  // as drawn
};

std::vector<Junction> smooth_junctions(const std::vector<ShapeModel>& models, const Eigen::VectorXd& drawn) {
  std::vector<Junction> junctions;
  for (std::size_t m = 0; m < models.size(); ++m) {
    const auto& runs = models[m].shape.sides.runs;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      if (runs[k].straight && runs[(k + runs.size() - 1) % runs.size()].straight) continue;
      const double turn = turn_at(models[m], static_cast<int>(k), drawn).value;
      if (std::abs(turn) < smooth_angle) junctions.push_back({m, static_cast<int>(k), turn});
    }
  }
  return junctions;
}

// A seam as a constraint: length of edge a minus `ratio` times that of edge b.
struct Truing {
  int piece_a, edge_a, piece_b, edge_b;
  double ratio;
};

std::vector<Truing> truings(const Pattern& pattern) {
  std::vector<Truing> result;
  std::set<std::array<int, 4>> seen;  // the copies of a piece are sewn alike
  const auto place = [&](const EdgeSpan& span) {
    const Piece* piece = find_piece(pattern, span.piece);
    const Edge* edge = piece ? find_edge(*piece, span.edge) : nullptr;
    if (!edge)
      throw std::invalid_argument("redraw: a seam names edge '" + span.edge + "' of '" + span.piece + "', which is not there");
    return std::pair{static_cast<int>(piece - pattern.pieces.data()), static_cast<int>(edge - piece->outline.data())};
  };
  for (const Seam& seam : pattern.seams) {
    const auto [pa, ea] = place(seam.a);
    const auto [pb, eb] = place(seam.b);
    const auto whole = [&](int p, int e) {
      return length(pattern.pieces[static_cast<std::size_t>(p)].outline[static_cast<std::size_t>(e)]);
    };
    if (seen.insert({pa, ea, pb, eb}).second) result.push_back({pa, ea, pb, eb, whole(pa, ea) / whole(pb, eb)});
  }
  return result;
}

// a - ratio * b by its derivatives.
Eigen::VectorXd slope_of(const PatternModel& model, const Truing& seam) {
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(model.unknowns.size());
  for (const auto& [unknown, s] : length_of(model.edge_points(seam.piece_a, seam.edge_a)).slopes) slope(unknown) += s;
  for (const auto& [unknown, s] : length_of(model.edge_points(seam.piece_b, seam.edge_b)).slopes)
    slope(unknown) -= seam.ratio * s;
  return slope;
}

// Seams of pieces that are alike say the same of the shapes they share, but for how alike they are: one with the mean ratio.
// Both exactly could only be met by edges without length, as could a seam of two sides that the shape makes equal itself.
std::vector<Truing> distinct(const std::vector<Truing>& seams, const PatternModel& model) {
  constexpr double same = 1e-6, settled = 1e-3;
  struct Group {
    Truing seam;
    Eigen::VectorXd slope;
    double count = 1;
  };
  std::vector<Group> groups;
  for (const Truing& seam : seams) {
    const Eigen::VectorXd slope = slope_of(model, seam),
                          own = slope_of(model, {seam.piece_a, seam.edge_a, seam.piece_a, seam.edge_a, 0});
    if (slope.norm() < settled * own.norm()) continue;
    const auto met = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      return std::abs(group.slope.dot(slope)) > (1 - same) * group.slope.norm() * slope.norm();
    });
    if (met == groups.end()) {
      groups.push_back({seam, slope});
      continue;
    }
    const double ratio = met->slope.dot(slope) > 0 ? seam.ratio : 1 / seam.ratio;
    met->seam.ratio += (ratio - met->seam.ratio) / ++met->count;
  }
  std::vector<Truing> result;
  for (const Group& group : groups) result.push_back(group.seam);
  return result;
}

Eigen::VectorXd solve(const Linearised& system) {
  const Eigen::Index n = system.descent.size(), m = static_cast<Eigen::Index>(system.violations.size());
  // Quasi-definite: factors without pivoting in any order, and takes constraints that say the same thing twice.
  constexpr double slack = 1e-10;
  std::vector<Eigen::Triplet<double>> entries = system.normal;
  for (Eigen::Index i = 0; i < n; ++i) entries.emplace_back(i, i, 1e-12);
  for (const auto& c : system.constraints) {
    entries.emplace_back(static_cast<int>(n) + c.row(), c.col(), c.value());
    entries.emplace_back(c.col(), static_cast<int>(n) + c.row(), c.value());
  }
  for (Eigen::Index i = 0; i < m; ++i) entries.emplace_back(n + i, n + i, -slack);
  Eigen::SparseMatrix<double> matrix(n + m, n + m);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd right(n + m);
  right.head(n) = system.descent;
  for (Eigen::Index i = 0; i < m; ++i) right(n + i) = -system.violations[static_cast<std::size_t>(i)];
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  Eigen::VectorXd solution = factor.solve(right);
  solution += factor.solve(Eigen::VectorXd(right - matrix * solution));
  return solution.head(n);
}

}  // namespace

FittedOutlines fit_outlines(const Pattern& original, const Likeness& likeness, const std::vector<PanelOutline>& panels,
                            const RedrawOptions& options) {
  PatternModel model(original, likeness, panels, options.curve_tolerance);
  const std::vector<Junction> junctions = smooth_junctions(model.models, model.unknowns);
  const std::vector<Truing> seams = distinct(truings(original), model);
  const std::vector<KeptDistance> locked = kept_distances(original);
  const Eigen::VectorXd drawn = model.unknowns;
  std::map<int, int> panels_of_shape;
  for (const PanelOutline& panel : panels) ++panels_of_shape[model.lay(panel.piece).shape];

  const auto weight_of = [&](std::size_t shape) -> double {
    const auto found = panels_of_shape.find(static_cast<int>(shape));
    return found == panels_of_shape.end() ? 1 : found->second;
  };

  const auto linearise = [&](bool true_seams) {
    Linearised system;
    system.descent = Eigen::VectorXd::Zero(model.unknowns.size());
    for (const PanelOutline& panel : panels) {
      const Lay& lay = model.lay(panel.piece);
      for (const PanelOutline::Sample& sample : panel.samples)
        system.add(model.on_edge(panel.piece, sample.edge, sample.at), lay.to_shape(sample.point), sample.weight);
    }
    for (const Junction& junction : junctions) {
      const ShapeModel& shape = model.models[junction.model];
      const ModelLength turn = turn_at(shape, junction.corner, model.unknowns);
      const std::size_t k = static_cast<std::size_t>(junction.corner), count = shape.corners.size();
      const double lengths = shape.shape.sides.runs[k].length + shape.shape.sides.runs[(k + count - 1) % count].length;
      system.add(turn.slopes, std::remainder(turn.value - junction.turn, 2 * std::numbers::pi),
                 weight_of(junction.model) * lengths * smooth_lever * smooth_lever);
    }
    for (std::size_t m = 0; m < model.models.size(); ++m)  // a shape no panel speaks for stays as drawn
      if (panels_of_shape.count(static_cast<int>(m)) == 0)
        for (const auto& corner : model.models[m].corners)
          for (const Coordinate& c : corner)
            if (c.unknown >= 0) system.add({{c.unknown, 1.0}}, model.unknowns(c.unknown) - drawn(c.unknown), 1);
    for (const KeptDistance& kept : locked) {
      if (!true_seams) break;
      const ModelLength apart =
          length_of({model.on_edge(kept.piece, kept.edge, kept.from), model.on_edge(kept.piece, kept.edge, kept.to)});
      const int row = static_cast<int>(system.violations.size());
      for (const auto& [unknown, slope] : apart.slopes) system.constraints.emplace_back(row, unknown, slope);
      system.violations.push_back(apart.value - kept.distance);
    }
    for (const Truing& seam : seams) {
      if (!true_seams) break;
      const ModelLength a = length_of(model.edge_points(seam.piece_a, seam.edge_a));
      const ModelLength b = length_of(model.edge_points(seam.piece_b, seam.edge_b));
      const int row = static_cast<int>(system.violations.size());
      for (const auto& [unknown, slope] : a.slopes) system.constraints.emplace_back(row, unknown, slope);
      for (const auto& [unknown, slope] : b.slopes) system.constraints.emplace_back(row, unknown, -seam.ratio * slope);
      system.violations.push_back(a.value - seam.ratio * b.value);
    }
    return system;
  };

  FittedOutlines result;
  for (int i = 0; i < 3; ++i) model.unknowns += solve(linearise(false));
  model.set_points_for(options.chord_tolerance);
  double last = std::numeric_limits<double>::infinity();
  for (; result.iterations < 20 && !result.converged; ++result.iterations) {
    const Linearised system = linearise(true);
    double worst = 0;
    for (const double violation : system.violations) worst = std::max(worst, std::abs(violation));
    result.converged = worst < 1e-9 && last < 1e-8;
    if (result.converged) break;
    const Eigen::VectorXd step = solve(system);
    model.unknowns += step;
    last = step.size() > 0 ? step.cwiseAbs().maxCoeff() : 0;
  }

  for (std::size_t p = 0; p < original.pieces.size(); ++p) {
    const Isometry back = likeness.lays[p].to_shape.inverse();
    result.outlines.emplace_back();
    for (std::size_t e = 0; e < original.pieces[p].outline.size(); ++e) {
      Edge edge = original.pieces[p].outline[e];
      const std::vector<OutlinePoint> drawn_points = edge.points;
      const std::vector<double>& at = model.fractions[p][e];
      edge.points.clear();
      std::size_t next = 0;  // of the points it had: the others were put in between
      const std::vector<ModelPoint> points = model.edge_points(static_cast<int>(p), static_cast<int>(e));
      std::vector<double> had{0};
      for (std::size_t i = 1; i < drawn_points.size(); ++i)
        had.push_back(had.back() + (drawn_points[i].at - drawn_points[i - 1].at).norm());
      for (std::size_t i = 0; i < points.size(); ++i) {
        OutlinePoint point;
        if (next < had.size() && std::abs(had[next] / had.back() - at[i]) < 1e-12) point = drawn_points[next++];
        point.at = back(points[i].at);
        edge.points.push_back(point);
      }
      result.outlines.back().push_back(std::move(edge));
    }
  }
  return result;
}

}  // namespace toile
