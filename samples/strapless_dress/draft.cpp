// Drafts the strapless dress: seven princess panels from above the bust to the knee. README.md beside this file gives the
// rules. Usage: draft_strapless_dress FOLDER [SIZE]   writes FOLDER/strapless_dress.dxf

#include <array>
#include <cmath>

#include "drafting.h"
#include "garment/units.h"

namespace {

using namespace toile;
using namespace toile::drafting;
using Eigen::Vector2d;

// From the hem up. A seam between two panels has the same length from level to level on both; on the centres the levels lie
// upright above each other.
constexpr std::size_t level_count = 7;
enum Level : std::size_t { hem, hip, high_hip, waist, underbust, bust, top };

struct Table {
  std::array<double, level_count> height, half_girth;  // m above the waist; m, half of the dress
  // Share of the half girth of centre front, side front, side back, centre back.
  std::array<std::array<double, 4>, level_count> share;
};

Table table_of(const Measures& m) {
  Table t;
  t.height = {-.33 * m.height, -.144 * m.height, -.072 * m.height, 0, .0565 * m.height, .103 * m.height, .135 * m.height};
  const double high = m.waist + .44 * (m.hip - m.waist);
  t.half_girth = {(m.hip + 16.0_cm) / 2,  (m.hip + 5.0_cm) / 2, (high + 3.0_cm) / 2,  (m.waist + 1.0_cm) / 2,
                  (m.bust - 12.0_cm) / 2, (m.bust + .5_cm) / 2, (m.bust - 1.5_cm) / 2};
  t.share = {{{.215, .285, .285, .215},
              {.215, .285, .285, .215},
              {.215, .285, .285, .215},
              {.215, .29, .275, .22},
              {.215, .28, .275, .23},
              {.215, .31, .255, .22},
              {.205, .30, .265, .23}}};
  return t;
}

// The seam's points on a panel `side` (+1 right, -1 left) of its middle line: as far out as half of its width, each level as
// far from the one below, along the seam, as the levels are apart.
Line seam_line(const Table& t, std::size_t panel, double side, bool half) {
  Line points(level_count);
  const auto out = [&](std::size_t k) { return side * t.half_girth[k] * t.share[k][panel] * (half ? 1 : .5); };
  points[waist] = {out(waist), 0};
  for (std::size_t k = waist + 1; k < level_count; ++k) {
    const double apart = t.height[k] - t.height[k - 1], across = out(k) - out(k - 1);
    points[k] = {out(k), points[k - 1].y() + std::sqrt(apart * apart - across * across)};
  }
  for (std::size_t k = waist; k-- > 0;) {
    const double apart = t.height[k + 1] - t.height[k], across = out(k + 1) - out(k);
    points[k] = {out(k), points[k + 1].y() - std::sqrt(apart * apart - across * across)};
  }
  // Drawn with a curved rule it is a little longer, and is taken back to the length it has to have.
  const double wanted = t.height[top] - t.height[hem];
  const auto scaled = [&](double by) {
    Line line = points;
    for (Vector2d& p : line) p.y() *= by;
    return through(line, 5);
  };
  return scaled(solve(.95, 1.05, [&](double by) { return length(scaled(by)) - wanted; }));
}

double waist_share(const Table& t) { return -t.height[hem] / (t.height[top] - t.height[hem]); }

std::vector<Draft> sides(const Table& t, std::size_t panel) {
  const Line right = seam_line(t, panel, 1, false), left = seam_line(t, panel, -1, false);
  const double notch = waist_share(t);
  // Hem and top square to the seams, as near as a shallow curve comes to it.
  const auto across = [](const Vector2d& a, const Vector2d& b, double sag) {
    const Vector2d third = (b - a) / 3, down(0, sag);
    return curve(a, a + third + down, b - third + down, b, 6);
  };
  return {{"hem", across(left.front(), right.front(), -.5_cm), 3.0_cm, true},
          {"right", right, 10e-3, false, {notch}},
          {"top", {right.back(), left.back()}},
          {"left", reversed(left), 10e-3, false, {1 - notch}}};
}

Piece side_panel(const std::string& name, const Table& t, std::size_t panel) {
  Piece out = piece(name, sides(t, panel));
  out.mirrored_quantity = 1;
  out.grainline = Grainline{{0, .7 * t.height[hem]}, {0, .5 * t.height[top]}};
  return out;
}

std::vector<Draft> centre_half(const Table& t, std::size_t panel) {
  const Line side = seam_line(t, panel, 1, true);
  const Vector2d low(0, t.height[hem] - .2_cm), high(0, side.back().y() + (panel == 0 ? .8_cm : -.4_cm));
  const double half = side.front().x();
  return {{"hem", curve(low, low + Vector2d(.4 * half, 0), side.front() - Vector2d(.3 * half, .15_cm), side.front(), 6), 3.0_cm,
           true},
          {"side", side, 10e-3, false, {waist_share(t)}},
          {"top", {side.back(), high}},
          {"centre", {high, low}}};
}

Piece centre_front(const Table& t) {
  std::vector<Draft> half = centre_half(t, 0);
  half.pop_back();
  Piece out = piece("CENTRE FRONT", whole(half, "_left", "_right"));
  out.grainline = Grainline{{0, .7 * t.height[hem]}, {0, .5 * t.height[top]}};
  return out;
}

Piece centre_back(const Table& t) {
  Piece out = piece("CENTRE BACK", centre_half(t, 3));
  out.mirrored_quantity = 1;
  out.grainline = Grainline{{2.0_cm, .7 * t.height[hem]}, {2.0_cm, .5 * t.height[top]}};
  return out;
}

std::vector<Piece> pieces(const Measures& m) {
  const Table t = table_of(m);
  return {centre_front(t), side_panel("SIDE FRONT", t, 1), side_panel("SIDE BACK", t, 2), centre_back(t)};
}

}  // namespace

int main(int count, char** arguments) { return draft_program(count, arguments, "strapless_dress", "STRAPLESS DRESS", pieces); }
