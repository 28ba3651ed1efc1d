#include "picture/plot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace toile {
namespace {

int dark_blue(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < 880; ++x) {  // left of the key
      const Colour at = pixel(image, x, y);
      count += at.red < .1 && at.blue > .6;
    }
  return count;
}

TEST(LinePlot, DrawsEverySeries) {
  const Image one = line_plot({"title", "step", "value", {{"a", {1, .5, .25}}}});
  EXPECT_EQ(one.width, 1200);
  EXPECT_GT(dark_blue(one), 500);
  EXPECT_EQ(line_plot({"title", "step", "value", {{"a", {1, .5, .25}}}}), one);
  EXPECT_NE(line_plot({"title", "step", "value", {{"a", {1, .5, .25}}, {"b", {2, 1}}}}), one);
}

TEST(LinePlot, OneFigureAndEqualFiguresCanBeShown) {
  EXPECT_GT(dark_blue(line_plot({"", "", "", {{"a", {.3}}}})), 10);
  EXPECT_GT(dark_blue(line_plot({"", "", "", {{"a", {0, 0, 0}}}})), 500);
}

TEST(LinePlot, RefusesWhatCannotBeShown) {
  EXPECT_THROW(line_plot({"", "", "", {}}), std::invalid_argument);
  EXPECT_THROW(line_plot({"", "", "", {{"a", {1, std::nan("")}}}}), std::invalid_argument);
}

}  // namespace
}  // namespace toile
