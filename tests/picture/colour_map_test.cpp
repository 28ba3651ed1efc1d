#include "picture/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "picture/colour_space.h"

namespace toile {
namespace {

TEST(ColourSpace, KnownValues) {
  EXPECT_NEAR(to_linear(0.5), 0.21404, 1e-5);
  EXPECT_NEAR(to_encoded(to_linear(0.3)), 0.3, 1e-12);
  EXPECT_NEAR(to_oklab({1, 1, 1}).lightness, 1, 1e-6);
  const OkLab red = to_oklab({1, 0, 0});  // Ottosson's table
  EXPECT_NEAR(red.lightness, 0.628, 1e-3);
  EXPECT_NEAR(red.a, 0.225, 1e-3);
  EXPECT_NEAR(red.b, 0.126, 1e-3);
}

TEST(ColourMap, GetsDarkerInEqualSteps) {
  double before = to_oklab(colour_map(0)).lightness;
  for (int i = 1; i <= 20; ++i) {
    const double lightness = to_oklab(colour_map(i / 20.0)).lightness;
    EXPECT_NEAR(before - lightness, 0.03, 0.004) << i;
    before = lightness;
  }
}

// Deuteranopes confuse red and green; lightness and the blue-yellow axis are left to tell colours by.
TEST(ColourMap, IsToldApartWithoutRedAndGreen) {
  for (int i = 0; i < 10; ++i) {
    const OkLab a = to_oklab(colour_map(i / 10.0)), b = to_oklab(colour_map((i + 1) / 10.0));
    EXPECT_GT(std::hypot(a.lightness - b.lightness, a.b - b.b), .04) << i;
  }
}

TEST(ColourMap, ClampsAndShowsWhatIsNoNumber) {
  EXPECT_EQ(colour_map(-3), colour_map(0));
  EXPECT_EQ(colour_map(7), colour_map(1));
  EXPECT_EQ(colour_map(NAN), (Colour{.5, .5, .5}));
}

TEST(ColourScale, EndsAndTicksAreRound) {
  EXPECT_DOUBLE_EQ(round_top(7.9), 8);
  EXPECT_DOUBLE_EQ(round_top(0.0041), 0.005);
  EXPECT_DOUBLE_EQ(round_top(10), 10);
  EXPECT_DOUBLE_EQ(round_top(81), 100);
  EXPECT_DOUBLE_EQ(round_top(0), 1);
  for (const double top : {.001, .02, .3, 1., 2., 3., 4., 5., 6., 8., 50.}) {
    const std::vector<double> values = ticks(top);
    EXPECT_GE(values.size(), 5u) << top;
    EXPECT_LE(values.size(), 7u) << top;
    EXPECT_EQ(values.front(), 0);
    EXPECT_NEAR(values.back(), top, 1e-9 * top);
  }
}

}  // namespace
}  // namespace toile
