#include "body/parametric_form.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double cm = .01;
constexpr double leg_blend = .025, arm_blend = .025, head_blend = .02, foot_blend = .02, floor_blend = .006, breast_blend = .05;
constexpr double thigh_blend = .015;
constexpr double gap_between_thighs = .0065;  // half of it; wider than thigh_blend / 4, so that thighs never grow together

double scale_of(const FormScales& scales, const std::string& name) {
  const auto found = scales.sections.find(name);
  return found == scales.sections.end() ? 1.0 : found->second;
}

Section section_of(const Figure& figure, const FormScales& scales, const std::string& name) {
  return scaled(figure.sections.at(name), scale_of(scales, name));
}

double front_of(const Section& s) { return s.centre_v + s.front; }
double back_of(const Section& s) { return s.centre_v - s.back; }

Section between(double front, double back, double half_width, double exponent) {
  const double depth = (front - back) / 2;
  return {0, (front + back) / 2, half_width, depth, depth, exponent, exponent};
}

Loft trunk_loft(const Figure& figure, const FormScales& scales) {
  const auto& y = figure.levels;
  std::vector<LoftKnot> knots;
  const auto at_level = [&](const char* name) { knots.push_back({y.at(name), section_of(figure, scales, name)}); };
  // Below the waist the legs carry hips and seat; the trunk fills the middle and stays behind them.
  const Section hip = section_of(figure, scales, "hip");
  const double depth = hip.front + hip.back;
  const Section core = between(front_of(hip) - .035 * depth, back_of(hip) + .14 * depth, .95 * hip.half_width, 2.4);
  const Section floor = between(front_of(hip) - .07 * depth, back_of(hip) + .22 * depth, .62 * hip.half_width, 2);
  knots.push_back({y.at("crotch") - scales.crotch_drop, floor});
  knots.push_back({y.at("hip"), core});
  Section seat = scaled(figure.sections.at("seat"), scale_of(scales, figure.girths.count("seat") ? "seat" : "hip"));
  seat.centre_v += .02 * (seat.front + seat.back), seat.back -= .04 * (seat.front + seat.back);
  knots.push_back({std::max(y.at("seat"), y.at("hip") + .02 * figure.height), seat});
  for (const char* name : {"high_hip", "waist", "underbust", "bust"}) at_level(name);

  // Above the bust: women 38, cm, fitted to shoulders, depth of chest and neck.
  struct Row {
    double y, half_width, centre, front, back, exponent, neck;  // neck: 1 where the neck rules the width
  };
  static constexpr Row upper[] = {
      {127.7, 15.2, 3.0, 9.6, 8.7, 2.3, 0},  {133.0, 15.8, 2.2, 8.4, 8.1, 2.4, 0},  {137.0, 16.0, 1.6, 6.6, 6.6, 2.2, 0},
      {139.5, 14.5, 1.2, 5.4, 5.4, 2.0, .1}, {141.2, 10.0, 1.0, 5.0, 5.0, 2.0, .5}, {142.5, 7.2, 1.4, 5.2, 5.0, 2.0, .9},
      {144.0, 6.15, 2.1, 5.2, 5.2, 2.0, 1},  {148.3, 5.3, 3.3, 5.4, 5.4, 2.0, 1},   {155.0, 5.3, 4.0, 5.4, 5.4, 2.0, 1}};
  const double tall = figure.height / 1.68, neck = figure.neck_factor * scale_of(scales, "neck");
  for (const Row& row : upper) {
    const double wide = figure.shoulder_factor + row.neck * (neck - figure.shoulder_factor);
    const double chest = std::clamp((142.5 - row.y) / (142.5 - 127.7), 0.0, 1.0), deep = 1 + row.neck * (neck - 1);
    Section s{0,
              row.centre * cm * tall,
              row.half_width * cm * tall * wide,
              row.front * cm * tall * deep,
              row.back * cm * tall * deep,
              row.exponent,
              row.exponent};
    s.centre_v += (1 - deep) * (row.front - row.back) / 2 * cm * tall;
    const double forward = chest * figure.chest_front, backward = -chest * figure.chest_back;
    s.centre_v += (forward - backward) / 2, s.front += (forward + backward) / 2, s.back += (forward + backward) / 2;
    knots.push_back({row.y * cm * tall, s});
  }
  return Loft({}, knots, .8 * (y.at("hip") - y.at("crotch")) + scales.crotch_drop, .04 * tall, .013 * tall);
}

