#include "picture/image.h"

#include <gtest/gtest.h>

#include "picture/canvas.h"

// fontconfig keeps what it has read until the program ends; the leak checker of the sanitizer build must not count that.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }

namespace toile {
namespace {

constexpr Colour red{1, 0, 0}, blue{0, 0, 1}, white{1, 1, 1};

TEST(Image, StandSideBySideCentred) {
  const Image row = side_by_side({blank_image(10, 20, red), blank_image(6, 10, blue)}, 4);
  EXPECT_EQ(row.width, 20);
  EXPECT_EQ(row.height, 20);
  EXPECT_EQ(pixel(row, 9, 0), red);
  EXPECT_EQ(pixel(row, 12, 10), white);
  EXPECT_EQ(pixel(row, 14, 4), white);
  EXPECT_EQ(pixel(row, 14, 5), blue);
  EXPECT_EQ(pixel(row, 19, 14), blue);
}

TEST(Image, StandBelowEachOther) {
  const Image column = stacked({blank_image(10, 20, red), blank_image(6, 10, blue)}, 4);
  EXPECT_EQ(column.width, 10);
  EXPECT_EQ(column.height, 34);
  EXPECT_EQ(pixel(column, 0, 19), red);
  EXPECT_EQ(pixel(column, 1, 24), white);
  EXPECT_EQ(pixel(column, 2, 24), blue);
}

TEST(Image, PngHasSignatureSizeAndNoDate) {
  const std::string png = png_bytes(blank_image(300, 7, red));
  ASSERT_GT(png.size(), 33u);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\x01\x2c\0\0\0\x07", 8));
  EXPECT_EQ(png.find("tIME"), std::string::npos);
  EXPECT_EQ(png, png_bytes(blank_image(300, 7, red)));
  EXPECT_THROW(png_bytes(Image{}), std::invalid_argument);
}

TEST(Canvas, DrawsWhatItIsTold) {
  Canvas canvas(blank_image(100, 60));
  canvas.fill({{10, 10}, {40, 10}, {40, 40}, {10, 40}}, blue);
  canvas.line({{60, 20}, {90, 20}}, red, 4);
  const Image image = canvas.image();
  EXPECT_EQ(pixel(image, 25, 25), blue);
  EXPECT_EQ(pixel(image, 75, 20), red);
  EXPECT_EQ(pixel(image, 75, 30), white);
  EXPECT_EQ(pixel(image, 5, 5), white);
}

TEST(Canvas, WritesWordsWhereTheyBelong) {
  const auto ink = [](const Image& image, int left, int right) {
    int dark = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = left; x < right; ++x) dark += pixel(image, x, y).red < .5;
    return dark;
  };
  for (const Align align : {Align::left, Align::centre, Align::right}) {
    Canvas canvas(blank_image(400, 40));
    canvas.words("gore", {200, 30}, 20, {0, 0, 0}, align);
    const double width = canvas.width_of("gore", 20);
    EXPECT_GT(width, 35);
    EXPECT_LT(width, 65);
    const Image image = canvas.image();
    EXPECT_EQ(ink(image, 0, 200) > 20, align != Align::left);
    EXPECT_EQ(ink(image, 200, 400) > 20, align != Align::right);
    EXPECT_GT(ink(image, 0, 400), 60);
  }
}

}  // namespace
}  // namespace toile
