#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "edit/operation.h"
#include "geometry/surface_distance.h"
#include "style/synthetic_skirt.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

constexpr double pi = std::numbers::pi;

// A tube of upright strips round the body of the synthetic skirt, as if it floated there.
struct Tube {
  double radius = 0.30, top = 1.20, bottom = 0.50;  // m
  int panels = 4;
};

WornGarment worn(const Tube& tube) {
  const double width = 2 * pi * tube.radius / tube.panels, height = tube.top - tube.bottom;
  Piece piece;
  piece.name = "strip";
  piece.quantity = tube.panels;
  const auto edge = [&](const char* id, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    piece.outline.push_back({id, {{from, true, {}}, {to, true, {}}}, {}, false});
  };
  edge("hem", {0, 0}, {width, 0});
  edge("side_right", {width, 0}, {width, height});
  edge("top", {width, height}, {0, height});
  edge("side_left", {0, height}, {0, 0});
  piece.notches.push_back({"side_right", 0.25});
  piece.notches.push_back({"side_right", 0.9});
  piece.grainline = Grainline{{width / 2, 0.1 * height}, {width / 2, 0.9 * height}};
  WornGarment garment;
  garment.pattern.name = "tube";
  garment.pattern.pieces = {piece};
  for (int i = 1; i <= tube.panels; ++i)
    garment.pattern.seams.push_back({"side " + std::to_string(i),
                                     {"strip", i, "side_right", 0, 1},
                                     {"strip", i % tube.panels + 1, "side_left", 1, 0},
                                     false});
  garment.edge_length = 25e-3;
  garment.garment = sew(garment.pattern, triangulate(garment.pattern, {.edge_length = garment.edge_length}));
  garment.drape.resize(3, garment.garment.vertex_count);
  for (std::size_t p = 0; p < garment.garment.panels.size(); ++p)
    for (Eigen::Index v = 0; v < garment.garment.panels[p].rest.cols(); ++v) {
      const Eigen::Vector2d at = garment.garment.panels[p].rest.col(v);
      const double angle = (static_cast<double>(p) + at.x() / width) * 2 * pi / tube.panels;
      garment.drape.col(garment.garment.welded[p](v)) << tube.radius * std::sin(angle), tube.bottom + at.y(),
          tube.radius * std::cos(angle);
    }
  return garment;
}

const Body& body() {
  static const Body one = make_body(testing::elliptical_body({}));
  return one;
}

Target mixed(const Tube& first, const Tube& second, EditArguments arguments) {
  const WornGarment own = worn(first);
  arguments["with"] = "other";
  return find_operation("mix").apply(
      {own.pattern,
       own.garment,
       own.drape,
       body(),
       {},
       [&](const std::string&, const Body&, const std::string&) { return std::make_shared<const WornGarment>(worn(second)); }},
      arguments);
}

Finding refusal(const Tube& first, const Tube& second, const EditArguments& arguments) {
  try {
    mixed(first, second, arguments);
  } catch (const BadInput& bad) {
    return bad.finding();
  }
  return {};
}

double radius(const Eigen::Vector3d& at) { return std::hypot(at.x(), at.z()); }

// "hip" is 0.83 m above the floor.
TEST(Mix, CoaxialCylindersOfOneRadiusMakeOneCylinder) {
  const Target target = mixed({.panels = 4}, {.top = 1.0, .bottom = 0.4, .panels = 4}, {{"loop", "hip"}});
  ASSERT_TRUE(target.pattern);
  check(target.garment);
  ASSERT_EQ(target.positions.cols(), target.garment.vertex_count);
  EXPECT_NEAR(target.positions.row(1).maxCoeff(), 1.20, 1e-3);
  EXPECT_NEAR(target.positions.row(1).minCoeff(), 0.40, 1e-3);
  for (Eigen::Index v = 0; v < target.positions.cols(); ++v) EXPECT_NEAR(radius(target.positions.col(v)), 0.30, 1.5e-3);
  double area = 0;
  for (const Piece& piece : target.pattern->pieces) area += copies(piece) * signed_area(piece);
  EXPECT_NEAR(area, 2 * pi * 0.30 * 0.80, 2e-3);
}