Loft head_loft(const Figure& figure) {
  // Fractions of the head's height from the chin; half width, front and back against the head joint, in heads.
  struct Row {
    double up, half_width, front, back, exponent;
  };
  static constexpr Row rows[] = {{.00, .14, .44, .05, 2},   {.10, .22, .46, -.10, 2},  {.25, .29, .46, -.30, 2},
                                 {.42, .325, .47, -.42, 2}, {.60, .345, .45, -.48, 2}, {.78, .335, .41, -.46, 2},
                                 {1.0, .27, .32, -.36, 2}};
  const double chin = .872 * figure.height, tall = figure.height - chin;
  const double head = .122 * figure.height;  // grows with stature only
  std::vector<LoftKnot> knots;
  for (const Row& row : rows) {
    Section s = between(figure.head_joint.z() + row.front * head, figure.head_joint.z() + row.back * head,
                        row.half_width * head, row.exponent);
    knots.push_back({chin + row.up * tall, s});
  }
  return Loft({}, knots, .08 * tall, .42 * tall);
}

Loft leg_loft(const Figure& figure, const FormScales& scales) {
  const auto& y = figure.levels;
  const double tall = figure.height;
  std::vector<LoftKnot> knots;
  const auto at_level = [&](const char* name, double x, double z) {
    Section s = section_of(figure, scales, name);
    s.centre_u = std::max(x * tall, s.half_width + gap_between_thighs), s.centre_v = z * tall;
    knots.push_back({y.at(name), s});
  };
  const bool f = figure.female;
  Section ankle = section_of(figure, scales, "ankle");
  ankle.centre_u = figure.ankle.x(), ankle.centre_v = figure.ankle.z() - .004 * tall;
  knots.push_back({.030 * tall, ankle});
  at_level("ankle", f ? .0871 : .1029, f ? .0156 : .0039);
  at_level("low_calf", f ? .0863 : .0958, f ? .0109 : .0001);
  at_level("calf", f ? .0836 : .0916, f ? .0114 : -.0019);
  at_level("below_knee", f ? .0804 : .0893, f ? .0145 : .0013);
  at_level("knee", f ? .0713 : .0803, f ? .0305 : .0095);
  at_level("above_knee", f ? .0650 : .0739, f ? .0336 : .0178);
  at_level("mid_thigh", f ? .0617 : .0687, f ? .0343 : .0186);
  const double drop = .02;
  Section thigh = section_of(figure, scales, "thigh");
  thigh.centre_u = thigh.half_width + gap_between_thighs, thigh.centre_v = (f ? .0267 : .0141) * tall;
  knots.push_back({y.at("crotch") - drop, thigh});
  const Section hip = section_of(figure, scales, "hip");
  const Section seat = scaled(figure.sections.at("seat"), scale_of(scales, figure.girths.count("seat") ? "seat" : "hip"));
  const double depth = hip.front + hip.back, seat_depth = seat.front + seat.back;
  Section upper = between(front_of(hip) - .01 * depth, back_of(hip), .48 * hip.half_width, 2.1);
  upper.centre_u = hip.half_width - upper.half_width;
  knots.push_back({y.at("hip"), upper});
  Section top = between(front_of(seat) - .07 * seat_depth, back_of(seat), .45 * seat.half_width, 2);
  top.centre_u = .51 * seat.half_width;
  knots.push_back({std::max(y.at("seat"), y.at("hip") + .02 * tall), top});
  const Section high = section_of(figure, scales, "high_hip");
  const double high_depth = high.front + high.back;
  top = between(front_of(high) - .25 * high_depth, back_of(high) + .03 * high_depth, .40 * high.half_width, 2);
  top.centre_u = .48 * high.half_width;
  knots.push_back({y.at("high_hip"), top});
  return Loft({}, knots, 0, .5 * (y.at("high_hip") - y.at("seat")), .007 * tall, gap_between_thighs);
}

