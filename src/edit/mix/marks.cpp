#include "edit/mix/marks.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <utility>

namespace toile {
namespace {

bool inside(const std::vector<Eigen::Vector2d>& loop, const Eigen::Vector2d& at) {
  bool in = false;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    const Eigen::Vector2d &a = loop[i], &b = loop[j];
    if ((a.y() > at.y()) != (b.y() > at.y()) && at.x() < (b.x() - a.x()) * (at.y() - a.y()) / (b.y() - a.y()) + a.x()) in = !in;
  }
  return in;
}

std::vector<Eigen::Vector2d> polygon(const std::vector<Edge>& outline) {
  std::vector<Eigen::Vector2d> loop;
  for (const Edge& edge : outline)
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) loop.push_back(edge.points[i].at);
  return loop;
}

double topmost(const std::vector<Eigen::Vector2d>& loop) {
  double top = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& point : loop) top = std::max(top, point.y());
  return top;
}

// In the middle of the part, as long as fits.
Grainline grain_on(const std::vector<Eigen::Vector2d>& loop, const Grainline& grain) {
  if (inside(loop, grain.from) && inside(loop, grain.to)) return grain;
  Eigen::Vector2d low = loop.front(), high = loop.front();
  for (const Eigen::Vector2d& point : loop) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Vector2d middle = (low + high) / 2, way = grain.to - grain.from;
  double half = 0.5;
  for (int i = 0; i < 12 && !(inside(loop, middle - half * way) && inside(loop, middle + half * way)); ++i) half *= 0.7;
  return {middle - half * way, middle + half * way};
}

}  // namespace

Piece marked_like(const Piece& whole, std::vector<Edge> outline, const std::vector<int>& copies) {
  const bool same = outline == whole.outline;
  Piece piece = whole;
  piece.outline = std::move(outline);
  piece.notches.clear();
  piece.quantity =
      static_cast<int>(std::count_if(copies.begin(), copies.end(), [&](int copy) { return !is_mirrored(whole, copy); }));
  piece.mirrored_quantity = static_cast<int>(copies.size()) - piece.quantity;
  const auto keep_copies = [&](auto& by_copy) {
    if (by_copy.empty()) return;
    auto kept = by_copy;
    kept.clear();
    for (const int copy : copies)
      kept.push_back(static_cast<std::size_t>(copy) <= by_copy.size() ? by_copy[static_cast<std::size_t>(copy - 1)]
                                                                      : std::nullopt);
    by_copy = std::move(kept);
  };
  keep_copies(piece.placement);
  keep_copies(piece.body_part);
  if (same) return piece;
  const std::vector<Eigen::Vector2d> loop = polygon(piece.outline);
  const double lower = topmost(polygon(whole.outline)) - topmost(loop);
  for (auto& part : piece.body_part)
    if (part && !part->grain_round) part->drop += lower;
  if (piece.grainline) piece.grainline = grain_on(loop, *piece.grainline);
  std::vector<InternalLine> lines;
  for (const InternalLine& line : piece.internal_lines) {
    InternalLine run{{}, line.cut_out};
    const auto close = [&] {
      if (run.points.size() > 1) lines.push_back(run);
      run.points.clear();
    };
    for (const Eigen::Vector2d& point : line.points) {
      if (inside(loop, point))
        run.points.push_back(point);
      else
        close();
    }
    close();
  }
  piece.internal_lines = std::move(lines);
  piece.drill_holes.erase(std::remove_if(piece.drill_holes.begin(), piece.drill_holes.end(),
                                         [&](const DrillHole& hole) { return !inside(loop, hole.at); }),
                          piece.drill_holes.end());
  return piece;
}

void keep_notches(Piece& piece, const Piece& whole, int edge, const std::string& id, double begin, double end) {
  const std::string& of = whole.outline[static_cast<std::size_t>(edge)].id;
  for (Notch notch : whole.notches) {
    if (notch.edge != of || notch.at < begin || notch.at > end) continue;
    notch.edge = id;
    notch.at = std::clamp((notch.at - begin) / (end - begin), 0.0, 1.0);
    piece.notches.push_back(notch);
  }
}

}  // namespace toile
