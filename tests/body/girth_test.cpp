#include "body/girth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "body/shapes.h"

namespace toile {
namespace {

using std::numbers::pi;
const Eigen::Vector3d up = Eigen::Vector3d::UnitY();

// Prism over a counter-clockwise (seen from above: x right, z down the page) outline in the plane y = 0, from y = low to high.
test::Closed prism(const std::vector<Eigen::Vector2d>& outline, double low, double high) {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3i> faces;
  const int n = static_cast<int>(outline.size());
  for (const double y : {low, high})
    for (const Eigen::Vector2d& p : outline) points.emplace_back(p.x(), y, p.y());
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    faces.emplace_back(i, n + i, j), faces.emplace_back(j, n + i, n + j);
    if (i > 0 && j > 0) faces.emplace_back(0, i, j), faces.emplace_back(n, n + j, n + i);
  }
  return test::closed(points, faces);
}

std::vector<Eigen::Vector2d> polygon(int corners, double radius, const Eigen::Vector2d& centre = {0, 0}) {
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < corners; ++i)
    outline.push_back(centre + radius * Eigen::Vector2d(std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners)));
  return outline;
}

TEST(Girth, OfAPrismIsTheOutlineOfItsPolygon) {
  const test::Closed tube = prism(polygon(40, .2), 0, 1);
  const double expected = 2 * 40 * .2 * std::sin(pi / 40);
  for (const double y : {.1, .5, .999}) {
    EXPECT_NEAR(trunk_girth(tube.positions, tube.triangles, y, GirthKind::tape), expected, 1e-12);
    EXPECT_NEAR(trunk_girth(tube.positions, tube.triangles, y, GirthKind::contour), expected, 1e-12);
  }
}

TEST(Girth, OfASphereFollowsTheCircleAtItsHeight) {
  const test::Closed ball = test::sphere({0, 1, .05}, .3, 5);
  for (const double up_from_centre : {0., .1, -.2}) {
    const double expected = 2 * pi * std::sqrt(.09 - up_from_centre * up_from_centre);
    EXPECT_NEAR(trunk_girth(ball.positions, ball.triangles, 1 + up_from_centre), expected, 2e-3 * expected);
  }
}

TEST(Girth, OfAnEllipsoidIsTheEllipseOfRamanujan) {
  test::Closed egg = test::sphere({0, 0, 0}, 1, 6);
  egg.positions = Eigen::Vector3d(.17, .5, .11).asDiagonal() * egg.positions;
  const double a = .17, b = .11, h = (a - b) * (a - b) / ((a + b) * (a + b));
  const double expected = pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
  EXPECT_NEAR(trunk_girth(egg.positions, egg.triangles, 0), expected, 5e-4 * expected);
}

TEST(Girth, TapeBridgesTheHollowThatTheContourFollows) {
  // A square with a notch 10 cm deep and 10 cm wide: the contour is 20 cm longer than the taut tape.
  const test::Closed notched =
      prism({{.2, -.2}, {.2, .2}, {.05, .2}, {.05, .1}, {-.05, .1}, {-.05, .2}, {-.2, .2}, {-.2, -.2}}, 0, 1);
  EXPECT_NEAR(trunk_girth(notched.positions, notched.triangles, .5, GirthKind::tape), 1.6, 1e-12);
  EXPECT_NEAR(trunk_girth(notched.positions, notched.triangles, .5, GirthKind::contour), 1.8, 1e-12);
}

TEST(Girth, OfTheTrunkLeavesOutArmsBesideIt) {
  const test::Closed trunk = test::box({0, .5, 0}, {.15, .5, .1});
  const test::Closed left = test::box({.4, .5, 0}, {.2, .3, .3}), right = test::box({-.4, .5, 0}, {.2, .3, .3});
  const test::Closed body = test::both(trunk, test::both(left, right));
  EXPECT_NEAR(trunk_girth(body.positions, body.triangles, .45), 1.0, 1e-12);
}

TEST(Girth, OfTheTrunkIsNothingBetweenTheLegsOrBesideTheBody) {
  const test::Closed legs = test::both(test::box({.2, .5, 0}, {.1, .5, .1}), test::box({-.2, .5, 0}, {.1, .5, .1}));
  EXPECT_EQ(trunk_girth(legs.positions, legs.triangles, .5), 0);
  EXPECT_EQ(trunk_girth(legs.positions, legs.triangles, 1.5), 0);
}

TEST(Girth, OfALimbIsTakenAcrossTheBone) {
  test::Closed arm = prism(polygon(48, .045), -.3, .3);
  const double expected = 2 * 48 * .045 * std::sin(pi / 48);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.3, Eigen::Vector3d(.3, -.2, .9).normalized()).toRotationMatrix();
  const Eigen::Vector3d shift(.4, 1.2, .1);
  arm.positions = (turn * arm.positions).colwise() + shift;
  const Eigen::Vector3d along = turn * up;
  EXPECT_NEAR(limb_girth(arm.positions, arm.triangles, shift + .1 * along, along), expected, 1e-12);
  EXPECT_GT(limb_girth(arm.positions, arm.triangles, shift, (along + .5 * turn.col(0)).normalized()), 1.03 * expected);
}

