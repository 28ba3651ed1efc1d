#pragma once
// Segments in the plane.

#include <Eigen/Core>
#include <optional>
#include <utility>

namespace toile {

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Where on segment ab (0..1) and on segment cd (0..1) they cross or touch; parallel segments never do.
std::optional<std::pair<double, double>> crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                                                  const Eigen::Vector2d& d);

double distance(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b);
// Between segments ab and cd; 0 when they cross.
double distance(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d);

}  // namespace toile
