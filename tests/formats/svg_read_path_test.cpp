#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formats/svg_read/path.h"
#include "formats/svg_read/style.h"

namespace toile::svg {
namespace {

using Eigen::Vector2d;

std::vector<Vector2d> ends(const std::string& data) {
  std::vector<Vector2d> points;
  const PathData path = path_of(data);
  EXPECT_FALSE(path.broken) << data;
  for (const SubPath& part : path.parts) {
    if (!part.segments.empty()) points.push_back(part.segments.front().from);
    for (const Segment& s : part.segments) points.push_back(s.to);
  }
  return points;
}

double radius_off(const std::string& data, const Vector2d& centre, double radius) {
  double worst = 0;
  for (const SubPath& part : path_of(data).parts)
    for (const Vector2d& p : sampled(part, Affine::Identity(), 1e-6).points)
      worst = std::max(worst, std::abs((p - centre).norm() - radius));
  return worst;
}

TEST(SvgPath, RelativeAndAbsoluteCommandsAndRepeatsMeanTheSame) {
  const std::vector<Vector2d> square{{1, 1}, {4, 1}, {4, 5}, {1, 5}, {1, 1}};
  for (const char* data : {"M1,1 L4,1 L4,5 L1,5 Z", "M1 1 4 1 4 5 1 5z", "m1 1 3 0 0 4-3 0z", "M1,1H4V5H1Z", "m1,1h3v4h-3z",
                           "M1-0 m0 1 l3,0 0,4 -3,0 Z"})
    EXPECT_EQ(ends(data), square) << data;
}

TEST(SvgPath, NumbersMayStandWithoutBlanks) {
  EXPECT_EQ(ends("M.5.5-1-.5"), (std::vector<Vector2d>{{.5, .5}, {-1, -.5}}));
  EXPECT_EQ(ends("M1e1,2E-1L-.5e+1+3"), (std::vector<Vector2d>{{10, .2}, {-5, 3}}));
}

TEST(SvgPath, MovesAfterCloseBeginAtTheStart) {
  const PathData path = path_of("M1 1 h2 v2 z l5 5 M0 0 L1 0");
  ASSERT_EQ(path.parts.size(), 3u);
  EXPECT_TRUE(path.parts[0].closed);
  EXPECT_EQ(path.parts[1].segments.front().from, Vector2d(1, 1));
}

TEST(SvgPath, ArcsAreCircles) {
  EXPECT_LT(radius_off("M1,0 A1,1 0 0 1 0,1 A1 1 0 0 1 -1 0 A1 1 0 1 1 1 0", {0, 0}, 1), 3e-6);
  EXPECT_LT(radius_off("M1,0a1,1 0 01-1,1", {0, 0}, 1), 3e-6);  // flags glued to what follows
  EXPECT_LT(radius_off("M1,0a1,1 0 11-2 0", {0, 0}, 1), 3e-6);
  EXPECT_LT(radius_off("M1,0 A.1,.1 0 0 1 -1,0", {0, 0}, 1), 3e-6);  // radii too small are enlarged
}

TEST(SvgPath, ARotatedEllipseLiesOnItsEquation) {
  const PathData path = path_of("M2,0 A 2 1 0 1 1 -2,0 A 2 1 0 1 1 2 0");
  double length = 0;
  for (const SubPath& part : path.parts) {
    const Sampled line = sampled(part, Affine(Eigen::Rotation2Dd(.5)), 1e-5);
    EXPECT_TRUE(line.closed);
    Points<2> loop = line.points;
    loop.push_back(loop.front());
    length += polyline_length<2>(loop);
    for (const Vector2d& p : line.points) {
      const Vector2d q = Eigen::Rotation2Dd(-.5) * p;
      EXPECT_NEAR(q.x() * q.x() / 4 + q.y() * q.y(), 1, 5e-5);
    }
  }
  EXPECT_NEAR(length, 9.68844822, 1e-3);
}

TEST(SvgPath, SmoothCommandsMirrorTheLastHandle) {
  const PathData s = path_of("M0 0 C0 1 1 1 2 0 S 4 -1 4 0"), t = path_of("M0 0 Q1 1 2 0 T4 0");
  EXPECT_EQ(s.parts[0].segments[1].c1, Vector2d(3, -1));
  const Segment& q = t.parts[0].segments[1];
  EXPECT_NEAR((q.c1 - (Vector2d(2, 0) + 2.0 / 3 * Vector2d(1, -1))).norm(), 0, 1e-12);
  EXPECT_EQ(path_of("M0 0 S 1 1 2 0").parts[0].segments[0].c1, Vector2d(0, 0));
}

TEST(SvgPath, WhatIsBrokenKeepsItsBeginning) {
  for (const char* data : {"M0 0 L1 0 L1", "M0 0 L1 0 X 3", "M0 0 L1 0 Q 1 1 2", "M0 0 L1 0 A 1 1 0 2 0 3 3"}) {
    const PathData path = path_of(data);
    EXPECT_TRUE(path.broken) << data;
    ASSERT_EQ(path.parts.size(), 1u) << data;
    EXPECT_EQ(path.parts[0].segments.size(), 1u) << data;
  }
  EXPECT_TRUE(path_of("L1 1").broken);
  EXPECT_TRUE(path_of("M0 0 L1e308 1e308 L2e309 0").not_finite);
  EXPECT_TRUE(path_of("").parts.empty());
}

TEST(SvgSampling, IsWithinTheToleranceAndAsDenseAsNeeded) {
  const SubPath part = path_of("M0,0 C0,.1 .2,.3 .4,.3").parts[0];
  const Segment& s = part.segments[0];
  const Sampled line = sampled(part, Affine::Identity(), 5e-5);
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0, u = 1 - t;
    const Vector2d p = u * u * u * s.from + 3 * u * u * t * s.c1 + 3 * u * t * t * s.c2 + t * t * t * s.to;
    worst = std::max(worst, nearest_on<2>(line.points, p).distance);
  }
  EXPECT_LT(worst, 6e-5);
  EXPECT_GT(worst, 1e-5);
  EXPECT_LT(line.points.size(), 120u);
}

TEST(SvgSampling, StraightCurvesAndVerticesThatBendNothingAreOneLine) {
  const Sampled line = sampled(path_of("M0,0 C0,.1 0,.2 0,.3 L0,.5 L.2,.5 C.3,.5 .3,.5 .3,.5 L.5,.5 L.5,0 Z").parts[0],
                               Affine::Identity(), 1e-4);
  EXPECT_EQ(line.points, (Points<2>{{0, 0}, {0, .5}, {.5, .5}, {.5, 0}}));
}

TEST(SvgSampling, CornersAreWhereTheDesignerHasThem) {
  // A straight side that runs on smoothly into a curve, then a corner.
  const Sampled line = sampled(path_of("M0,0 L0,.3 C0,.4 .1,.5 .2,.5 L.2,0 Z").parts[0], Affine::Identity(), 1e-4);
  int corners = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    corners += line.bends[i] == Bend::corner;
    EXPECT_TRUE(!line.points[i].isApprox(Vector2d(0, .3)) || line.bends[i] == Bend::smooth);
  }
  EXPECT_EQ(corners, 3);
}

