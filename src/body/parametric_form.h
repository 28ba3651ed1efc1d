#pragma once
// The solid of the parametric mannequin: lofts of trunk, head, arm, leg and foot joined by smooth unions, its surface where
// the distance is zero. Symmetric about x = 0.

#include <map>
#include <string>
#include <vector>

#include "body/parametric_figure.h"
#include "body/parametric_loft.h"

namespace toile {

// What is turned to make the finished surface measure what the chart says.
struct FormScales {
  std::map<std::string, double> sections;  // by girth name, 1 when absent
  double bust_forward = 0;                 // m, how far the breasts are moved forward
  double crotch_drop = 0;                  // m, how far the pelvic floor is let down
};

struct Ellipsoid {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(), half_axes = Eigen::Vector3d::Ones();
  FormSample sample(const Eigen::Vector3d& at) const;
};

class BodyForm {
 public:
  BodyForm(const Figure& figure, const FormScales& scales);

  FormSample sample(const Eigen::Vector3d& at) const;
  double distance(const Eigen::Vector3d& at) const { return sample(at).distance; }
  // The nearest surface point along the gradient, by Newton's method; `at` must be near the surface.
  Eigen::Vector3d projected(Eigen::Vector3d at, int steps = 4) const;

  const Loft& trunk() const { return trunk_; }
  const Loft& leg() const { return leg_; }
  const Loft& arm() const { return arm_; }
  const Loft& foot() const { return foot_; }

 private:
  Loft trunk_, head_, leg_, arm_, foot_;
  std::vector<Ellipsoid> breasts_;  // of the wearer's left
};

}  // namespace toile
