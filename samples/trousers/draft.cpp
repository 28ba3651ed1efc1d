// Drafts the trousers: straight legs, darts front and back, waistband. README.md beside this file gives the rules.
// Usage: draft_trousers FOLDER [SIZE]   writes FOLDER/trousers.dxf

#include <cmath>

#include "drafting.h"
#include "garment/units.h"

namespace {

using namespace toile;
using namespace toile::drafting;
using Eigen::Vector2d;

constexpr double band_height = 3.5_cm;
constexpr double waist_ease = 1.0_cm, hip_ease = 6.0_cm;

// Heights above the crotch line of the draft, m.
struct Levels {
  double waist, hip, knee, hem;
};

Levels levels(const Measures& m) {
  const double rise = .174 * m.height + 1.5_cm - band_height / 2;  // the band sits astride the waist
  return {rise, .03 * m.height, -.178 * m.height, -.385 * m.height};
}

// Half a pair of trousers, front or back: x from the crease, y from the crotch line; the crotch at x < 0, the side at x > 0.
struct Leg {
  double hip = 0;        // m, width on the hip line
  double extension = 0;  // m, of the crotch beyond it
  double knee = 0, hem = 0;
  double waist = 0, dart = 0, dart_length = 0, to_dart = 0;  // m; to_dart from the centre seam
  double centre_in = 0;                                      // m, by which the centre seam leans in at the waist
  double centre_up = 0;                                      // m, and is carried up beyond the waist line
  double side_up = 0;                                        // m, of the side's waist
  double crotch_down = 0;                                    // m, of the crotch's point below the line
  double hollow = 0;                                         // of the crotch curve, 0 .. 1
};

struct Outline {
  Line hem, side, waist_side, dart_outer, dart_inner, waist_centre, crotch, inseam;
};

Outline outline(const Leg& leg, const Levels& at) {
  const double middle = (leg.hip + leg.extension) / 2;  // the crease halves the width on the crotch line
  const Vector2d point(-middle, -leg.crotch_down), hip(middle, at.hip);
  const Vector2d knee_in(-leg.knee / 2, at.knee), knee_out(leg.knee / 2, at.knee);
  const Vector2d hem_in(-leg.hem / 2, at.hem), hem_out(leg.hem / 2, at.hem);
  const Vector2d centre_hip(leg.extension - middle, at.hip);
  const Vector2d centre(centre_hip.x() + leg.centre_in, at.waist + leg.centre_up);
  // The waist runs straight from the centre to the side at the side's height, as wide as the waist and its dart.
  const double wide = leg.waist + leg.dart, down = at.waist + leg.side_up - centre.y();
  const Vector2d side(centre.x() + std::sqrt(wide * wide - down * down), at.waist + leg.side_up);
  const Vector2d along = (side - centre) / wide;
  const Vector2d before = centre + leg.to_dart * along, after = before + leg.dart * along;
  const Vector2d dart_point = (before + after) / 2 + leg.dart_length * Vector2d(along.y(), -along.x());
  Outline out;
  out.hem = {hem_in, hem_out};
  const double rise = (side - hip).norm() / 3;
  const Vector2d lean = (side - hip).normalized();
  out.side =
      joined({hem_out, knee_out}, curve(knee_out, knee_out + .4 * (knee_out - hem_out), hip - Vector2d(0, 13.0_cm), hip, 12));
  out.side = joined(out.side, curve(hip, hip + rise * (Vector2d(0, 1) + lean).normalized(), side - rise * lean, side, 8));
  out.waist_side = {side, after};
  out.dart_outer = {after, dart_point};
  out.dart_inner = {dart_point, before};
  out.waist_centre = {before, centre};
  // Straight down the lean to the hip line, then round to the point.
  const Vector2d falls = (centre_hip - centre).normalized();
  out.crotch =
      joined({centre, centre_hip}, curve(centre_hip, centre_hip + leg.hollow * (centre_hip.y() - point.y()) * falls,
                                         point + leg.hollow * .85 * (centre_hip.x() - point.x()) * Vector2d(1, 0), point, 12));
  out.inseam = joined(curve(point, point + .3 * (knee_in - point) + Vector2d(.12 * (knee_in - point).x(), 0),
                            knee_in + .35 * (knee_in - hem_in), knee_in, 10),
                      {knee_in, hem_in});
  return out;
}

Leg front_leg(const Measures& m) {
  const double hip = (m.hip + hip_ease) / 4 - .5_cm, waist = (m.waist + waist_ease) / 4 + .5_cm;
  Leg leg{.hip = hip,
          .extension = m.hip / 20 + .5_cm,
          .knee = .25 * (m.thigh + m.hip * .35) + .2_cm,
          .waist = waist,
          .dart_length = 9.0_cm,
          .centre_in = .8_cm,
          .side_up = .5_cm,
          .hollow = .62};
  leg.hem = leg.knee - 1.5_cm;
  leg.dart = .38 * (hip - waist);
  leg.to_dart = .45 * waist;
  return leg;
}

// Side and inseam as long as the front's: the height of the side's waist and of the crotch's point see to it.
Leg back_leg(const Measures& m, const Levels& at) {
  const Outline front = outline(front_leg(m), at);
  const double waist = (m.waist + waist_ease) / 4 - .5_cm;
  Leg leg{.hip = (m.hip + hip_ease) / 4 + .5_cm,
          .extension = m.hip / 10 + 1.3_cm,
          .waist = waist,
          .dart_length = 12.0_cm,
          .to_dart = .48 * waist,
          .centre_in = 3.2_cm,
          .centre_up = 2.5_cm,
          .hollow = .6};
  leg.knee = front_leg(m).knee + 2.0_cm;
  leg.hem = leg.knee - 1.5_cm;
  leg.dart = .6 * (leg.hip - leg.centre_in - waist);
  leg.crotch_down = solve(-1.0_cm, 3.0_cm, [&](double down) {
    Leg trial = leg;
    trial.crotch_down = down;
    return length(outline(trial, at).inseam) - length(front.inseam);
  });
  leg.side_up = solve(-2.0_cm, 2.4_cm, [&](double up) {
    Leg trial = leg;
    trial.side_up = up;
    return length(outline(trial, at).side) - length(front.side);
  });
  return leg;
}

Piece trouser(const std::string& name, const Leg& leg, const Levels& at) {
  const Outline lines = outline(leg, at);
  const auto from_end = [](const Line& line, double distance) { return 1 - share_at(line, distance); };
  const double knee = at.knee - at.hem;
  const double crotch_point_to_notch = leg.extension + 3.0_cm;
  Piece out = piece(name, {{"hem", lines.hem, 4.0_cm, true},
                           {"side", lines.side, 1.0_cm, false, {share_at(lines.side, knee)}},
                           {"waist_side", lines.waist_side},
                           {"dart_outer", lines.dart_outer},
                           {"dart_inner", lines.dart_inner},
                           {"waist_centre", lines.waist_centre},
                           {"crotch", lines.crotch, 1.0_cm, false, {from_end(lines.crotch, crotch_point_to_notch)}},
                           {"inseam", lines.inseam, 1.0_cm, false, {from_end(lines.inseam, knee)}}});
  out.mirrored_quantity = 1;
  out.grainline = Grainline{{0, at.hem + 8.0_cm}, {0, -4.0_cm}};
  return out;
}

// Along the grain; its ends meet at centre back.
Piece waistband(double round) {
  const Vector2d a(0, 0), b(round, 0), c(round, band_height), d(0, band_height);
  Piece out = piece("WAISTBAND",
                    {{"bottom", {a, b}, 1.0_cm, false, {.25, .5, .75}}, {"right", {b, c}}, {"top", {c, d}}, {"left", {d, a}}});
  out.grainline = Grainline{{round * .3, band_height / 2}, {round * .7, band_height / 2}};
  return out;
}

std::vector<Piece> pieces(const Measures& m) {
  const Levels at = levels(m);
  return {trouser("FRONT", front_leg(m), at), trouser("BACK", back_leg(m, at), at), waistband(m.waist + waist_ease)};
}

}  // namespace

int main(int count, char** arguments) { return draft_program(count, arguments, "trousers", "TROUSERS", pieces); }
