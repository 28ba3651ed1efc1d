#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

#include "picture/canvas.h"
#include "picture/pictures.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using Loop = std::vector<Vector2d>;

constexpr Colour green{.13, .55, .25}, red{.82, .14, .10}, blue{.10, .30, .78}, grey{.35, .35, .35};

Loop boundary_of(const PanelMesh& panel, const Eigen::Matrix2Xd& rest) {
  Loop loop;
  for (const BoundaryVertex& vertex : panel.boundary) loop.emplace_back(rest.col(vertex.vertex));
  return loop;
}

Vector2d mean(const Loop& loop, const std::vector<std::size_t>& which) {
  Vector2d sum = Vector2d::Zero();
  for (const std::size_t i : which) sum += loop[i];
  return sum / static_cast<double>(which.size());
}

Loop turned_as(const Loop& loop, const Loop& like, const std::vector<std::size_t>& all) {
  const Vector2d from = mean(loop, all), to = mean(like, all);
  double sine = 0, cosine = 0;
  for (const std::size_t i : all) {
    const Vector2d a = loop[i] - from, b = like[i] - to;
    sine += a.x() * b.y() - a.y() * b.x();
    cosine += a.dot(b);
  }
  const double turn = std::atan2(sine, cosine);
  Eigen::Matrix2d rotation;
  rotation << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
  Loop turned;
  for (const Vector2d& p : loop) turned.push_back(rotation * p);
  return turned;
}

double distance_to(const Loop& loop, const Vector2d& point) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector2d a = loop[i], ab = loop[(i + 1) % loop.size()] - a;
    const double t = ab.squaredNorm() > 0 ? std::clamp((point - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) : 0;
    nearest = std::min(nearest, (a + t * ab - point).norm());
  }
  return nearest;
}

// Points at the upper, lower, right and left end of `like` by the grain, and all of them.
std::vector<std::vector<std::size_t>> places_to_hang(const Loop& like, const Vector2d& up) {
  std::vector<std::vector<std::size_t>> places;
  for (const Vector2d& end : {up, Vector2d(-up), Vector2d(up.y(), -up.x()), Vector2d(-up.y(), up.x())}) {
    double lowest = INFINITY, highest = -INFINITY;
    for (const Vector2d& p : like) lowest = std::min(lowest, p.dot(end)), highest = std::max(highest, p.dot(end));
    places.emplace_back();
    for (std::size_t i = 0; i < like.size(); ++i)
      if (like[i].dot(end) >= highest - 0.03 * (highest - lowest)) places.back().push_back(i);
  }
  places.emplace_back(like.size());
  for (std::size_t i = 0; i < like.size(); ++i) places.back()[i] = i;
  return places;
}

// `loop` turned as `like` and shifted so that as much of it as possible lies on `like`.
Loop laid_over(const Loop& loop, const Loop& like, const std::vector<std::vector<std::size_t>>& places) {
  constexpr double off = 3e-3;  // m, beyond which a point does not lie on it
  const Loop turned = turned_as(loop, like, places.back());
  Loop best;
  double least = INFINITY;
  for (const std::vector<std::size_t>& place : places) {
    const Vector2d shift = mean(like, place) - mean(turned, place);
    Loop laid;
    double cost = 0;
    for (const Vector2d& p : turned) {
      laid.push_back(p + shift);
      cost += std::min(off, distance_to(like, laid.back()));
    }
    if (cost >= least - 1e-9) continue;
    least = cost;
    best = std::move(laid);
  }
  return best;
}

struct Box {
  Vector2d low, high;
  Vector2d size() const { return high - low; }
};

Box box_of(const PanelOutlines& panel) {
  Box box{Vector2d::Constant(INFINITY), Vector2d::Constant(-INFINITY)};
  for (const Loop* loop : {&panel.original, &panel.flattened, &panel.adjusted})
    for (const Vector2d& p : *loop) box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
  return box;
}

struct Arranged {
  std::vector<Vector2d> corners;  // upper left of each panel, pixels
  double width = 0, height = 0;
};

constexpr double gap = 36, label = 24;  // pixels

// Panels in rows from the left at `scale` pixels per metre; empty when one is wider than the picture.
Arranged arrange(const std::vector<Box>& boxes, double scale, double width) {
  Arranged rows;
  double x = gap, y = 0, tallest = 0;
  for (const Box& box : boxes) {
    const Vector2d size = scale * box.size();
    if (x > gap && x + size.x() + gap > width) {
      x = gap;
      y += tallest + label + gap;
      tallest = 0;
    }
    if (x + size.x() + gap > width) return {{}, INFINITY, INFINITY};
    rows.corners.emplace_back(x, y);
    x += size.x() + gap;
    rows.width = std::max(rows.width, x);
    tallest = std::max(tallest, size.y());
  }
  rows.height = y + tallest + label;
  return rows;
}

