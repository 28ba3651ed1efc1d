// Head, arm, leg and foot of the net.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "body/parametric_rows.h"
#include "garment/units.h"

namespace toile {
namespace {

const Eigen::Vector3d up = Eigen::Vector3d::UnitY(), front = Eigen::Vector3d::UnitZ();

// The leg's tube bends forward into the foot: planes swing about a line above the instep until they stand upright, then walk
// to the toes.
void lay_foot(RowNet& net, const BodyForm& form, const Figure& figure, Row below, const Eigen::Vector3d& start) {
  const Loft& foot = form.foot();
  const Eigen::Vector3d forward = foot.frame().along, aside = foot.frame().u;
  const double tall = figure.height, ankle = figure.levels.at("ankle");
  const Eigen::Vector3d ankle_centre = form.leg().centre(ankle);
  const double reach = .045 * tall;
  const Eigen::Vector3d pivot = ankle_centre + reach * forward;
  const int swings = net.steps(.15 * tall, 5);
  const double deep = pivot.y() - .022 * tall;
  for (int i = 1; i <= swings; ++i) {
    const double share = static_cast<double>(i) / swings;
    const Eigen::AngleAxisd swing(-90 * degree * share, aside);
    const Eigen::Vector3d centre = pivot + swing * (-(reach + share * (deep - reach)) * forward);
    net.lay_tube(below, ring(form, centre, swing * start, swing * up, 2 * fine_rays), true);
  }
  const Eigen::AngleAxisd upright(-90 * degree, aside);
  const double from = forward.dot(pivot - foot.frame().origin), to = foot.end() - .008 * tall;
  const auto centre_at = [&](double at) {
    Eigen::Vector3d centre = foot.frame().origin + at * forward;
    centre.y() = .4 * way_out(form, {centre.x(), .004, centre.z()}, up).y();
    return centre;
  };
  const int rows = net.steps(to - from, 2);
  for (int i = 1; i <= rows; ++i)
    net.lay_tube(below, ring(form, centre_at(from + (to - from) * i / rows), upright * start, upright * up, fine_rays), true);
  const Eigen::Vector3d centre = centre_at(to);
  Chain inner;
  for (const Eigen::Vector3d& p : net.chain(below))
    inner.push_back(form.projected(centre + .55 * (p - centre) + .006 * forward, 8));
  net.lay_tube(below, inner, true);
  net.fold(below, aside, true);
}

}  // namespace

void lay_head(RowNet& net, const BodyForm& form, const Figure& figure, const Row& neck) {
  const double tall = figure.height;
  const double from = .862 * tall, to = .975 * tall;
  const int rows = net.steps(1.25 * (to - from), 4);
  Row below = neck;
  Eigen::Vector3d centre;
  Chain row;
  for (int i = 1; i <= rows; ++i) {
    const double share = static_cast<double>(i) / rows;
    const double tilt = 16 * degree * (1 - share);
    const double settle = std::min(1.0, share / .45);
    const double z = (1 - settle) * trunk_centre(form, from).z() + settle * figure.head_joint.z();
    centre = {0, from + share * (to - from), z};
    row = half_ring(form, centre, front, {0, std::cos(tilt), std::sin(tilt)}, fine_rays);
    const Row next = net.add_half_ring(row);
    net.bridge(below, next);
    below = next;
  }
  // The crown: rows shrinking to a pole.
  const Eigen::Vector3d pole = way_out(form, centre, up);
  const int rings = net.steps(1.15 * length(row) / 3.14, 2);
  for (int i = 1; i < rings; ++i) {
    Chain inner;
    for (const Eigen::Vector3d& p : row) {
      const double share = static_cast<double>(i) / rings;
      const Eigen::Vector3d aim = p + share * (pole - p) - centre;
      inner.push_back(way_out(form, centre, aim.normalized()));
    }
    inner.front().x() = 0, inner.back().x() = 0;
    const Row next = net.add_half_ring(inner);
    net.bridge(below, next);
    below = next;
  }
  net.gather(below, net.add({pole}).front(), false);
}

void lay_arm(RowNet& net, const BodyForm& form, const Figure& figure, const TrunkRows& trunk) {
  const Loft& arm = form.arm();
  const Eigen::Vector3d along = arm.frame().along;
  const Eigen::Vector3d start = net.point(trunk.armhole.front()) - figure.shoulder;
  // The first ring round the arm alone: its plane clears the armpit.
  const Eigen::Vector3d pit = way_out(form, {0, trunk.armpit, figure.shoulder.z()}, Eigen::Vector3d::UnitX());
  const double first = std::max(along.dot(pit - arm.frame().origin), .02) + .022;
  const double length_to_tip = arm.end() - first, last = arm.end() - .026 * figure.height;
  Row below = trunk.armhole;
  net.lay_between(form, below, ring(form, arm.centre(first), start, along, fine_rays), false);
  const int rows = net.steps(length_to_tip, 4);
  for (int i = 1; i <= rows; ++i)
    net.lay_tube(below, ring(form, arm.centre(first + (last - first) * i / rows), start, along, fine_rays), false);
  // Finger tips: rays that lean more and more along the arm, gathered in the tip.
  const Chain rim = net.chain(below);
  const Eigen::Vector3d centre = arm.centre(last);
  const int rings = net.steps(.026 * figure.height, 2);
  for (int i = 1; i <= rings; ++i) {
    const double lean = 74 * degree * i / rings;
    Chain inner;
    for (const Eigen::Vector3d& p : rim)
      inner.push_back(way_out(form, centre, std::cos(lean) * (p - centre).normalized() + std::sin(lean) * along));
    net.lay_tube(below, inner, false);
  }
  net.gather(below, net.add({way_out(form, centre, along)}).front(), true);
}

void lay_leg(RowNet& net, const BodyForm& form, const Figure& figure, const Row& seat) {
  const auto& y = figure.levels;
  // Through the crotch, from centre back to centre front.
  const Eigen::Vector3d fore = net.point(seat.front()), aft = net.point(seat.back());
  Chain under;
  constexpr int casts = 32;
  for (int i = 0; i <= casts; ++i) {
    const double share = static_cast<double>(i) / casts;
    const Eigen::Vector3d from = aft + share * (fore - aft);
    under.push_back(i == 0 || i == casts ? from : way_out(form, from, -up));
  }
  const Chain line = resampled(under, net.steps(length(under), 3) + 1);
  Row below = seat;
  const Row crotch = net.add(Chain(line.begin() + 1, line.end() - 1));
  below.insert(below.end(), crotch.begin(), crotch.end());
  const Loft& leg = form.leg();
  const double levels[] = {y.at("crotch") - .022, y.at("mid_thigh"), y.at("knee"), y.at("calf"), y.at("ankle")};
  const Eigen::Vector3d start = fore - leg.centre(levels[0]);
  const auto round_leg = [&](double height) { return ring(form, leg.centre(height), start, up, fine_rays); };
  net.lay_between(form, below, round_leg(levels[0]), true);
  for (std::size_t k = 0; k + 1 < std::size(levels); ++k) {
    const int rows = net.steps(levels[k] - levels[k + 1]);
    for (int i = 1; i <= rows; ++i) net.lay_tube(below, round_leg(levels[k] + (levels[k + 1] - levels[k]) * i / rows), true);
  }
  lay_foot(net, form, figure, below, start);
}

}  // namespace toile
