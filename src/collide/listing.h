#pragma once
// When a list of what is near, made with a margin, must be made anew because something has moved by more than that.

#include <Eigen/Core>
#include <optional>

namespace toile {

class Listing {
 public:
  explicit Listing(double margin) : most_(margin) {}

  // The margin (m) that a new list at `x` is to have; nothing while the last one holds. A cloth that moves far at once gets a
  // small one, since no list would last.
  std::optional<double> renew(const Eigen::Matrix3Xd& x);

 private:
  double most_, margin_ = 0;
  Eigen::Matrix3Xd listed_at_, last_;
};

}  // namespace toile
