#pragma once
// Lines, areas and words on a picture.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "picture/image.h"

namespace toile {

enum class Align { left, centre, right };

// Pixels, y downwards. Letters are DejaVu Sans.
class Canvas {
 public:
  explicit Canvas(const Image& image);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void line(const std::vector<Eigen::Vector2d>& points, const Colour& colour, double width, bool closed = false);
  void fill(const std::vector<Eigen::Vector2d>& points, const Colour& colour, double opacity = 1);
  // `at`: on the base line, at the left end, middle or right end of the words.
  void words(const std::string& words, const Eigen::Vector2d& at, double size, const Colour& colour = {.1, .1, .1},
             Align align = Align::left, bool bold = false);
  double width_of(const std::string& words, double size, bool bold = false) const;
  Image image() const;

 private:
  struct Drawing;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace toile
