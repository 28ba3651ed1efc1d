#pragma once
// A picture in memory and its PNG bytes.

#include <cstdint>
#include <string>
#include <vector>

namespace toile {

// sRGB, 0..1.
struct Colour {
  double red = 0, green = 0, blue = 0;
  bool operator==(const Colour&) const = default;
};

// Eight bits red, green, blue per pixel, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  // 3 * width * height
  bool operator==(const Image&) const = default;
};

Image blank_image(int width, int height, const Colour& colour = {1, 1, 1});
Colour pixel(const Image& image, int x, int y);

// Pictures of any height in a row, centred, `gap` pixels of white between them; likewise below each other.
Image side_by_side(const std::vector<Image>& images, int gap = 0);
Image stacked(const std::vector<Image>& images, int gap = 0);

// The same picture, the same bytes. Throws std::invalid_argument for an empty one.
std::string png_bytes(const Image& image);

}  // namespace toile
