// Drafts the sample skirt: n like gores and a straight waistband. README.md beside this file gives the rules.
// Usage: draft_gored_skirt FOLDER   writes FOLDER/gored_skirt.dxf

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "cut/cut.h"
#include "formats/formats.h"
#include "garment/units.h"

namespace {

using namespace toile;
using Eigen::Vector2d;

struct Measures {
  double waist = 70.0_cm, hip = 94.0_cm, waist_to_hip = 24.0_cm;  // size 38; the length as on the mannequin
  double length = 65.0_cm;                                        // waist to hem
  double waist_ease = 0.5_cm, hip_ease = 6.0_cm;
  double hem = 140.0_cm;  // round the hem, corner to corner
  double band = 4.0_cm;   // height; it sits astride the waist
  int gores = 8;
};

// `steps` + 1 points of the cubic Bezier curve over these four.
std::vector<Vector2d> curve(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d, int steps) {
  std::vector<Vector2d> points;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps, s = 1 - t;
    points.push_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
  }
  return points;
}

Vector2d mirrored(const Vector2d& p) { return {-p.x(), p.y()}; }

// The right half from its end on the centre line, mirrored and joined: right to left.
std::vector<Vector2d> both_halves(const std::vector<Vector2d>& right_to_centre) {
  std::vector<Vector2d> points = right_to_centre;
  for (std::size_t k = right_to_centre.size() - 1; k-- > 0;) points.push_back(mirrored(right_to_centre[k]));
  return points;
}

Edge edge(const std::string& id, const std::vector<Vector2d>& points, double allowance) {
  Edge out{id, {}, allowance, id == "hem"};
  for (std::size_t k = 0; k < points.size(); ++k) out.points.push_back({points[k], k == 0 || k + 1 == points.size(), {}});
  return out;
}

double length_to(const std::vector<Vector2d>& points, std::size_t end) {
  double sum = 0;
  for (std::size_t k = 1; k <= end; ++k) sum += (points[k] - points[k - 1]).norm();
  return sum;
}

// Centre line on x = 0, hip line on y = 0.
Piece gore(const Measures& m) {
  const double top_width = (m.waist + m.waist_ease) / m.gores;
  const double hip_half = (m.hip + m.hip_ease) / m.gores / 2;
  const double top_height = m.waist_to_hip - m.band / 2;
  const double below_hip = m.length - m.waist_to_hip;
  // Below the hip: straight, as long as the centre line, running out to the hem's width.
  const double flare = std::asin((m.hem / m.gores / 2 - hip_half) / below_hip);
  const Vector2d hip(hip_half, 0), hem_corner(m.hem / m.gores / 2, -below_hip * std::cos(flare));
  // Above the hip: leaves the hip along the flare and meets the waist at a lean half as great again as the chord's; the waist
  // is an arc square to both sides and exactly as long as the gore's share of the band.
  const double lean = 1.5 * std::atan((hip_half - top_width / 2) / top_height);
  const double radius = top_width / (2 * lean);
  const Vector2d top_corner(radius * std::sin(lean), top_height + radius * (1 - std::cos(lean)));
  const double reach = (top_corner - hip).norm() / 3;
  const auto hip_curve = curve(hip, hip + reach * Vector2d(-std::sin(flare), std::cos(flare)),
                               top_corner - reach * Vector2d(-std::sin(lean), std::cos(lean)), top_corner, 12);
  std::vector<Vector2d> right{hem_corner};
  right.insert(right.end(), hip_curve.begin(), hip_curve.end());
  std::vector<Vector2d> left;
  for (std::size_t k = right.size(); k-- > 0;) left.push_back(mirrored(right[k]));

  std::vector<Vector2d> half_top;
  constexpr int top_steps = 6;
  for (int k = 0; k <= top_steps; ++k) {
    const double angle = lean * (1 - static_cast<double>(k) / top_steps);
    half_top.push_back({radius * std::sin(angle), top_height + radius * (1 - std::cos(angle))});
  }
  // The hem: level on the centre line, square to the sides.
  const Vector2d hem_centre(0, -below_hip);
  const Vector2d knee(hem_corner.x() - (hem_corner.y() - hem_centre.y()) / std::tan(flare), hem_centre.y());
  auto hem = both_halves(
      curve(hem_corner, hem_corner + (knee - hem_corner) * 2 / 3, hem_centre + (knee - hem_centre) * 2 / 3, hem_centre, 8));
  for (Vector2d& p : hem) p = mirrored(p);

  Piece piece;
  piece.name = "GORE";
  piece.quantity = m.gores;
  piece.outline = {edge("hem", hem, 3.0_cm), edge("right", right, 1.0_cm), edge("top", both_halves(half_top), 1.0_cm),
                   edge("left", left, 1.0_cm)};
  const double hip_at = length_to(right, 1) / length_to(right, right.size() - 1);
  piece.notches = {{"right", hip_at, NotchKind::slit, 4.0_mm, 0}, {"left", 1 - hip_at, NotchKind::slit, 4.0_mm, 0}};
  piece.grainline = Grainline{{0, -below_hip * .8}, {0, top_height * .5}};
  piece.material = "SHELL";
  return piece;
}

// Cut along the grain; its ends meet at centre back.
Piece waistband(const Measures& m) {
  const double length = m.waist + m.waist_ease;
  const Vector2d a(0, 0), b(length, 0), c(length, m.band), d(0, m.band);
  Piece piece;
  piece.name = "WAISTBAND";
  piece.outline = {edge("bottom", {a, b}, 1.0_cm), edge("right", {b, c}, 1.0_cm), edge("top", {c, d}, 1.0_cm),
                   edge("left", {d, a}, 1.0_cm)};
  for (const double quarter : {.25, .5, .75}) piece.notches.push_back({"bottom", quarter, NotchKind::slit, 4.0_mm, 0});
  piece.grainline = Grainline{{length * .3, m.band / 2}, {length * .7, m.band / 2}};
  piece.material = "SHELL";
  return piece;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: draft_gored_skirt FOLDER\n");
    return 64;
  }
  try {
    Pattern skirt;
    skirt.name = "gored_skirt";
    skirt.style = "GORED SKIRT";
    skirt.sample_size = "38";
    skirt.pieces = {gore({}), waistband({})};
    write_dxf_aama(std::filesystem::path(arguments[1]) / "gored_skirt.dxf", lay_out(skirt));
  } catch (const std::exception& trouble) {
    std::fprintf(stderr, "%s\n", trouble.what());
    return 1;
  }
}
