#include "formats/svg/label_place.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

using Eigen::Vector2d;

struct Rectangle {
  Vector2d low, high;
};

// Clips segment ab against the slabs of the rectangle.
bool touches(const Rectangle& box, const Vector2d& a, const Vector2d& b) {
  double enter = 0, leave = 1;
  for (int k = 0; k < 2; ++k) {
    const double d = b[k] - a[k];
    if (d == 0) {
      if (a[k] < box.low[k] || a[k] > box.high[k]) return false;
      continue;
    }
    const double s = (box.low[k] - a[k]) / d;
    const double t = (box.high[k] - a[k]) / d;
    enter = std::max(enter, std::min(s, t));
    leave = std::min(leave, std::max(s, t));
  }
  return enter <= leave;
}

bool contains(const std::vector<Vector2d>& outline, const Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& a = outline[i];
    const Vector2d& b = outline[(i + 1) % outline.size()];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

}  // namespace

LabelPlace place_label(const std::vector<Vector2d>& outline, const std::vector<Segment2>& obstacles, double width,
                       double height, double largest) {
  LabelPlace best[2];
  double best_off[2] = {0, 0};
  if (outline.size() < 3 || width <= 0 || height <= 0) return {};
  Rectangle all{outline.front(), outline.front()};
  for (const Vector2d& p : outline) all = {all.low.cwiseMin(p), all.high.cwiseMax(p)};
  const Vector2d middle = (all.low + all.high) / 2;
  const int steps = 32;
  for (int ix = 1; ix < steps; ++ix)
    for (int iy = 1; iy < steps; ++iy) {
      const Vector2d centre = all.low + (all.high - all.low).cwiseProduct(Vector2d(ix, iy)) / steps;
      if (!contains(outline, centre)) continue;
      for (int turned = 0; turned < 2; ++turned) {
        const Vector2d half = (turned ? Vector2d(height, width) : Vector2d(width, height)) / 2;
        const auto fits = [&](double scale) {
          const Rectangle box{centre - scale * half, centre + scale * half};
          for (std::size_t i = 0; i < outline.size(); ++i)
            if (touches(box, outline[i], outline[(i + 1) % outline.size()])) return false;
          return std::none_of(obstacles.begin(), obstacles.end(),
                              [&](const Segment2& s) { return touches(box, s.first, s.second); });
        };
        LabelPlace& found = best[turned];
        const double off = (centre - middle).norm();
        const bool nearer = off < best_off[turned] - 1e-9;
        const double least = std::min(largest, found.scale * (nearer ? 1.0 : 1.02) + 1e-6);
        if ((found.scale >= largest && !nearer) || !fits(least)) continue;
        double low = least, high = largest;
        if (fits(largest)) low = largest;
        while (high - low > 0.01 * largest && low < largest) {
          const double half_way = (low + high) / 2;
          (fits(half_way) ? low : high) = half_way;
        }
        found = {.centre = centre, .upright = !turned, .scale = low};
        best_off[turned] = off;
      }
    }
  return best[1].scale > 4.0 / 3 * best[0].scale ? best[1] : best[0];
}

double text_width(std::string_view words) {
  const auto letters =
      std::count_if(words.begin(), words.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return 0.62 * static_cast<double>(letters);
}

}  // namespace toile