Loft arm_loft(const Figure& figure, const FormScales& scales) {
  const Eigen::Vector3d chord = figure.wrist - figure.shoulder;
  LoftFrame frame;
  frame.origin = figure.shoulder;
  frame.along = chord.normalized();
  frame.v = (Eigen::Vector3d::UnitZ() - frame.along.z() * frame.along).normalized();
  frame.u = frame.v.cross(frame.along);
  if (frame.u.y() < 0) frame.u = -frame.u;
  std::vector<LoftKnot> knots;
  const auto place = [&](const Eigen::Vector3d& centre, Section s) {
    const Eigen::Vector3d offset = centre - frame.origin;
    s.centre_u = frame.u.dot(offset), s.centre_v = frame.v.dot(offset);
    knots.push_back({frame.along.dot(offset), s});
  };
  const auto on = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t, const char* name) {
    place(a + t * (b - a), section_of(figure, scales, name));
  };
  const double tall = figure.height;
  Section root = section_of(figure, scales, "upper_arm_root");
  // Heavy arms hang below the shoulder point instead of standing above it.
  const Eigen::Vector3d sag = -.7 * std::max(0., root.half_width - .0255 * tall) * frame.u;
  place(figure.shoulder - .035 * frame.along + sag, scaled(root, 1.02));
  place(figure.shoulder + .006 * tall * frame.along + sag, scaled(root, 1.06));
  on(figure.shoulder, figure.elbow, .30, "upper_arm_root");
  on(figure.shoulder, figure.elbow, .55, "upper_arm");
  on(figure.shoulder, figure.elbow, .85, "above_elbow");
  place(figure.elbow, section_of(figure, scales, "elbow"));
  on(figure.elbow, figure.wrist, .25, "forearm");
  on(figure.elbow, figure.wrist, .60, "low_forearm");
  on(figure.elbow, figure.wrist, .95, "wrist");
  const double hand = (figure.fingertip - figure.wrist).norm();
  const auto palm = [&](double t, double half_thick, double half_wide) {
    Section s{0, 0, half_thick * hand, half_wide * hand, half_wide * hand, 2.3, 2.3};
    place(figure.wrist + t * (figure.fingertip - figure.wrist), s);
  };
  palm(.22, .100, .205);
  palm(.42, .090, .232);
  palm(.60, .074, .215);
  palm(1.0, .056, .165);
  return Loft(frame, knots, .045, .40 * hand, .004 * tall);
}

Loft foot_loft(const Figure& figure) {
  LoftFrame frame;
  const double length = .152 * figure.height;
  frame.origin = {figure.ankle.x(), 0, figure.ankle.z()};
  frame.along = Eigen::Vector3d(.13, 0, 1).normalized();
  frame.v = Eigen::Vector3d::UnitY();
  frame.u = frame.v.cross(frame.along);
  struct Row {
    double at, aside, half_width, top;  // in foot lengths
  };
  static constexpr Row rows[] = {{-.235, 0, .10, .19},    {-.10, 0, .125, .27},    {.08, .0, .135, .30},
                                 {.24, .004, .16, .235},  {.44, .008, .185, .165}, {.60, .006, .18, .125},
                                 {.765, -.005, .13, .085}};
  std::vector<LoftKnot> knots;
  for (const Row& row : rows) {
    const double centre = .08 * length;
    knots.push_back({row.at * length,
                     {row.aside * length, centre, row.half_width * length, std::max(row.top * length - centre, .03 * length),
                      centre + .03 * length, 2.2, 3}});
  }
  return Loft(frame, knots, .07 * length, .12 * length);
}

