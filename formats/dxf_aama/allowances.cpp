#include "formats/dxf_aama/allowances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::aama {
namespace {

constexpr double farthest = 0.1;   // m
constexpr double inside = 0.1e-3;  // m, a cut line on the sew line may lie this much inside by rounding
constexpr int samples = 17;

// How far along the unit `direction` from `from` the ring is first met.
double first_hit(const Eigen::Vector2d& from, const Eigen::Vector2d& direction, const Points<2>& ring) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d d = ring[(i + 1) % ring.size()] - a;
    const double across = direction.x() * d.y() - direction.y() * d.x();
    if (std::abs(across) <= 1e-12 * d.norm()) continue;
    const Eigen::Vector2d to = a - from;
    const double along = (to.x() * d.y() - to.y() * d.x()) / across;
    const double at = (to.x() * direction.y() - to.y() * direction.x()) / across;
    if (at >= -1e-9 && at <= 1 + 1e-9 && along >= -inside) best = std::min(best, std::max(along, 0.0));
  }
  return best;
}

}  // namespace

Allowance measured_allowance(const Points<2>& edge, const Points<2>& sew, const Points<2>& cut) {
  std::vector<double> widths;
  int facing = 0;
  for (int i = 1; i <= samples; ++i) {
    const double at = .1 + .8 * (i - .5) / samples;
    const Eigen::Vector2d from = point_at<2>(edge, at);
    const Eigen::Vector2d along = direction_at<2>(edge, at);
    const Eigen::Vector2d out(along.y(), -along.x());
    const double width = first_hit(from, out, cut);
    const double step = 3 * inside;
    if (step + first_hit(from + step * out, out, sew) < width)
      ++facing;
    else if (width <= farthest)
      widths.push_back(width);
  }
  Allowance allowance;
  allowance.faces_itself = facing * 2 > samples;
  if (allowance.faces_itself || widths.size() * 2 < samples) return allowance;
  std::sort(widths.begin(), widths.end());
  const std::size_t eighth = widths.size() / 8;
  allowance.width = std::round(widths[widths.size() / 2] * 1e5) / 1e5;
  allowance.spread = widths[widths.size() - 1 - eighth] - widths[eighth];
  return allowance;
}

}  // namespace toile::aama