TEST(SvgTransform, ListsAreAppliedFromTheRight) {
  const Vector2d p(1, 2);
  EXPECT_TRUE((*transform_of("translate(10,20) scale(2)") * p).isApprox(Vector2d(12, 24)));
  EXPECT_TRUE((*transform_of("scale(2),translate(10 20)") * p).isApprox(Vector2d(22, 44)));
  EXPECT_TRUE((*transform_of("rotate(90 1 1)") * p).isApprox(Vector2d(0, 1)));
  EXPECT_TRUE((*transform_of("matrix(1, 2.1e-7, 0, 1, 5, 6)") * p).isApprox(Vector2d(6, 8.00000021)));
  EXPECT_TRUE((*transform_of("skewX(45)") * p).isApprox(Vector2d(3, 2)));
  for (const char* bad : {"rotate(1", "scale(a)", "translate()", "matrix(1 2 3)", "spin(3)", "scale(1e999)"})
    EXPECT_FALSE(transform_of(bad)) << bad;
}

TEST(SvgStyle, SheetsClassesAndAttributesCascade) {
  Element rect, root;
  rect.name = "rect";
  rect.attributes = {{"class", "a b"}, {"stroke", "red"}, {"id", "r"}};
  Element style, text;
  style.name = "style";
  text.name = "#text";
  text.text =
      "/* x */ @media print { rect { stroke: black } } rect, circle { stroke: blue; fill: none } svg .a { stroke-dasharray: "
      "2,1 } g > .a { stroke: pink } .b { display: none !important }";
  style.children = {text};
  root.name = "svg";
  root.children = {style, rect};
  const StyleSheet sheet = StyleSheet::of(root);
  Style found = sheet.style_of({&root, &rect}, {});
  EXPECT_EQ(found.stroke, "blue");
  EXPECT_EQ(found.fill, "none");
  EXPECT_TRUE(found.is_dashed());
  EXPECT_TRUE(found.is_removed());
  rect.attributes["style"] = "stroke:green; display:inline";
  found = sheet.style_of({&root, &rect}, {});
  EXPECT_EQ(found.stroke, "green");
  EXPECT_TRUE(found.is_removed());  // !important
}

}  // namespace
}  // namespace toile::svg