std::vector<Ellipsoid> breasts(const Figure& figure, const FormScales& scales, const Loft& trunk) {
  if (!figure.female) return {};
  const double y = figure.levels.at("bust");
  const double size = std::cbrt(figure.girths.at("bust") / .88 * figure.girths.at("bust") / .88 * figure.height / 1.68);
  const double radius = .056 * size;
  const double x = figure.bust_point_distance / 2 - .0075 * size;
  const Section cage = trunk.section(y);
  const double u = std::min(x / cage.half_width, .9);
  const double skin = cage.centre_v + cage.front * std::pow(1 - std::pow(u, cage.front_exponent), 1 / cage.front_exponent);
  const double z = skin - .015 * size + scales.bust_forward;
  // The breast, and a smaller one behind and above it for the slope that leads up to the collar bone.
  return {{{x, y - .003 * size, z}, {1.15 * radius, radius, radius}},
          {{.97 * x, y + .040 * size, z - .026 * size}, {.90 * radius, .75 * radius, .70 * radius}}};
}

}  // namespace

FormSample Ellipsoid::sample(const Eigen::Vector3d& at) const {
  const Eigen::Vector3d offset = (at - centre).cwiseQuotient(half_axes);
  const double gauge = offset.norm();
  if (gauge < 1e-9) return {-half_axes.minCoeff(), Eigen::Vector3d::Zero()};
  const Eigen::Vector3d slope = offset.cwiseQuotient(half_axes) / gauge;
  return {(gauge - 1) / slope.norm(), slope.normalized()};
}

BodyForm::BodyForm(const Figure& figure, const FormScales& scales)
    : trunk_(trunk_loft(figure, scales)),
      head_(head_loft(figure)),
      leg_(leg_loft(figure, scales)),
      arm_(arm_loft(figure, scales)),
      foot_(foot_loft(figure)),
      breasts_(breasts(figure, scales, trunk_)) {}

FormSample BodyForm::sample(const Eigen::Vector3d& at) const {
  const Eigen::Vector3d left(std::abs(at.x()), at.y(), at.z()), right(-left.x(), left.y(), left.z());
  // A part and its mirror image, joined across the midplane.
  const auto pair = [&](const auto& part, double blend) {
    const FormSample own = part.sample(left);
    if (left.x() > blend) return own;
    FormSample other = part.sample(right);
    other.gradient.x() = -other.gradient.x();
    return united(own, other, blend);
  };
  FormSample body = trunk_.sample(left);
  for (const Ellipsoid& breast : breasts_) body = united(body, pair(breast, .02), breast_blend);
  if (at.y() > head_.begin() - .06) body = united(body, head_.sample(left), head_blend);
  if (at.y() < leg_.end() + .05) {
    FormSample leg = pair(leg_, thigh_blend);
    if (at.y() < .25) leg = intersected(united(leg, foot_.sample(left), foot_blend), {-at.y(), {0, -1, 0}}, floor_blend);
    body = united(body, leg, leg_blend);
  }
  body = united(body, arm_.sample(left), arm_blend);
  if (at.x() < 0) body.gradient.x() = -body.gradient.x();
  return body;
}

Eigen::Vector3d BodyForm::projected(Eigen::Vector3d at, int steps) const {
  for (int i = 0; i < steps; ++i) {
    const FormSample here = sample(at);
    const double squared = here.gradient.squaredNorm();
    if (squared < 1e-6) break;
    at -= std::clamp(here.distance / squared, -.02, .02) * here.gradient;
    if (std::abs(here.distance) < 1e-7) break;
  }
  return at;
}

}  // namespace toile
