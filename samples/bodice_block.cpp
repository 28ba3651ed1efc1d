#include "bodice_block.h"

#include <cmath>

#include "garment/units.h"

namespace toile::drafting {
namespace {

using Eigen::Vector2d;

constexpr double back_slope = 20 * degree, front_slope = 25 * degree;  // of the shoulder

// From the underarm along the chest line, then up the width line, into the shoulder square to it.
Line armhole(const Vector2d& underarm, const Vector2d& tip, double width, double hollow, double slope) {
  const double depth = tip.y() - underarm.y();
  const double reach = underarm.x() - width;
  const Vector2d corner(width, underarm.y() + .36 * depth);  // from here up on the width line
  const Vector2d square(-std::sin(slope), -std::cos(slope));
  Line lower = curve(underarm, underarm - Vector2d(hollow * reach, 0), corner - Vector2d(0, .22 * depth), corner, 8);
  const Vector2d up(0, .2 * depth);
  return joined(lower, curve(corner, corner + up, tip + .25 * depth * square, tip, 8));
}

BodiceHalf half(double side, double chest, double width, double hollow, const Vector2d& neck, double neck_centre,
                double shoulder, double slope) {
  BodiceHalf out;
  out.side = side;
  const Vector2d tip = neck + shoulder * Vector2d(std::cos(slope), -std::sin(slope));
  out.armhole = armhole({side, chest}, tip, width, hollow, slope);
  out.shoulder = {tip, neck};
  const double drop = neck.y() - neck_centre;
  // Nearly square to the shoulder, level on the centre line.
  out.neck = curve(neck, neck + .6 * drop * Vector2d(-std::sin(slope / 2), -std::cos(slope / 2)),
                   Vector2d(.6 * neck.x(), neck_centre), Vector2d(0, neck_centre), 12);
  return out;
}

}  // namespace

double nape_to_waist(const Measures& m) { return .228 * m.height; }
double waist_to_hip(const Measures& m) { return .144 * m.height; }

Bodice draft_bodice(const Measures& m, const BodiceEase& ease) {
  // They add up to half of the bust and its ease.
  const double back_width = m.bust / 8 + 5.5_cm + ease.bust / 2 * .2;
  const double front_width = .16 * m.bust + 1.9_cm + ease.bust / 2 * .3;
  const double armhole_width = .215 * m.bust - 7.4_cm + ease.bust / 2 * .5;
  const double nape = nape_to_waist(m);
  const double neck_width = m.bust / 20 + 2.2_cm;
  const double neck_rise = 2.3_cm;
  const double balance = m.bust / 10 - 4.2_cm;  // front neck point above the back's
  const double chest = nape - (m.bust / 10 + 9.0_cm) - ease.armhole;
  const double shoulder = 12.2_cm + .04 * (m.bust - 88.0_cm) + ease.shoulder - ease.neck;
  const double darts = ease.bust_dart ? balance - 1.5_cm : 0;
  const double front_neck = nape + neck_rise + (ease.bust_dart ? balance : balance / 3);

  const auto widened = [&](double height, double slope) {
    return Vector2d(neck_width + ease.neck * std::cos(slope), height - ease.neck * std::sin(slope));
  };
  Bodice out;
  out.back = half(back_width + .4 * armhole_width, chest, back_width, .62, widened(nape + neck_rise, back_slope),
                  nape - ease.neck * .3, shoulder, back_slope);
  out.front = half(front_width + .6 * armhole_width, chest + darts, front_width, .72, widened(front_neck, front_slope),
                   front_neck - neck_width - 1.2_cm - ease.front_neck, shoulder, front_slope);
  out.bust_point = {m.bust / 10 + .3_cm, nape + neck_rise + balance - (m.bust / 5 + 9.7_cm)};
  out.bust_dart = darts;
  return out;
}

double front_notch(const Bodice& bodice) { return .36 * length(bodice.front.armhole); }

std::vector<double> back_notches(const Bodice& bodice) {
  const double at = .4 * length(bodice.back.armhole);
  return {at, at + 1.0_cm};
}

Piece draft_sleeve(const Measures& m, const Bodice& bodice, const SleeveRule& rule) {
  const double width = m.upper_arm + rule.biceps_ease;
  const double front_length = length(bodice.front.armhole) + rule.cap_ease / 2;
  const double back_length = length(bodice.back.armhole) + rule.cap_ease / 2;
  // Half a cap from the underarm at `half` from the top's plumb line: hollow below, round above; the front more so.
  const auto half_cap = [](double half, double height, double hollow, double round) {
    return curve({half, 0}, {half * (1 - hollow), 0}, {half * round, height}, {0, height}, 14);
  };
  const auto front_half = [&](double half, double height) { return half_cap(half, height, .46, .52); };
  const auto back_half = [&](double half, double height) { return half_cap(half, height, .38, .56); };
  const auto wide = [](double target, double height, const auto& cap) {
    return solve(.2_cm, target, [&](double half) { return length(cap(half, height)) - target; });
  };
  const double height = solve(2.0_cm, .98 * std::min(front_length, back_length), [&](double h) {
    return wide(front_length, h, front_half) + wide(back_length, h, back_half) - width;
  });
  const double front = wide(front_length, height, front_half);
  const double back = wide(back_length, height, back_half);
  const double middle = (back - front) / 2;
  const double bottom = height - rule.length;
  const Vector2d hem_front(middle - rule.hem / 2, bottom), hem_back(middle + rule.hem / 2, bottom);
  const Line cap_back = back_half(back, height);
  const Line cap_front = reversed(mirrored(front_half(front, height)));
  std::vector<double> on_back;
  for (const double at : back_notches(bodice)) on_back.push_back(share_at(cap_back, at));

  Piece sleeve = piece("SLEEVE", {{"hem", {hem_front, hem_back}, rule.hem_allowance, true},
                                  {"seam_back", {hem_back, {back, 0}}},
                                  {"cap_back", cap_back, 10e-3, false, on_back},
                                  {"cap_front", cap_front, 10e-3, false, {0, 1 - share_at(cap_front, front_notch(bodice))}},
                                  {"seam_front", {{-front, 0}, hem_front}}});
  sleeve.mirrored_quantity = 1;
  sleeve.grainline = Grainline{{middle, bottom + .15 * rule.length}, {middle, height - .25 * rule.length}};
  return sleeve;
}

}  // namespace toile::drafting
