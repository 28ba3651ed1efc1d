#include "triangulate/fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/self_crossing.h"
#include "triangulate/smooth.h"

namespace toile {
namespace {

using Loop = std::vector<Eigen::Vector2d>;
constexpr double h = 15e-3;

double twice_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double area(const Loop& loop) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += twice_area(loop[0], loop[i], loop[i + 1]) / 2;
  return sum;
}

Loop divided(const Loop& corners, double spacing) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d side = corners[(i + 1) % corners.size()] - corners[i];
    const int n = std::max(1, static_cast<int>(std::lround(side.norm() / spacing)));
    for (int k = 0; k < n; ++k) loop.push_back(corners[i] + side * k / n);
  }
  return loop;
}

struct Quality {
  double covered = 0, least_angle = 180, least_area = 1;
};

// `counts(centre)`: whether the angle of a triangle there matters.
template <class Counts>
Quality quality(const Filling& filling, const Counts& counts) {
  Quality q;
  for (const auto& [a, b, c] : filling.triangles) {
    const Eigen::Vector2d& pa = filling.points[static_cast<std::size_t>(a)];
    const Eigen::Vector2d& pb = filling.points[static_cast<std::size_t>(b)];
    const Eigen::Vector2d& pc = filling.points[static_cast<std::size_t>(c)];
    const double twice = twice_area(pa, pb, pc);
    q.covered += twice / 2;
    q.least_area = std::min(q.least_area, twice / 2);
    if (counts((pa + pb + pc) / 3)) q.least_angle = std::min(q.least_angle, smallest_angle(pa, pb, pc));
  }
  return q;
}

const auto everywhere = [](const Eigen::Vector2d&) { return true; };

TEST(SmallestAngle, OfKnownTriangles) {
  EXPECT_NEAR(smallest_angle({0, 0}, {1, 0}, {0, 1}), 45, 1e-12);
  EXPECT_NEAR(smallest_angle({0, 0}, {1, 0}, {.5, std::sqrt(3) / 2}), 60, 1e-12);
  EXPECT_LT(smallest_angle({0, 0}, {0, 1}, {1, 0}), 0);
}

TEST(Fill, KeepsTheOutlineAndAddsNothingToIt) {
  const Loop loop = divided({{0, 0}, {.3, 0}, {.3, .2}, {0, .2}}, h);
  const Filling filling = fill(loop, h, 20);
  ASSERT_GT(filling.points.size(), loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) EXPECT_EQ(filling.points[i], loop[i]);
  for (std::size_t i = loop.size(); i < filling.points.size(); ++i) {
    const Eigen::Vector2d& p = filling.points[i];
    EXPECT_GT(std::min(std::min(p.x(), .3 - p.x()), std::min(p.y(), .2 - p.y())), .4 * h);
  }
  EXPECT_EQ(filling.triangles.size(), 2 * filling.points.size() - loop.size() - 2);  // Euler
}

TEST(Fill, MakesNearlyEquilateralTrianglesOfARectangle) {
  const Quality q = quality(fill(divided({{0, 0}, {.3, 0}, {.3, .2}, {0, .2}}, h), h, 20), everywhere);
  EXPECT_NEAR(q.covered, .06, 1e-15);
  EXPECT_GT(q.least_angle, 35);
}

TEST(Fill, WorksInStripsNarrowerThanTheEdgeLength) {
  for (const double width : {.045, .04, .03, .02, .012, .008, .003}) {
    const Quality q = quality(fill(divided({{0, 0}, {.4, 0}, {.4, width}, {0, width}}, h), h, 20), everywhere);
    EXPECT_NEAR(q.covered, .4 * width, 1e-14) << width;
    EXPECT_GT(q.least_area, 1e-3 * h * h) << width;
    EXPECT_GT(q.least_angle, std::min(30.0, std::atan2(width, 1.1 * h) * 180 / std::numbers::pi)) << width;
  }
}

TEST(Fill, GrowsFromShortSidesToTheEdgeLength) {
  Loop loop;
  for (int i = 0; i < 100; ++i) loop.emplace_back(.3 * i / 100, 0.0);
  for (int i = 0; i < 20; ++i) loop.emplace_back(.3, .3 * i / 20);
  for (int i = 0; i < 20; ++i) loop.emplace_back(.3 - .3 * i / 20, .3);
  for (int i = 0; i < 20; ++i) loop.emplace_back(0.0, .3 - .3 * i / 20);
  const Filling filling = fill(loop, h, 20);
  EXPECT_GT(quality(filling, everywhere).least_angle, 20);
  EXPECT_LT(filling.triangles.size(), 3000u);  // all at 3 mm would be 23,000
}

TEST(Fill, LeavesNoSliverOnAnOutlineThatIsAlmostStraight) {
  Loop loop = divided({{0, 0}, {.3, 0}, {.3, .2}, {0, .2}}, h);
  for (Eigen::Vector2d& p : loop) p.y() += 1e-9 * std::sin(1e4 * p.x());
  EXPECT_GT(quality(fill(loop, h, 20), everywhere).least_angle, 35);
}

TEST(Fill, KeepsItsAnglesInRandomStars) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  int tried = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const int corners = 4 + static_cast<int>(random() % 12);
    Loop star;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * (i + .35 * unit(random)) / corners;
      star.push_back((.08 + .22 * unit(random)) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    const Loop loop = divided(star, h);
    if (first_self_crossing(loop)) continue;
    ++tried;
    std::vector<Eigen::Vector2d> sharp;
    for (std::size_t i = 0; i < star.size(); ++i) {
      const Eigen::Vector2d u = star[(i + 1) % star.size()] - star[i], v = star[(i + star.size() - 1) % star.size()] - star[i];
      const double angle = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v)) * 180 / std::numbers::pi;
      if (angle > 0 && angle < 50) sharp.push_back(star[i]);
    }
    const Filling filling = fill(loop, h, 20);
    const Quality q = quality(filling, [&](const Eigen::Vector2d& centre) {
      return std::none_of(sharp.begin(), sharp.end(), [&](const Eigen::Vector2d& p) { return (p - centre).norm() < 3 * h; });
    });
    EXPECT_NEAR(q.covered, area(loop), 1e-13) << trial;
    EXPECT_GT(q.least_area, 0) << trial;
    EXPECT_GT(q.least_angle, 25) << trial;
    EXPECT_EQ(filling.triangles.size(), 2 * filling.points.size() - loop.size() - 2) << trial;
  }
  EXPECT_GT(tried, 40);
}

}  // namespace
}  // namespace toile
