#pragma once
// Polylines by arc length. Dimension-free: N is 2 or 3.

#include <Eigen/Core>
#include <vector>

namespace toile {

template <int N>
using Points = std::vector<Eigen::Matrix<double, N, 1>>;

template <int N>
double polyline_length(const Points<N>& points);

// The point at fraction `at` (0..1, clamped) of the arc length.
template <int N>
Eigen::Matrix<double, N, 1> point_at(const Points<N>& points, double at);

// Unit direction of travel there; at a vertex, that of the segment that follows.
template <int N>
Eigen::Matrix<double, N, 1> direction_at(const Points<N>& points, double at);

struct PolylinePlace {
  double at = 0;        // fraction of arc length
  double distance = 0;  // from the query
};

// The nearest point of the polyline to `query`.
template <int N>
PolylinePlace nearest_on(const Points<N>& points, const Eigen::Matrix<double, N, 1>& query);

// The part between fractions `begin` and `end`; reversed when begin > end.
template <int N>
Points<N> part_of(const Points<N>& points, double begin, double end);

// `count` + 1 points at equal arc length, both ends included.
template <int N>
Points<N> resample(const Points<N>& points, int count);


}  // namespace toile
