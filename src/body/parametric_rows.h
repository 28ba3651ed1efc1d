#pragma once
// Rows of points and the triangles between them: what the mannequin's net is knitted from. On a reference body the numbers of
// points and rows follow the lengths met; on every other body they are those of the reference.

#include "body/parametric_net.h"

namespace toile {

using Row = std::vector<int>;  // points of one row, in the order they are walked

class RowNet {
 public:
  explicit RowNet(double edge_length, const Net* reference = nullptr) : edge_(edge_length), reference_(reference) {}

  // Decides a number once for all bodies: `own` on the reference body, what was decided there on the others.
  int decide(int own);
  // Steps of one edge length over `length`.
  int steps(double length, int least = 1);

  Row add(const Chain& chain);
  Row add_half_ring(const Chain& chain);  // spaced evenly, ends kept
  Row add_ring(const Chain& chain);       // spaced evenly, closed
  const Eigen::Vector3d& point(int i) const { return net_.points[static_cast<std::size_t>(i)]; }
  Chain chain(const Row& row) const;

  // Triangles between two rows that run alike; `upper` lies further along the direction that rows turn about.
  void bridge(const Row& lower, const Row& upper);
  void bridge_rings(Row lower, Row upper);
  // Triangles from a row (closed when `ring`) to one point beyond it.
  void gather(Row row, int tip, bool ring);
  // Sews a narrow ring shut, flank to flank across `long_axis`.
  void fold(const Row& ring, const Eigen::Vector3d& long_axis, bool downwards);
  // The next ring of a tube, further along the direction rows turn about or, `downwards`, against it.
  void lay_tube(Row& last, const Chain& next, bool downwards);
  // Rings from the one that is there to the surface ring `to`, those between projected onto the form.
  void lay_between(const BodyForm& form, Row& last, const Chain& to, bool downwards);

  Net take() { return std::move(net_); }

 private:
  double edge_;
  const Net* reference_;
  Net net_;
};

constexpr int fine_rays = 72;  // of a ring before it is spaced evenly

// Between two chains of equally many points.
Chain mixed(const Chain& a, const Chain& b, double share);
// Mean distance of their points.
double apart(const Chain& a, const Chain& b);

// Middle of the trunk at height y.
Eigen::Vector3d trunk_centre(const BodyForm& form, double y);

// What the trunk leaves open.
struct TrunkRows {
  Row seat;           // half ring just above the crotch
  Row armhole;        // ring
  Row neck;           // half ring
  double armpit = 0;  // height at which the arm leaves the trunk, m
};
TrunkRows lay_trunk(RowNet& net, const BodyForm& form, const Figure& figure);
void lay_head(RowNet& net, const BodyForm& form, const Figure& figure, const Row& neck);
void lay_arm(RowNet& net, const BodyForm& form, const Figure& figure, const TrunkRows& trunk);
void lay_leg(RowNet& net, const BodyForm& form, const Figure& figure, const Row& seat);

}  // namespace toile
