#include "formats/dxf_aama/match_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/dxf_aama/turn_points.h"
#include "garment/units.h"

namespace toile::aama {
namespace {

using Eigen::Vector2d;

constexpr double corner_angle = 20 * units::degree;

Vector2d middle(const Points<2>& points) {
  Vector2d low = points.front(), high = low;
  for (const Vector2d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (low + high) / 2;
}

std::vector<std::size_t> corners_of(const Points<2>& points, bool closed) {
  std::vector<std::size_t> corners;
  const std::vector<bool> sharp = corners_by_angle(points, corner_angle);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (closed ? sharp[i] : (i == 0 || i + 1 == points.size() || sharp[i])) corners.push_back(i);
  return corners;
}

// Squared distances of corners b[(i + shift) % n] from a[i], both about their middles.
double apart(const Points<2>& a, const std::vector<std::size_t>& ca, const Points<2>& b, const std::vector<std::size_t>& cb,
             std::size_t shift) {
  const Vector2d move = middle(a) - middle(b);
  double sum = 0;
  for (std::size_t i = 0; i < ca.size(); ++i) sum += (b[cb[(i + shift) % cb.size()]] + move - a[ca[i]]).squaredNorm();
  return sum;
}

std::vector<double> fractions(const Points<2>& polyline) {
  std::vector<double> at{0};
  for (std::size_t i = 1; i < polyline.size(); ++i) at.push_back(at.back() + (polyline[i] - polyline[i - 1]).norm());
  for (double& each : at) each /= std::max(at.back(), 1e-12);
  at.back() = 1;
  return at;
}

}  // namespace

LineMatch::LineMatch(const Chain& from, const Chain& to) : from_(from.points), to_(to.points) {
  const bool closed = from.closed && to.closed;
  if (closed ? signed_area(from_) * signed_area(to_) < 0
             : (from_.front() - to_.front() - middle(from_) + middle(to_)).norm() >
                   (from_.front() - to_.back() - middle(from_) + middle(to_)).norm())
    std::reverse(to_.begin(), to_.end());
  std::vector<std::size_t> a = corners_of(from_, closed), b = corners_of(to_, closed);
  if (closed) {
    if (a.empty() || a.size() != b.size()) {
      a = {0};
      b = {0};
      double best = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < to_.size(); ++i) {
        const double d = apart(from_, a, to_, {i}, 0);
        if (d < best) best = d, b = {i};
      }
    } else {
      std::size_t shift = 0;
      for (std::size_t s = 1; s < b.size(); ++s)
        if (apart(from_, a, to_, b, s) < apart(from_, a, to_, b, shift)) shift = s;
      std::rotate(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(shift), b.end());
    }
    // Both begin at their first anchors.
    const auto begin_at = [](Points<2>& ring, std::vector<std::size_t>& corners) {
      const std::size_t first = corners.front(), n = ring.size();
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
      for (std::size_t& corner : corners) corner = (corner + n - first) % n;
      corners.push_back(n);
      ring.push_back(ring.front());
    };
    begin_at(from_, a);
    begin_at(to_, b);
  } else if (a.size() != b.size()) {
    a = {0, from_.size() - 1};
    b = {0, to_.size() - 1};
  }
  const std::vector<double> from_lengths = fractions(from_), to_lengths = fractions(to_);
  for (std::size_t i = 0; i < a.size(); ++i) {
    from_at_.push_back(from_lengths[a[i]]);
    to_at_.push_back(to_lengths[b[i]]);
  }
  for (std::vector<double>* at : {&from_at_, &to_at_}) std::sort(at->begin(), at->end());
}

Vector2d LineMatch::operator()(const Vector2d& on_from) const {
  const double at = nearest_on<2>(from_, on_from).at;
  std::size_t i = 1;
  while (i + 1 < from_at_.size() && at > from_at_[i]) ++i;
  const double span = from_at_[i] - from_at_[i - 1];
  const double t = span > 1e-12 ? std::clamp((at - from_at_[i - 1]) / span, 0.0, 1.0) : 0.0;
  return point_at<2>(to_, to_at_[i - 1] + t * (to_at_[i] - to_at_[i - 1]));
}

}  // namespace toile::aama
