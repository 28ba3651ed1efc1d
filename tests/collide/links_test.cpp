#include "collide/links.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace toile {
namespace {

using Loop = std::vector<Eigen::Vector3d>;

Loop circle(double radius, int n, double turns = 1, double wobble = 0) {
  Loop loop;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / n;
    loop.emplace_back(radius * std::cos(angle), radius * std::sin(angle), wobble * std::sin(3 * angle));
  }
  return loop;
}

const Loop upwards{{0, 0, -2}, {0, 0, 2}};

TEST(Links, AChainThroughAHoopIsSigned) {
  EXPECT_EQ(std::abs(crossings(circle(1, 24), upwards)), 1);
  EXPECT_EQ(crossings(circle(1, 24), {upwards[1], upwards[0]}), -crossings(circle(1, 24), upwards));
  Loop reversed = circle(1, 24);
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(crossings(reversed, upwards), -crossings(circle(1, 24), upwards));
  EXPECT_EQ(crossings(circle(1, 24), upwards), 1) << "from below, the loop runs clockwise";
}

TEST(Links, BesideTheHoopIsNothing) { EXPECT_EQ(crossings(circle(1, 24), {{1.5, 0, -2}, {1.5, 0, 2}}), 0); }

TEST(Links, ThereAndBackIsNothing) { EXPECT_EQ(crossings(circle(1, 24), {{.1, 0, -2}, {.2, 0, 2}, {.3, .1, -2}}), 0); }

TEST(Links, ALoopWoundTwiceCountsTwice) {
  Loop twice = circle(1, 48, 2, .0);
  for (std::size_t i = 0; i < twice.size(); ++i) twice[i].z() = .1 * std::sin(std::numbers::pi * double(i) / 24);
  EXPECT_EQ(crossings(twice, {{.05, .02, -2}, {.05, .02, 2}}), 2);
}

// A chain through the middle and along rims: the degenerate places of a fan are counted once.
TEST(Links, DegeneratePlacesCountOnce) {
  for (int n = 3; n < 30; ++n) {
    EXPECT_EQ(crossings(circle(1, n), upwards), 1) << n;
    EXPECT_EQ(crossings(circle(1, n), {{0, 0, -1}, {0, 0, 0}, {0, 0, 1}}), 1) << n;
  }
  const Loop square{{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  EXPECT_EQ(crossings(square, {{.5, .5, -1}, {.5, .5, 1}}), 1) << "on a spoke of the fan";
}

TEST(Links, DoNotDependOnHowTheChainGoes) {
  const Loop bent{{.2, .1, -2}, {.9, 0, -.3}, {-.8, .3, .2}, {0, .9, -.2}, {3, 3, -.1},
                  {3, 3, 2},    {0, 0, 2},    {0, .1, -2},   {9, 9, -2},   {0, 0, 9}};
  const int expected = crossings(circle(1, 40, 1, .3), bent);
  Loop finer;
  for (std::size_t i = 0; i + 1 < bent.size(); ++i)
    for (int k = 0; k < 7; ++k) finer.push_back(bent[i] + k / 7. * (bent[i + 1] - bent[i]));
  finer.push_back(bent.back());
  EXPECT_EQ(crossings(circle(1, 40, 1, .3), finer), expected);
}

TEST(Links, TableOfLoopsByChains) {
  Loop far = circle(1, 20);
  for (auto& at : far) at.x() += 5;
  const auto through = links({circle(1, 20), far}, {upwards, {{5, 0, 2}, {5, 0, -2}}, {{9, 0, 2}, {9, 0, -2}}});
  Eigen::MatrixXi expected(2, 3);
  expected << 1, 0, 0, 0, -1, 0;
  EXPECT_EQ(through, expected);
}

}  // namespace
}  // namespace toile