void draw_legend(Canvas& canvas, double x, double y, const std::vector<PanelOutlines>& panels) {
  const auto any = [&](Loop PanelOutlines::*loop) {
    return std::any_of(panels.begin(), panels.end(), [&](const PanelOutlines& panel) { return !(panel.*loop).empty(); });
  };
  struct Entry {
    Colour colour;
    const char* words;
    Loop PanelOutlines::*loop;
  };
  for (const Entry& entry :
       {Entry{green, "original", &PanelOutlines::original}, Entry{red, "plain flattening", &PanelOutlines::flattened},
        Entry{blue, "adjusted", &PanelOutlines::adjusted}}) {
    if (!any(entry.loop)) continue;
    canvas.line({{x, y - 5}, {x + 34, y - 5}}, entry.colour, 3);
    canvas.words(entry.words, {x + 42, y}, 15);
    x += 42 + canvas.width_of(entry.words, 15) + 36;
  }
}

}  // namespace

std::vector<PanelOutlines> panel_outlines(const GarmentMesh& garment, const RestShape& flattened, const RestShape& adjusted) {
  if (flattened.size() != garment.panels.size() || adjusted.size() != garment.panels.size())
    throw std::invalid_argument("panel_outlines: one rest shape per panel");
  std::vector<PanelOutlines> outlines;
  std::set<int> seen;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    if (!seen.insert(panel.piece).second) continue;
    if (flattened[p].cols() != panel.rest.cols() || adjusted[p].cols() != panel.rest.cols())
      throw std::invalid_argument("panel_outlines: rest shape of another panel than '" + panel.name + "'");
    PanelOutlines all{panel.name.substr(0, panel.name.find(':')), boundary_of(panel, panel.rest), {}, {}};
    if (all.original.empty()) continue;
    const auto places = places_to_hang(all.original, panel.warp);
    all.flattened = laid_over(boundary_of(panel, flattened[p]), all.original, places);
    all.adjusted = laid_over(boundary_of(panel, adjusted[p]), all.original, places);
    outlines.push_back(std::move(all));
  }
  return outlines;
}

Image panels_overlay(const std::vector<PanelOutlines>& panels, const std::string& title, int width) {
  std::vector<Box> boxes;
  for (const PanelOutlines& panel : panels) boxes.push_back(box_of(panel));
  if (boxes.empty() || width < 300) throw std::invalid_argument("panels_overlay: nothing to draw");
  for (const Box& box : boxes)
    if (!box.size().allFinite()) throw std::invalid_argument("panels_overlay: an outline is empty or not finite");
  double scale = 1400;
  Arranged rows = arrange(boxes, scale, width);
  while (rows.height > 0.75 * width) rows = arrange(boxes, scale *= 0.97, width);

  const double top = 100, foot = 56;
  constexpr double of_a_letter = 12;  // px, of the title
  const double needed = std::max(rows.width, 2 * gap + of_a_letter * static_cast<double>(title.size()));
  const int used = std::clamp(static_cast<int>(needed), std::min(width, 640), width);
  Canvas canvas(blank_image(used, static_cast<int>(top + rows.height + gap + foot)));
  canvas.words(title, {gap, 36}, 20, {.1, .1, .1}, Align::left, true);
  draw_legend(canvas, gap, 68, panels);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Vector2d corner = rows.corners[i] + Vector2d(0, top);
    const auto on_page = [&](const Loop& loop) {
      Loop placed;
      for (const Vector2d& p : loop)
        placed.emplace_back(corner.x() + scale * (p.x() - boxes[i].low.x()), corner.y() + scale * (boxes[i].high.y() - p.y()));
      return placed;
    };
    canvas.fill(on_page(panels[i].original), green, 0.12);
    canvas.line(on_page(panels[i].original), green, 2, true);
    if (!panels[i].flattened.empty()) canvas.line(on_page(panels[i].flattened), red, 2, true);
    if (!panels[i].adjusted.empty()) canvas.line(on_page(panels[i].adjusted), blue, 2, true);
    canvas.words(panels[i].name,
                 {corner.x() + scale * boxes[i].size().x() / 2, corner.y() + scale * boxes[i].size().y() + label - 4}, 14, grey,
                 Align::centre);
  }
  const double bar = 0.1 * scale, y = top + rows.height + gap + foot / 2;
  canvas.line({{gap, y}, {gap + bar, y}}, {.1, .1, .1}, 2);
  for (const double x : {gap, gap + bar}) canvas.line({{x, y - 5}, {x, y + 5}}, {.1, .1, .1}, 2);
  canvas.words("10 cm", {gap + bar + 10, y + 5}, 15);
  return canvas.image();
}

}  // namespace toile
