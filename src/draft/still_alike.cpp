#include <algorithm>
#include <cmath>
#include <map>

#include "draft/outline_fit.h"
#include "garment/units.h"

namespace toile {
namespace {

// Mean place of a piece's corners in the frame of its shape, by corner of the shape, over its panels.
std::map<int, Eigen::Vector2d> corners_of(int piece, const Sides& sides, const Lay& lay,
                                          const std::vector<PanelOutline>& panels) {
  const int count = static_cast<int>(sides.runs.size());
  std::map<int, Eigen::Vector2d> corners;
  for (int i = 0; i < count; ++i) {
    const Run::Part& part = sides.runs[static_cast<std::size_t>(i)].parts.front();
    if (part.edge_begin > 0) continue;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int found = 0;
    for (const PanelOutline& panel : panels)
      for (const PanelOutline::Sample& sample : panel.samples)
        if (panel.piece == piece && sample.edge == part.edge && sample.at == 0) {
          sum += sample.point;
          ++found;
        }
    const int run = run_of(lay, i, count);
    if (found > 0) corners[lay.reversed ? (run + 1) % count : run] = lay.to_shape(sum / found);
  }
  return corners;
}

std::string names(const Pattern& pattern, const std::vector<int>& pieces) {
  std::string text;
  for (const int p : pieces) text += (text.empty() ? "'" : ", '") + pattern.pieces[static_cast<std::size_t>(p)].name + "'";
  return text;
}

}  // namespace

Likeness still_alike(const Pattern& original, Likeness likeness, const std::vector<PanelOutline>& panels,
                     const RedrawOptions& options, Report& report) {
  const std::size_t shape_count = likeness.shapes.size();
  for (std::size_t s = 0; s < shape_count; ++s) {
    const SharedShape shape = likeness.shapes[s];
    const int count = static_cast<int>(shape.sides.runs.size());
    std::map<int, Eigen::Vector2d> mean;
    std::map<int, int> found;
    std::vector<std::map<int, Eigen::Vector2d>> by_piece;
    for (const int p : shape.pieces) {
      const auto i = static_cast<std::size_t>(p);
      by_piece.push_back(corners_of(p, sides_of(original.pieces[i]), likeness.lays[i], panels));
      for (const auto& [corner, at] : by_piece.back()) {
        if (!mean.count(corner)) mean[corner] = Eigen::Vector2d::Zero();
        mean[corner] += at;
        ++found[corner];
      }
    }
    double apart = 0, lopsided = 0;
    for (auto& [corner, at] : mean) at /= found[corner];
    for (const auto& corners : by_piece)
      for (const auto& [corner, at] : corners) apart = std::max(apart, (at - mean[corner]).norm());
    for (const auto& [corner, at] : mean) {
      if (!shape.mirror) break;
      const auto twin = mean.find((((*shape.mirror - corner + 1) % count) + count) % count);
      if (twin == mean.end()) continue;
      lopsided = std::max(lopsided, (at - Eigen::Vector2d(-twin->second.x(), twin->second.y())).norm() / 2);
    }
    const bool split = shape.pieces.size() > 1 && apart > options.alike_limit;
    if (!split && lopsided <= options.alike_limit) continue;
    report.warn("redraw.no-longer-alike", names(original, shape.pieces),
                std::string(split ? "drawn alike, but adjusted " : "drawn symmetric, but adjusted ") +
                    in_mm(split ? apart : lopsided) +
                    (split ? " apart: each keeps its own shape" : " off it: no longer symmetric"),
                "edit the garment symmetrically if it should stay so");
    const std::vector<int> pieces = shape.pieces;
    const std::vector<int> leaving = split ? std::vector<int>(pieces.begin() + 1, pieces.end()) : std::vector<int>{};
    if (split || pieces.size() == 1) {
      const int first = pieces.front();
      likeness.shapes[s] = on_its_own(original.pieces[static_cast<std::size_t>(first)], first);
      likeness.lays[static_cast<std::size_t>(first)] = {static_cast<int>(s), {}, 0, false};
    } else {
      likeness.shapes[s].mirror.reset();
    }
    for (const int p : leaving) {
      likeness.lays[static_cast<std::size_t>(p)] = {static_cast<int>(likeness.shapes.size()), {}, 0, false};
      likeness.shapes.push_back(on_its_own(original.pieces[static_cast<std::size_t>(p)], p));
    }
  }
  return likeness;
}

}  // namespace toile
