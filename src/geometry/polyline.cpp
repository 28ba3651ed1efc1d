#include "geometry/polyline.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace toile {
namespace {

// Segment that holds fraction `at`, and the fraction within it.
template <int N>
std::pair<std::size_t, double> locate(const Points<N>& points, double at) {
  if (points.size() < 2) throw std::invalid_argument("polyline: needs two points");
  const double wanted = std::clamp(at, 0.0, 1.0) * polyline_length<N>(points);
  double before = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double segment = (points[i] - points[i - 1]).norm();
    if (before + segment > wanted) return {i - 1, (wanted - before) / segment};
    before += segment;
  }
  return {points.size() - 2, 1.0};
}

}  // namespace

template <int N>
double polyline_length(const Points<N>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

template <int N>
Eigen::Matrix<double, N, 1> point_at(const Points<N>& points, double at) {
  const auto [i, t] = locate<N>(points, at);
  return (1 - t) * points[i] + t * points[i + 1];
}

template <int N>
Eigen::Matrix<double, N, 1> direction_at(const Points<N>& points, double at) {
  auto [i, t] = locate<N>(points, at);
  while (i > 0 && (points[i + 1] - points[i]).norm() == 0) --i;
  return (points[i + 1] - points[i]).normalized();
}

template <int N>
PolylinePlace nearest_on(const Points<N>& points, const Eigen::Matrix<double, N, 1>& query) {
  const double total = polyline_length<N>(points);
  PolylinePlace best{0, std::numeric_limits<double>::infinity()};
  double before = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Matrix<double, N, 1> d = points[i] - points[i - 1];
    const double segment = d.norm();
    const double t = segment > 0 ? std::clamp((query - points[i - 1]).dot(d) / (segment * segment), 0.0, 1.0) : 0.0;
    const double distance = (points[i - 1] + t * d - query).norm();
    if (distance < best.distance) best = {total > 0 ? (before + t * segment) / total : 0.0, distance};
    before += segment;
  }
  return best;
}

template <int N>
Points<N> part_of(const Points<N>& points, double begin, double end) {
  const double low = std::min(begin, end);
  const double high = std::max(begin, end);
  const double total = polyline_length<N>(points);
  Points<N> part{point_at<N>(points, low)};
  double before = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    before += (points[i] - points[i - 1]).norm();
    const double at = before / total;
    if (at > low + 1e-12 && at < high - 1e-12) part.push_back(points[i]);
  }
  part.push_back(point_at<N>(points, high));
  if (begin > end) std::reverse(part.begin(), part.end());
  return part;
}

template <int N>
Points<N> resample(const Points<N>& points, int count) {
  if (count < 1) throw std::invalid_argument("resample: count must be positive");
  Points<N> samples;
  for (int i = 0; i <= count; ++i) samples.push_back(point_at<N>(points, static_cast<double>(i) / count));
  samples.front() = points.front();
  samples.back() = points.back();
  return samples;
}

#define TOILE_POLYLINE(N)                                                                         \
  template double polyline_length<N>(const Points<N>&);                                           \
  template Eigen::Matrix<double, N, 1> point_at<N>(const Points<N>&, double);                     \
  template Eigen::Matrix<double, N, 1> direction_at<N>(const Points<N>&, double);                 \
  template PolylinePlace nearest_on<N>(const Points<N>&, const Eigen::Matrix<double, N, 1>&);     \
  template Points<N> part_of<N>(const Points<N>&, double, double);                                \
  template Points<N> resample<N>(const Points<N>&, int);
TOILE_POLYLINE(2)
TOILE_POLYLINE(3)
#undef TOILE_POLYLINE

}  // namespace toile
