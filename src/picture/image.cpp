#include "picture/image.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace toile {
namespace {

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

void paste(Image& canvas, const Image& image, int left, int top) {
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.pixels.begin() + 3L * y * image.width, 3L * image.width,
                canvas.pixels.begin() + 3L * ((y + top) * canvas.width + left));
}

}  // namespace

Image blank_image(int width, int height, const Colour& colour) {
  if (width <= 0 || height <= 0) throw std::invalid_argument("blank_image: size must be positive");
  Image image{width, height, {}};
  image.pixels.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (long i = 0; i < static_cast<long>(width) * height; ++i)
    for (const double part : {colour.red, colour.green, colour.blue}) image.pixels.push_back(to_byte(part));
  return image;
}

Colour pixel(const Image& image, int x, int y) {
  const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.pixels.at(at) / 255.0, image.pixels.at(at + 1) / 255.0, image.pixels.at(at + 2) / 255.0};
}

Image side_by_side(const std::vector<Image>& images, int gap) {
  int width = -gap, height = 0;
  for (const Image& image : images) {
    width += image.width + gap;
    height = std::max(height, image.height);
  }
  Image row = blank_image(width, height);
  int left = 0;
  for (const Image& image : images) {
    paste(row, image, left, (height - image.height) / 2);
    left += image.width + gap;
  }
  return row;
}

Image stacked(const std::vector<Image>& images, int gap) {
  int width = 0, height = -gap;
  for (const Image& image : images) {
    width = std::max(width, image.width);
    height += image.height + gap;
  }
  Image column = blank_image(width, height);
  int top = 0;
  for (const Image& image : images) {
    paste(column, image, (width - image.width) / 2, top);
    top += image.height + gap;
  }
  return column;
}

}  // namespace toile
