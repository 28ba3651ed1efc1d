// Parts that a T-shirt does not have, sewn to one: a hood, a stand collar, a flounce gathered to half its length.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "body/parametric.h"
#include "drape/dress.h"
#include "formats/formats.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

Piece polygon(const std::string& name, const Corners& corners, double turned_about_y, const Eigen::Vector3d& to) {
  Piece piece;
  piece.name = name;
  for (std::size_t k = 0; k < corners.size(); ++k)
    piece.outline.push_back(
        {"e" + std::to_string(k), {{corners[k], true, {}}, {corners[(k + 1) % corners.size()], true, {}}}, {}, false});
  piece.placement = {Placement{Eigen::AngleAxisd(turned_about_y, Eigen::Vector3d::UnitY()).toRotationMatrix(), to}};
  return piece;
}

EdgeSpan run(const std::string& piece, const std::string& edge, double from = 0, double to = 1) {
  return {piece, 1, edge, from, to};
}

// Right sides together: the end of one run meets the beginning of the other.
void sew(Pattern& pattern, const std::string& name, const EdgeSpan& a, const EdgeSpan& b) {
  pattern.seams.push_back({name, a, {b.piece, b.copy, b.edge, b.end, b.begin}, false});
}

struct Made {
  Pattern pattern;
  double front_neck, back_neck, front_hem, back_hem;  // m
};

Made t_shirt() {
  const std::filesystem::path dxf = TOILE_SOURCE_DIR "/samples/t_shirt/t_shirt.dxf";
  Made made{value_or_throw(read_pattern(dxf, {std::nullopt, seams_beside(dxf)})), 0, 0, 0, 0};
  const auto at = [&](const char* piece, const char* edge) {
    return length(*find_edge(*find_piece(made.pattern, piece), edge));
  };
  made.front_neck = at("FRONT", "neck"), made.back_neck = at("BACK", "neck");
  made.front_hem = at("FRONT", "hem"), made.back_hem = at("BACK", "hem");
  return made;
}

Body body_38() {
  return make_body(
      build_mannequin(value_or_throw(read_size_chart_row(TOILE_SOURCE_DIR "/templates/mannequins/women.csv", "38"))));
}

void expect_dressed(const Pattern& pattern, std::size_t openings) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "takes minutes under a sanitizer";
#endif
  const Body body = body_38();
  const Dressed dressed = dress(pattern, sew(pattern, triangulate(pattern, {.edge_length = .025})), body);
  for (const Finding& finding : dressed.report.findings) EXPECT_NE(finding.severity, Severity::error) << in_words(finding);
  EXPECT_TRUE(dressed.links_ok);
  EXPECT_EQ(dressed.self_intersections, 0);
  EXPECT_LT(dressed.seam_gap, 2e-3);
  EXPECT_EQ(dressed.openings.size(), openings);
}

constexpr double quarter = std::numbers::pi / 2;

TEST(DressedParts, AHoodGoesOverTheHead) {
  auto [pattern, front, back, front_hem, back_hem] = t_shirt();
  const double half = (front + back) / 4, from_back = back / 2;
  // Beside the head, x to the front on the right and to the back on the left: back neck, front neck, face, crown, back.
  Corners right{{-half, 0}, {-half + from_back, -.01}, {half, 0}, {half, .36}, {-half + .06, .38}, {-half, .28}};
  Corners left;
  for (std::size_t k = right.size(); k-- > 0;) left.push_back({-right[k].x(), right[k].y()});
  pattern.pieces.push_back(polygon("HOOD_RIGHT", right, -quarter, {-.16, 1.42, .02}));
  pattern.pieces.push_back(polygon("HOOD_LEFT", left, quarter, {.16, 1.42, .02}));
  const auto mate = [](std::size_t edge) { return "e" + std::to_string((10 - edge) % 6); };
  sew(pattern, "right front neck", run("HOOD_RIGHT", "e1"), run("FRONT", "neck", .5, 1));
  sew(pattern, "left front neck", run("HOOD_LEFT", mate(1)), run("FRONT", "neck", 0, .5));
  sew(pattern, "right back neck", run("HOOD_RIGHT", "e0"), run("BACK", "neck", 0, .5));
  sew(pattern, "left back neck", run("HOOD_LEFT", mate(0)), run("BACK", "neck", .5, 1));
  for (const std::size_t edge : {3, 4})
    sew(pattern, "crown", run("HOOD_RIGHT", "e" + std::to_string(edge)), run("HOOD_LEFT", mate(edge)));
  sew(pattern, "centre back", run("HOOD_RIGHT", "e5"), run("HOOD_LEFT", mate(5)));
  expect_dressed(pattern, 4);  // hem, sleeves, face
}

TEST(DressedParts, ACollarStandsRoundTheNeck) {
  auto [pattern, front, back, front_hem, back_hem] = t_shirt();
  const auto strip = [](double length) {
    return Corners{{-length / 2, 0}, {length / 2, 0}, {.47 * length, .04}, {-.47 * length, .04}};
  };
  pattern.pieces.push_back(polygon("COLLAR_FRONT", strip(front), 0, {0, 1.38, .22}));
  pattern.pieces.push_back(polygon("COLLAR_BACK", strip(back), 2 * quarter, {0, 1.41, -.18}));
  sew(pattern, "front neck", run("COLLAR_FRONT", "e0"), run("FRONT", "neck"));
  sew(pattern, "back neck", run("COLLAR_BACK", "e0"), run("BACK", "neck"));
  sew(pattern, "left end", run("COLLAR_FRONT", "e1"), run("COLLAR_BACK", "e3"));
  sew(pattern, "right end", run("COLLAR_FRONT", "e3"), run("COLLAR_BACK", "e1"));
  expect_dressed(pattern, 4);  // hem, sleeves, neck
}

TEST(DressedParts, AFlounceIsGatheredToHalfItsLength) {
  auto [pattern, front, back, front_hem, back_hem] = t_shirt();
  const auto strip = [](double length) { return Corners{{-length, 0}, {length, 0}, {length, .25}, {-length, .25}}; };
  pattern.pieces.push_back(polygon("FLOUNCE_FRONT", strip(front_hem), 0, {0, .52, .32}));
  pattern.pieces.push_back(polygon("FLOUNCE_BACK", strip(back_hem), 2 * quarter, {0, .52, -.28}));
  sew(pattern, "front hem", run("FLOUNCE_FRONT", "e2"), run("FRONT", "hem"));
  sew(pattern, "back hem", run("FLOUNCE_BACK", "e2"), run("BACK", "hem"));
  sew(pattern, "left end", run("FLOUNCE_FRONT", "e1"), run("FLOUNCE_BACK", "e3"));
  sew(pattern, "right end", run("FLOUNCE_FRONT", "e3"), run("FLOUNCE_BACK", "e1"));
  expect_dressed(pattern, 4);  // hem, sleeves, neck
}

}  // namespace
}  // namespace toile
