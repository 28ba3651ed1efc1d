#include "edit/fit/girth.h"

#include <Eigen/Dense>
#include <cmath>

#include "edit/account.h"

namespace toile {
namespace {

double closed_length(const Eigen::Matrix3Xd& points) {
  double length = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) length += (points.col((i + 1) % points.cols()) - points.col(i)).norm();
  return length;
}

}  // namespace

double offset_for_girth(const FitLoop& fit, const Eigen::Matrix3Xd& positions, double girth, Report& report) {
  constexpr double most = 0.5;  // m
  if (girth == 0) return 0;
  const auto grown = [&](double by) {
    return closed_length(fit.moved(positions, fit.offsets(by))) - closed_length(fit.moved(positions, fit.offsets(0)));
  };
  const double far = girth > 0 ? most : -fit.room.maxCoeff();
  const double reached = grown(far);
  if (girth > 0 && reached < girth)
    throw BadInput({"edit.out-of-range", Severity::error, "edit 'fit', girth",
                    "the loop cannot be made " + in_cm(girth) + " longer within this range of angles",
                    "at most " + in_cm(reached) + "; widen the range"});
  if (girth < 0 && reached > girth) {
    report.warn("edit.stopped-at-body", "edit 'fit', girth",
                "the loop becomes " + in_cm(-reached) + " shorter instead of " + in_cm(-girth) + ": the body stops it",
                "see the ease that is left, or ask for less");
    return far;
  }
  double near = 0, end = far;
  for (int i = 0; i < 60; ++i) {
    const double middle = (near + end) / 2;
    (std::abs(grown(middle)) < std::abs(girth) ? near : end) = middle;
  }
  return (near + end) / 2;
}

}  // namespace toile