TEST(Girth, OfALimbIsThatOfTheLoopRoundThePoint) {
  const test::Closed legs = test::both(prism(polygon(30, .08, {.12, 0}), 0, 1), prism(polygon(30, .05, {-.12, 0}), 0, 1));
  const auto around = [](double radius) { return 2 * 30 * radius * std::sin(pi / 30); };
  EXPECT_NEAR(limb_girth(legs.positions, legs.triangles, {.1, .5, .01}, up), around(.08), 1e-12);
  EXPECT_NEAR(limb_girth(legs.positions, legs.triangles, {-.1, .5, .01}, up), around(.05), 1e-12);
  EXPECT_NEAR(limb_girth(legs.positions, legs.triangles, {-.4, .5, 0}, up), around(.05), 1e-12) << "none round it: the nearest";
}

TEST(Girth, OfThighsThatTouchIsTakenOnOneSideOfTheMidplane) {
  const test::Closed both = test::box({0, .5, 0}, {.2, .5, .1});
  EXPECT_NEAR(limb_girth(both.positions, both.triangles, {.1, .5, 0}, up), .8, 1e-12);
  EXPECT_NEAR(limb_girth(both.positions, both.triangles, {-.1, .5, 0}, up), .8, 1e-12);
}

TEST(SectionLoops, RunCounterClockwiseSeenAgainstTheNormal) {
  const test::Closed ball = test::sphere({0, 0, 0}, 1, 3);
  for (const Eigen::Vector3d& normal : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(.6, 0, .8)}) {
    const auto loops = section_loops(ball.positions, ball.triangles, .1 * normal, normal);
    ASSERT_EQ(loops.size(), 1u);
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < loops[0].size(); ++i) area += loops[0][i].cross(loops[0][(i + 1) % loops[0].size()]) / 2;
    EXPECT_GT(area.dot(normal), 3.0);
  }
}

TEST(SectionLoops, ThroughVerticesAreCutOnce) {
  const test::Closed ball = test::sphere({0, 0, 0}, .3, 3);  // has vertices on its equator
  const auto loops = section_loops(ball.positions, ball.triangles, Eigen::Vector3d::Zero(), up);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(loop_girth(loops[0], up, GirthKind::contour), 2 * pi * .3, 1e-2);
}

TEST(Girth, AgreesWithTheMeasuresOfRealBodies) {
  const char* corpus = std::getenv("TOILE_CORPUS");
  if (!corpus) GTEST_SKIP() << "TOILE_CORPUS is not set";
  struct Known {
    const char* name;
    double height, girth;
  };
  std::ifstream in(std::filesystem::path(corpus) / "bodies" / "f38_168_A45.obj");
  ASSERT_TRUE(in) << "no body in TOILE_CORPUS";
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3i> faces;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v") {
      Eigen::Vector3d& p = points.emplace_back();
      words >> p.x() >> p.y() >> p.z();
    } else if (key == "f") {
      Eigen::Vector3i& f = faces.emplace_back();
      for (int k = 0; k < 3; ++k) {
        std::string corner;
        words >> corner;
        f(k) = std::stoi(corner) - 1;
      }
    }
  }
  const test::Closed body = test::closed(points, faces);
  for (const Known& known : {Known{"waist", 1.0501423728813561, .7002728791042492},
                             {"hip", .8064270296258441, .9401742487141419},
                             {"bust", 1.219205772595156, .8802673670694146},
                             {"high hip", .9282847012536002, .8032917876519376},
                             {"underbust", 1.1427657725951559, .7452345678158538},
                             {"seat", .8467416237006753, .9076019914426652}})
    EXPECT_NEAR(trunk_girth(body.positions, body.triangles, known.height), known.girth, 3e-3) << known.name;
  for (const Known& known : {Known{"thigh", .735143894958496, .5601249801939869},
                             {"knee", .45653053577766295, .34216249949333466},
                             {"calf", .33805482252625885, .3551086165521859},
                             {"ankle", .11974661108489763, .17702190617262287}})
    EXPECT_NEAR(limb_girth(body.positions, body.triangles, {.1, known.height, .03}, up), known.girth, 3e-3) << known.name;
  const Eigen::Vector3d shoulder(.16255, 1.34471, .02125), elbow(.33052, 1.17674, .02125);
  EXPECT_NEAR(limb_girth(body.positions, body.triangles, shoulder + .55 * (elbow - shoulder), elbow - shoulder),
              .28010325631148403, 3e-3);
}

}  // namespace
}  // namespace toile
