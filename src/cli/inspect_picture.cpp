#include "cli/inspect_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "garment/units.h"
#include "geometry/polyline.h"
#include "picture/canvas.h"

namespace toile {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr int sheet_width = 1200, most_height = 6000;
constexpr double margin = 24, gap = 26, name_height = 34, title_height = 56;  // pixels
constexpr Colour ink{.12, .14, .20}, pale{.72, .78, .88}, red{.80, .15, .10}, grey{.45, .45, .45}, cloth{.96, .95, .90};

Points<2> outline_of(const Piece& piece) {
  Points<2> points;
  for (const Edge& edge : piece.outline)
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) points.push_back(edge.points[i].at);
  return points;
}

struct Shown {
  const Piece* piece = nullptr;
  std::vector<const Piece*> other_sizes;
  AlignedBox2d box;
};

std::vector<Shown> shown_pieces(const PatternFile& file, bool all_sizes) {
  std::vector<Shown> shown;
  for (std::size_t i = 0; i < file.pattern.pieces.size(); ++i) {
    Shown each;
    each.piece = &file.pattern.pieces[i];
    for (const Vector2d& p : outline_of(*each.piece)) each.box.extend(p);
    if (all_sizes)
      for (const Pattern& size : file.graded) {
        each.other_sizes.push_back(&size.pieces[i]);
        for (const Vector2d& p : outline_of(size.pieces[i])) each.box.extend(p);
      }
    if (!each.box.isEmpty()) shown.push_back(each);
  }
  std::stable_sort(shown.begin(), shown.end(),
                   [](const Shown& a, const Shown& b) { return a.box.sizes().y() > b.box.sizes().y() * 1.001; });
  return shown;
}

// Rows of pieces at `scale` pixels per metre; returns the height they take and, when asked, where each goes.
double lay_out(const std::vector<Shown>& shown, double scale, std::vector<Vector2d>* places = nullptr) {
  double x = margin, y = title_height, row = 0;
  for (const Shown& each : shown) {
    const Vector2d size = scale * each.box.sizes();
    const double width = std::max(size.x(), 110.0);
    if (x > margin && x + width > sheet_width - margin) {
      x = margin;
      y += row + name_height + gap;
      row = 0;
    }
    if (places) places->push_back({x, y});
    row = std::max(row, size.y());
    x += width + gap;
  }
  return y + row + name_height + margin;
}

double best_scale(const std::vector<Shown>& shown) {
  double widest = 1e-3;
  for (const Shown& each : shown) widest = std::max(widest, each.box.sizes().x());
  double high = (sheet_width - 2 * margin) / widest, low = 0;
  const double wanted = 1100;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (lay_out(shown, middle) <= wanted ? low : high) = middle;
  }
  return low > 0 ? low : high;
}

void draw(Canvas& canvas, const Shown& shown, double scale, const Vector2d& place) {
  const auto at = [&](const Vector2d& p) -> Vector2d {
    return {place.x() + scale * (p.x() - shown.box.min().x()), place.y() + scale * (shown.box.max().y() - p.y())};
  };
  const auto all = [&](const Points<2>& points) {
    std::vector<Vector2d> pixels;
    for (const Vector2d& p : points) pixels.push_back(at(p));
    return pixels;
  };
  const Piece& piece = *shown.piece;
  canvas.fill(all(outline_of(piece)), cloth);
  for (const Piece* other : shown.other_sizes) canvas.line(all(outline_of(*other)), pale, .8, true);
  for (const InternalLine& line : piece.internal_lines) canvas.line(all(line.points), line.cut_out ? red : grey, .8);
  canvas.line(all(outline_of(piece)), ink, 1.5, true);
  for (const Edge& edge : piece.outline) {
    const Vector2d corner = at(edge.points.front().at);
    canvas.fill({corner + Vector2d(-2, -2), corner + Vector2d(2, -2), corner + Vector2d(2, 2), corner + Vector2d(-2, 2)}, ink);
  }
  for (const Notch& notch : piece.notches) {
    const Edge* edge = find_edge(piece, notch.edge);
    if (!edge) continue;
    const Points<2> points = positions(*edge);
    const Vector2d on = at(point_at<2>(points, notch.at)), along = direction_at<2>(points, notch.at);
    canvas.line({on, on + 9 * Vector2d(-along.y(), -along.x())}, red, 1.6);
  }
  for (const DrillHole& hole : piece.drill_holes) {
    const Vector2d middle = at(hole.at);
    canvas.line({middle - Vector2d(4, 0), middle + Vector2d(4, 0)}, red, 1.2);
    canvas.line({middle - Vector2d(0, 4), middle + Vector2d(0, 4)}, red, 1.2);
  }
  if (piece.grainline) {
    const Vector2d from = at(piece.grainline->from), to = at(piece.grainline->to);
    const Vector2d along = (to - from).normalized(), across(-along.y(), along.x());
    canvas.line({from, to}, grey, 1);
    for (const double side : {-1.0, 1.0}) canvas.line({to - 7 * along + 3 * side * across, to}, grey, 1);
  }
  const double room = std::max(scale * shown.box.sizes().x(), 110.0) + gap - 6;
  const auto words = [&](const std::string& text, double line, const Colour& colour) {
    const double wide = canvas.width_of(text, 11);
    canvas.words(text, {place.x(), place.y() + scale * shown.box.sizes().y() + line}, wide > room ? 11 * room / wide : 11,
                 colour);
  };
  const int as_drawn = piece.quantity, mirrored = piece.mirrored_quantity;
  words(piece.name + ", cut " + std::to_string(as_drawn) + (mirrored ? "+" + std::to_string(mirrored) : ""), 14, ink);
  AlignedBox2d own;
  for (const Vector2d& p : outline_of(piece)) own.extend(p);
  char size[64];
  std::snprintf(size, sizeof size, "%.0f x %.0f mm", own.sizes().x() * mm_per_m, own.sizes().y() * mm_per_m);
  words(size, 28, grey);
}

}  // namespace

Image contact_sheet(const PatternFile& file, const std::string& title, bool all_sizes) {
  const std::vector<Shown> shown = shown_pieces(file, all_sizes);
  const double scale = best_scale(shown);
  std::vector<Vector2d> places;
  const double height = lay_out(shown, scale, &places);
  Canvas canvas(blank_image(sheet_width, std::clamp(static_cast<int>(std::ceil(height)), 200, most_height)));
  const std::string size = file.pattern.sample_size.empty() ? "" : ", size " + file.pattern.sample_size;
  const std::string heading = title + " (" + file.format + (file.dialect.empty() ? "" : ", " + file.dialect) + ")" + size;
  const double wide = canvas.width_of(heading, 18, true), room = sheet_width - 2 * margin - 160;
  canvas.words(heading, {margin, 30}, wide > room ? 18 * room / wide : 18, ink, Align::left, true);
  const double bar = .1 * scale;
  canvas.line({{sheet_width - margin - bar, 26}, {sheet_width - margin, 26}}, ink, 2);
  canvas.words("10 cm", {sheet_width - margin, 42}, 11, ink, Align::right);
  for (std::size_t i = 0; i < shown.size(); ++i) draw(canvas, shown[i], scale, places[i]);
  return canvas.image();
}

}  // namespace toile