TEST(Mix, KeepsNotchesGrainAndSeamsOfBothParts) {
  const Target target = mixed({.panels = 4}, {.top = 1.0, .bottom = 0.4, .panels = 6}, {{"loop", "hip"}});
  const Pattern& pattern = *target.pattern;
  ASSERT_EQ(pattern.pieces.size(), 2u);
  for (const Piece& piece : pattern.pieces) {
    EXPECT_EQ(piece.notches.size(), 1u) << piece.name;  // one of the two is on the other side of the cut
    EXPECT_TRUE(piece.grainline) << piece.name;
    ASSERT_TRUE(find_edge(piece, "mix")) << piece.name;
    EXPECT_TRUE(is_straight(*find_edge(piece, "mix"))) << piece.name;
  }
  int sides = 0;
  double joint = 0;
  for (const Seam& seam : pattern.seams) {
    EXPECT_NEAR(span_length(pattern, seam.a), span_length(pattern, seam.b), 1e-4) << seam.name;
    if (seam.a.edge == "mix")
      joint += span_length(pattern, seam.a);
    else
      ++sides;
  }
  EXPECT_EQ(sides, 10);
  EXPECT_NEAR(joint, 2 * pi * 0.30, 1e-3);
}

TEST(Mix, CylindersOfTwoRadiiMeetBetweenThem) {
  const Target target = mixed({.radius = 0.30, .panels = 4}, {.radius = 0.32, .panels = 6}, {{"loop", "hip"}});
  for (const int v : target.held) EXPECT_NEAR(radius(target.positions.col(v)), 0.31, 2e-3);
  const Pattern& pattern = *target.pattern;
  double joint[2] = {0, 0};
  for (const Seam& seam : pattern.seams) {
    if (seam.a.edge != "mix") continue;
    joint[0] += span_length(pattern, seam.a);
    joint[1] += span_length(pattern, seam.b);
  }
  EXPECT_NEAR(joint[0], joint[1], 2e-3);
  EXPECT_NEAR(joint[0], 2 * pi * 0.31, 0.01);
}

TEST(Mix, OfAGarmentWithItselfIsItself) {
  const Target target = mixed({}, {}, {{"loop", "hip"}});
  const WornGarment own = worn({});
  EXPECT_LT((target.positions - target.source).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(surface_distance({target.positions, target.garment.triangles}, {own.drape, own.garment.triangles}).hausdorff, 1e-3);
}

TEST(Mix, KeepsWhatIsBeyondWhenAsked) {
  const Target target = mixed({.panels = 4}, {.top = 1.1, .bottom = 0.6, .panels = 6}, {{"loop", "hip"}, {"keep", "beyond"}});
  EXPECT_NEAR(target.positions.row(1).maxCoeff(), 1.1, 1e-3);
  EXPECT_NEAR(target.positions.row(1).minCoeff(), 0.5, 1e-3);
}

TEST(Mix, SewsWholeGarmentsTogetherAtTheirEdges) {
  const Target target = mixed({.bottom = 0.9}, {.top = 0.88, .panels = 5}, {{"loop", "hem"}});
  EXPECT_EQ(target.pattern->pieces.size(), 2u);
  EXPECT_NEAR(target.positions.row(1).minCoeff(), 0.5, 5e-3);
  for (const int v : target.held) EXPECT_NEAR(target.positions(1, v), 0.89, 1e-3);
}

TEST(Mix, TakesALoopOfTheOtherGarmentByName) {
  const Target target =
      mixed({.bottom = 0.9}, {.top = 0.75, .bottom = 0.4, .panels = 5}, {{"loop", "hem"}, {"other_loop", "top"}});
  for (const int v : target.held) EXPECT_NEAR(target.positions(1, v), 0.825, 1e-3);
}

TEST(Mix, FindsTheBestPlaceInARegion) {
  // Both are cylinders of one radius: any level is as good, so the cut is no longer than a level one.
  const Target target = mixed({}, {.panels = 6}, {{"region", "spine_low:0.9..hip"}});
  for (const int v : target.held) {
    EXPECT_LT(target.positions(1, v), 1.04);
    EXPECT_GT(target.positions(1, v), 0.82);
  }
}

TEST(Mix, RefusesWhatCannotBeMeant) {
  EXPECT_EQ(refusal({}, {.top = 0.5, .bottom = 0.3}, {{"loop", "hip"}}).code, "edit.no-overlap");
  EXPECT_EQ(refusal({}, {}, {{"loop", "hip"}, {"keep", "left"}}).code, "edit.bad-side");
  EXPECT_EQ(refusal({}, {}, {{"region", "hip"}}).code, "edit.bad-region");
  EXPECT_EQ(refusal({}, {}, {{"region", "hip..waist"}}).code, "edit.bad-region");
  EXPECT_EQ(refusal({}, {}, {{"region", "waist..hip"}, {"other_loop", "hem"}}).code, "edit.two-parameters");
  EXPECT_EQ(refusal({}, {}, {{"loop", "hem"}, {"keep", "beyond"}}).code, "edit.nothing-left");
}

}  // namespace
}  // namespace toile
