#include "draft/shape_model.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

int add_unknown(std::vector<double>& unknowns, double value) {
  unknowns.push_back(value);
  return static_cast<int>(unknowns.size()) - 1;
}

Coordinate free_coordinate(std::vector<double>& unknowns, double value) { return {add_unknown(unknowns, value), 1, 0}; }

std::array<Coordinate, 2> reflected(std::array<Coordinate, 2> point) {
  point[0].factor *= -1;
  point[0].offset *= -1;
  return point;
}

}  // namespace

std::vector<double> bend_basis(int count, double t) {
  constexpr int degree = 3;
  const int all = count + 2, spans = all - degree;
  const auto knot = [&](int i) { return std::clamp(static_cast<double>(i - degree) / spans, 0.0, 1.0); };
  // Cox - de Boor; the last span is closed on the right.
  const int span = std::clamp(static_cast<int>(std::floor(t * spans)), 0, spans - 1) + degree;
  std::vector<double> values(static_cast<std::size_t>(all + degree), 0.0);
  values[static_cast<std::size_t>(span)] = 1;
  for (int d = 1; d <= degree; ++d)
    for (int i = 0; i < all + degree - d; ++i) {
      const double w = knot(i + d) - knot(i), v = knot(i + d + 1) - knot(i + 1);
      const auto k = static_cast<std::size_t>(i);
      values[k] = (w > 0 ? (t - knot(i)) / w * values[k] : 0) + (v > 0 ? (knot(i + d + 1) - t) / v * values[k + 1] : 0);
    }
  return {values.begin() + 1, values.begin() + 1 + count};
}

ShapeModel model_of(SharedShape shape, const std::vector<int>& bend_counts, std::vector<double>& unknowns) {
  ShapeModel model{std::move(shape), {}, {}};
  const int count = static_cast<int>(model.shape.sides.runs.size());
  const auto wrap = [&](int i) { return ((i % count) + count) % count; };
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector2d& at = model.shape.sides.corners[static_cast<std::size_t>(k)];
    const int twin = model.shape.mirror ? wrap(*model.shape.mirror - k + 1) : count;
    if (twin < k)
      model.corners.push_back(reflected(model.corners[static_cast<std::size_t>(twin)]));
    else
      model.corners.push_back(
          {twin == k ? Coordinate{} : free_coordinate(unknowns, at.x()), free_coordinate(unknowns, at.y())});
  }
  for (int r = 0; r < count; ++r) {
    const int bends = bend_counts[static_cast<std::size_t>(r)];
    const int twin = model.shape.mirror ? wrap(*model.shape.mirror - r) : count;
    model.bends.emplace_back();
    for (int j = 0; j < bends; ++j) {
      auto& here = model.bends.back();
      if (twin < r)
        here.push_back(reflected(model.bends[static_cast<std::size_t>(twin)][static_cast<std::size_t>(bends - 1 - j)]));
      else if (twin == r && bends - 1 - j < j)
        here.push_back(reflected(here[static_cast<std::size_t>(bends - 1 - j)]));
      else
        here.push_back(
            {twin == r && bends - 1 - j == j ? Coordinate{} : free_coordinate(unknowns, 0), free_coordinate(unknowns, 0)});
    }
  }
  return model;
}

ModelPoint point_on(const ShapeModel& model, int run, const Coordinate& t, const Eigen::VectorXd& unknowns) {
  const auto r = static_cast<std::size_t>(run);
  const auto& a = model.corners[r];
  const auto& b = model.corners[(r + 1) % model.corners.size()];
  const Run& side = model.shape.sides.runs[r];
  const double fraction = t.value(unknowns);
  const Eigen::Vector2d z = shape_at(side, fraction);
  const auto value = [&](const std::array<Coordinate, 2>& point) {
    return Eigen::Vector2d(point[0].value(unknowns), point[1].value(unknowns));
  };
  ModelPoint result;
  const Eigen::Vector2d chord = value(b) - value(a);
  result.at = value(a) + on_chord(z, chord);
  const auto slope = [&](const Coordinate& c, const Eigen::Vector2d& d) {
    if (c.unknown >= 0) result.slopes.emplace_back(c.unknown, c.factor * d);
  };
  const Eigen::Vector2d on_x = on_chord(z, Eigen::Vector2d::UnitX()), on_y = on_chord(z, Eigen::Vector2d::UnitY());
  slope(a[0], Eigen::Vector2d::UnitX() - on_x);
  slope(a[1], Eigen::Vector2d::UnitY() - on_y);
  slope(b[0], on_x);
  slope(b[1], on_y);
  if (side.straight) slope(t, chord);
  const auto& bends = model.bends[r];
  if (!bends.empty()) {
    const std::vector<double> basis = bend_basis(static_cast<int>(bends.size()), fraction);
    for (std::size_t j = 0; j < bends.size(); ++j) {
      result.at += basis[j] * value(bends[j]);
      slope(bends[j][0], basis[j] * Eigen::Vector2d::UnitX());
      slope(bends[j][1], basis[j] * Eigen::Vector2d::UnitY());
    }
  }
  return result;
}

ModelLength length_of(const std::vector<ModelPoint>& points) {
  ModelLength sum;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector2d d = points[i].at - points[i - 1].at;
    const double length = d.norm();
    sum.value += length;
    if (length == 0) continue;
    for (const auto& [unknown, slope] : points[i].slopes) sum.slopes.emplace_back(unknown, d.dot(slope) / length);
    for (const auto& [unknown, slope] : points[i - 1].slopes) sum.slopes.emplace_back(unknown, -d.dot(slope) / length);
  }
  return sum;
}

}  // namespace toile
