#include "collide/listing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile {
namespace {

double farthest(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
  if (from.cols() != to.cols()) return std::numeric_limits<double>::infinity();
  return to.cols() == 0 ? 0 : std::sqrt((to - from).colwise().squaredNorm().maxCoeff());
}

}  // namespace

std::optional<double> Listing::renew(const Eigen::Matrix3Xd& x) {
  const double step = farthest(last_, x);
  last_ = x;
  if (farthest(listed_at_, x) <= margin_) return {};
  listed_at_ = x;
  margin_ = step > most_ ? most_ / 16 : std::clamp(4 * step, most_ / 16, most_);
  return margin_;
}

}  // namespace toile
