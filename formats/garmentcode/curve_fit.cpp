#include "formats/garmentcode/curve_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace toile {
namespace {

using Eigen::Vector2d;
using Line = std::vector<Vector2d>;

constexpr double exact = 1e-7;          // m
constexpr double chord_error = .05e-3;  // m, as curves.h samples
constexpr int rounds = 30;              // of moving parameters to the nearest places
constexpr double wildest = 3;           // chord lengths that a control point may lie off

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

void note(FittedCurve& fit, std::size_t i, double departure) {
  if (departure > fit.departure) fit.departure = departure, fit.farthest = i;
}

// What the curve does between two points counts beyond what a chord of a sampled curve leaves aside.
void note_between(FittedCurve& fit, std::size_t i, std::size_t last, double departure) {
  if (departure > chord_error) note(fit, i < last ? i : i - 1, departure - chord_error);
}

double off_chord(const Vector2d& p, const Vector2d& from, const Vector2d& to) {
  const Vector2d along = to - from;
  const double at = std::clamp(along.dot(p - from) / std::max(along.squaredNorm(), 1e-30), 0.0, 1.0);
  return (from + at * along - p).norm();
}

FittedCurve as_line(const Line& points) {
  FittedCurve fit;
  const Vector2d along = points.back() - points.front();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double at = std::clamp(along.dot(points[i] - points.front()) / std::max(along.squaredNorm(), 1e-30), 0.0, 1.0);
    note(fit, i, (points.front() + at * along - points[i]).norm());
  }
  return fit;
}

FittedCurve as_circle(const Line& points) {
  FittedCurve fit;
  fit.kind = FittedCurve::Kind::circle;
  const Vector2d a = points.front(), b = points[points.size() / 2] - a, c = points.back() - a;
  const double twice = 2 * cross(b, c);
  fit.departure = 1e300;
  if (std::abs(twice) < 1e-9 * (b.norm() + c.norm()) * c.norm()) return fit;
  const Vector2d centre =
      a +
      Vector2d(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(), b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) / twice;
  fit.radius = (a - centre).norm();
  fit.right = twice > 0;
  fit.departure = 0;
  double sweep = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    note(fit, i, std::abs((points[i] - centre).norm() - fit.radius));
    const Vector2d from = points[i - 1] - centre, to = points[i] - centre;
    const double step = std::atan2(cross(from, to), from.dot(to));
    if ((step > 0) != fit.right) note(fit, i, 1e300);
    note_between(fit, i, points.size() - 1, fit.radius * (1 - std::cos(step / 2)));
    sweep += step;
  }
  fit.large = std::abs(sweep) > 3.14159265358979323846;
  return fit;
}

Vector2d at(const Line& control, double t) {
  Line row = control;
  while (row.size() > 1) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = (1 - t) * row[i] + t * row[i + 1];
    row.pop_back();
  }
  return row[0];
}

double weight(int degree, int k, double t) {
  const double choose = k == 0 || k == degree ? 1 : degree;
  return choose * std::pow(t, k) * std::pow(1 - t, degree - k);
}

// Least squares for the inner control points at given parameters; the ends stay.
Line solved(const Line& points, const std::vector<double>& t, int degree) {
  const auto rows = static_cast<Eigen::Index>(points.size()) - 2;
  Eigen::MatrixXd basis(rows, degree - 1), wanted(rows, 2);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto p = static_cast<std::size_t>(i) + 1;
    for (int k = 1; k < degree; ++k) basis(i, k - 1) = weight(degree, k, t[p]);
    wanted.row(i) = points[p] - weight(degree, 0, t[p]) * points.front() - weight(degree, degree, t[p]) * points.back();
  }
  const Eigen::MatrixXd inner = basis.completeOrthogonalDecomposition().solve(wanted);
  Line control{points.front()};
  for (Eigen::Index k = 0; k < inner.rows(); ++k) control.emplace_back(inner.row(k));
  control.push_back(points.back());
  return control;
}

FittedCurve as_bezier(const Line& points, int degree, std::vector<double> t, int moves) {
  FittedCurve fit;
  fit.kind = degree == 2 ? FittedCurve::Kind::quadratic : FittedCurve::Kind::cubic;
  Line control = solved(points, t, degree);
  for (int round = 0; round < moves; ++round) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const double h = 1e-4;
      const Vector2d here = at(control, t[i]), slope = (at(control, t[i] + h) - at(control, t[i] - h)) / (2 * h);
      t[i] = std::clamp(t[i] + slope.dot(points[i] - here) / std::max(slope.squaredNorm(), 1e-30), t[i - 1] + 1e-6, 1 - 1e-6);
    }
    control = solved(points, t, degree);
  }
  for (std::size_t i = 1; i + 1 < points.size(); ++i) note(fit, i, (at(control, t[i]) - points[i]).norm());
  for (std::size_t i = 1; i < points.size(); ++i)
    note_between(fit, i, points.size() - 1, off_chord(at(control, (t[i - 1] + t[i]) / 2), points[i - 1], points[i]));
  fit.control.assign(control.begin() + 1, control.end() - 1);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  for (const Vector2d& p : fit.control)
    if (!((p - points.front()).norm() < wildest * length)) fit.departure = 1e300, fit.farthest = points.size() / 2;
  return fit;
}

}  // namespace

FittedCurve fit_curve(const Line& points) {
  FittedCurve best = as_line(points);
  if (points.size() < 3 || best.departure < exact) return best;
  std::vector<double> equal, by_length{0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    equal.push_back(static_cast<double>(i) / static_cast<double>(points.size() - 1));
    if (i > 0) by_length.push_back(by_length.back() + (points[i] - points[i - 1]).norm());
  }
  for (double& t : by_length) t /= by_length.back();
  const auto try_it = [&](FittedCurve fit) {
    if (fit.departure < best.departure) best = std::move(fit);
    return best.departure < exact;
  };
  if (try_it(as_bezier(points, 2, equal, 0))) return best;
  if (points.size() > 3 && try_it(as_circle(points))) return best;
  if (points.size() > 3 && try_it(as_bezier(points, 3, equal, 0))) return best;
  if (points.size() > 3) try_it(as_bezier(points, 3, by_length, rounds));
  if (best.kind == FittedCurve::Kind::line) best.farthest = std::clamp<std::size_t>(best.farthest, 1, points.size() - 2);
  return best;
}

}  // namespace toile
