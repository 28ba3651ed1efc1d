#pragma once
// The bodies of the parametric mannequin are lofts: closed curves along an axis, read as an implicit solid. The curve is the
// superellipse of design MANNEQUIN: u = centre_u +- half_width |cos t|^(2/n), v = centre_v + (front or -back) |sin t|^(2/n).

#include <Eigen/Core>
#include <vector>

namespace toile {

// One cross section. Lengths in metres; front reaches towards +v, back towards -v, each half with an exponent of its own.
struct Section {
  double centre_u = 0, centre_v = 0;
  double half_width = 0, front = 0, back = 0;
  double front_exponent = 2, back_exponent = 2;
};

// Girth of the section, m, to about 1e-5 of itself.
double section_girth(const Section& section);
// The section scaled about the middle of its box (not about its centre, which need not be midway between front and back).
Section scaled(const Section& section, double factor);

struct LoftKnot {
  double at = 0;  // along the axis, m
  Section section;
};

// Right-handed axes are not required: (u, v, along) are orthonormal, and that is all.
struct LoftFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d u = Eigen::Vector3d::UnitX();
  Eigen::Vector3d v = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d along = Eigen::Vector3d::UnitY();
};

// Value and direction of an implicit solid at a point.
struct FormSample {
  double distance = 0;                                 // m, first order: exact on the surface; negative inside
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  // of about unit length
};

// A solid: sections interpolated over the axis with monotone cubics (PCHIP), closed at both ends by half ellipsoids that
// begin `first_cap` and `last_cap` before the end knots.
class Loft {
 public:
  // At least two knots, ascending; throws std::invalid_argument otherwise. `softness` is the standard deviation, m, of the
  // Gaussian that takes the bends of the cubics out along the axis; `clear` keeps every section that far from u = 0, m.
  Loft(const LoftFrame& frame, const std::vector<LoftKnot>& knots, double first_cap, double last_cap, double softness = 0,
       double clear = -1);
  FormSample sample(const Eigen::Vector3d& at) const;
  Section section(double at) const;
  // The point of the axis curve (through the section centres) at `at`.
  Eigen::Vector3d centre(double at) const;
  const LoftFrame& frame() const { return frame_; }
  double begin() const { return begin_; }
  double end() const { return end_; }

 private:
  static constexpr int channels = 7;
  using Row = Eigen::Matrix<double, channels, 1>;
  Row row(double at, Row* slope) const;
  void soften(double softness);

  LoftFrame frame_;
  double begin_ = 0, end_ = 0, first_cap_ = 0, last_cap_ = 0, step_ = 0;
  std::vector<Row> rows_;  // sampled evenly
};

// Smooth union: the nearer of both where their distances differ by more than `blend` (m), else up to blend / 4 fatter. C1.
FormSample united(const FormSample& a, const FormSample& b, double blend);
FormSample intersected(const FormSample& a, const FormSample& b, double blend);

}  // namespace toile
