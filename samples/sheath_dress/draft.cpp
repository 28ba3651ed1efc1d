// Drafts the sheath dress: bodice with bust and waist darts, darted skirt with a slit, sleeves. README.md beside this file
// gives the rules. Usage: draft_sheath_dress FOLDER [SIZE]   writes FOLDER/sheath_dress.dxf

#include <cmath>

#include "bodice_block.h"
#include "garment/units.h"

namespace {

using namespace toile;
using namespace toile::drafting;
using Eigen::Vector2d;

constexpr double waist_ease = 2.5_cm, hip_ease = 5.0_cm, forward = 1.0_cm;  // by which the front is wider at the waist
constexpr double centre_back = .8_cm;                                       // taken in at the waist

struct WaistShares {
  double front, back;                // m, half the front, half the back, darts closed
  double front_centre, back_centre;  // m, from the centre to the dart
};

WaistShares waist_shares(const Measures& m, const Bodice& block, double front_dart) {
  const double quarter = (m.waist + waist_ease) / 4;
  return {quarter + forward, quarter - forward, block.bust_point.x() - front_dart / 2, .42 * (quarter - forward)};
}

// `width` wide, centred on `foot`, its point at `point`: both legs as long.
struct Dart {
  Vector2d before, point, after;
};

// Edges of a waist line from the centre to the side with a dart, as they lie on the piece.
std::vector<Draft> waist_with_dart(const Vector2d& centre, const Vector2d& side, const Dart& dart) {
  return {{"waist_centre", {centre, dart.before}},
          {"waist_dart_inner", {dart.before, dart.point}},
          {"waist_dart_outer", {dart.point, dart.after}},
          {"waist_side", {dart.after, side}}};
}

void append(std::vector<Draft>& outline, const std::vector<Draft>& more) {
  outline.insert(outline.end(), more.begin(), more.end());
}

std::vector<Draft> upwards(std::vector<Draft> edges) {
  std::vector<Draft> out(edges.rbegin(), edges.rend());
  for (Draft& edge : out) edge.line = reversed(edge.line);
  return out;
}

double bodice_front_dart(const Measures& m, const Bodice& block) {
  return .64 * (block.front.side - ((m.waist + waist_ease) / 4 + forward));
}

Piece bodice_front(const Measures& m, const Bodice& block) {
  const double intake = bodice_front_dart(m, block);
  const WaistShares waist = waist_shares(m, block, intake);
  const Vector2d side(waist.front + intake, 0), underarm = block.front.underarm();
  const double x = block.bust_point.x();
  const Dart dart{{x - intake / 2, 0}, block.bust_point - Vector2d(0, 2.0_cm), {x + intake / 2, 0}};
  // The bust dart lies square to the side seam, its point 2.5 cm before the bust's.
  const Vector2d point = block.bust_point + Vector2d(2.5_cm, 0), up = (underarm - side).normalized();
  const Vector2d foot = side + up * up.dot(point - side);
  const Vector2d low = foot - up * block.bust_dart / 2, high = foot + up * block.bust_dart / 2;
  std::vector<Draft> half = waist_with_dart({0, 0}, side, dart);
  append(half, {{"side_low", {side, low}},
                {"bust_dart_low", {low, point}},
                {"bust_dart_high", {point, high}},
                {"side_high", {high, underarm}},
                {"armhole", block.front.armhole, 10e-3, false, {share_at(block.front.armhole, front_notch(block))}},
                {"shoulder", block.front.shoulder},
                {"neck", block.front.neck, .7_cm}});
  Piece out = piece("BODICE FRONT", whole(half, "_left", "_right"));
  out.grainline = Grainline{{0, 3.0_cm}, {0, block.bust_point.y() + 5.0_cm}};
  return out;
}

Piece bodice_back(const Measures& m, const Bodice& block) {
  const WaistShares waist = waist_shares(m, block, bodice_front_dart(m, block));
  const Vector2d underarm = block.back.underarm();
  const double intake = .55 * (underarm.x() - waist.back - centre_back);
  const Vector2d centre(centre_back, 0), side(centre_back + waist.back + intake, 0), nape = block.back.neck.back();
  const double x = centre_back + waist.back_centre;
  const Dart dart{{x, 0}, {x + intake / 2, underarm.y() - 2.0_cm}, {x + intake, 0}};
  std::vector<Draft> outline = waist_with_dart(centre, side, dart);
  std::vector<double> on_armhole;
  for (const double at : back_notches(block)) on_armhole.push_back(share_at(block.back.armhole, at));
  const Line middle = curve(nape, {0, .6 * nape.y()}, {.35 * centre_back, .3 * nape.y()}, centre, 8);
  append(outline, {{"side", {side, underarm}},
                   {"armhole", block.back.armhole, 10e-3, false, on_armhole},
                   {"shoulder", block.back.shoulder},
                   {"neck", block.back.neck, .7_cm},
                   {"centre", middle, 2.0_cm, false, {.5}}});
  Piece out = piece("BODICE BACK", outline);
  out.mirrored_quantity = 1;
  out.grainline = Grainline{{3.0_cm, 3.0_cm}, {3.0_cm, underarm.y() + 6.0_cm}};
  return out;
}

struct SkirtShape {
  double hip = 0, hem = 0;        // m, half widths
  double depth = 0, length = 0;   // m, waist to where the side is full, waist to hem
  double waist = 0, to_dart = 0;  // m, half, dart closed; centre to dart
  double dart = 0, dart_depth = 0;
  double in = 0;         // m, at the centre's waist
  double rise = 1.0_cm;  // of the side's waist above the centre's
};

// From the hem up the side, along the waist to the centre.
std::vector<Draft> skirt_half(const SkirtShape& s) {
  const Vector2d hip(s.hip, -s.depth), bottom(s.hem, -s.length);
  // Two straight parts of the waist, the outer steeper, each of its length; the dart's legs are as long as each other.
  const double slope = std::asin(s.rise / (s.waist + s.dart));
  const Vector2d along(std::cos(slope), std::sin(slope));
  const Vector2d centre(s.in, 0), before = centre + s.to_dart * along, after = before + s.dart * along;
  const Vector2d side = after + (s.waist - s.to_dart) * along;
  const Vector2d point = (before + after) / 2 + s.dart_depth * Vector2d(std::sin(slope), -std::cos(slope));
  // Nearly straight, as the body widens evenly from the waist to the hip; it turns into the side below there.
  const Vector2d below = (hip - bottom).normalized(), lean = (side - hip).normalized();
  const Vector2d turn = (below + 2 * lean).normalized();
  const double reach = (side - hip).norm() / 3;
  const Line flank = joined({bottom, hip}, curve(hip, hip + reach * turn, side - reach * lean, side, 12));
  std::vector<Draft> half{{"hem", {{0, -s.length}, bottom}, 3.0_cm, true},
                          {"side", flank, 10e-3, false, {share_at(flank, (hip - bottom).norm())}}};
  append(half, upwards(waist_with_dart(centre, side, {before, point, after})));
  return half;
}

SkirtShape skirt_front_shape(const Measures& m, const Bodice& block) {
  const WaistShares waist = waist_shares(m, block, bodice_front_dart(m, block));
  const double hip = (m.hip + hip_ease) / 4 + .5_cm;
  return {.hip = hip,
          .hem = hip - .7_cm,
          .depth = waist_to_hip(m),
          .length = .34 * m.height,
          .waist = waist.front,
          .to_dart = waist.front_centre,
          .dart = .38 * (hip - waist.front),
          .dart_depth = 12.0_cm};
}

Piece skirt_front(const Measures& m, const Bodice& block) {
  Piece out = piece("SKIRT FRONT", whole(skirt_half(skirt_front_shape(m, block)), "_left", "_right"));
  out.grainline = Grainline{{0, -.3 * m.height}, {0, -.05 * m.height}};
  return out;
}

// The side's waist as high as makes the side seam as long as the front's.
Piece skirt_back(const Measures& m, const Bodice& block) {
  const WaistShares waist = waist_shares(m, block, bodice_front_dart(m, block));
  SkirtShape shape = skirt_front_shape(m, block);
  const double front_side = length(skirt_half(shape)[1].line);
  shape.hip -= 1.0_cm;
  shape.hem -= 1.0_cm;
  shape.waist = waist.back;
  shape.to_dart = waist.back_centre;
  shape.dart = .56 * (shape.hip - waist.back - centre_back);
  shape.dart_depth = 15.0_cm;
  shape.in = centre_back;
  shape.rise = solve(0, 3.0_cm, [&](double rise) {
    SkirtShape trial = shape;
    trial.rise = rise;
    return length(skirt_half(trial)[1].line) - front_side;
  });
  std::vector<Draft> outline = skirt_half(shape);
  const Line middle = joined(curve({centre_back, 0}, {.5 * centre_back, -6.0_cm}, {0, -9.0_cm}, {0, -14.0_cm}, 6),
                             {{0, -14.0_cm}, {0, -shape.length}});
  outline.push_back({"centre", middle, 2.0_cm, false, {share_at(middle, 39.0_cm)}});  // the slit begins there
  Piece out = piece("SKIRT BACK", outline);
  out.mirrored_quantity = 1;
  out.grainline = Grainline{{3.0_cm, -.3 * m.height}, {3.0_cm, -.05 * m.height}};
  return out;
}

std::vector<Piece> pieces(const Measures& m) {
  const Bodice block = draft_bodice(m, {.bust = 6.0_cm, .front_neck = 1.0_cm, .neck = 1.5_cm});
  return {
      bodice_front(m, block), bodice_back(m, block), skirt_front(m, block), skirt_back(m, block),
      draft_sleeve(
          m, block,
          {.biceps_ease = 5.5_cm, .cap_ease = 2.0_cm, .length = .21 * m.height, .hem = (m.upper_arm + m.wrist) / 2 + 4.5_cm})};
}

}  // namespace

int main(int count, char** arguments) { return draft_program(count, arguments, "sheath_dress", "SHEATH DRESS", pieces); }
