#include "formats/dxf_aama/flat.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "formats/dxf_aama/chains.h"
#include "formats/dxf_aama/layers.h"
#include "formats/dxf_aama/texts.h"

namespace toile::aama {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double smallest_piece = 0.04;  // of the largest piece's larger side
constexpr double lettering = 0.02;       // likewise
constexpr double joined_at = 2e-5;       // of the drawing's size: ends nearer than this join
constexpr double chord = 5e-6;           // likewise: how far curves may be from their chords
constexpr std::size_t most_lines = 20'000;

AlignedBox2d box_of(const Points<2>& points) {
  AlignedBox2d box;
  for (const Vector2d& p : points) box.extend(p);
  return box;
}

bool is_line(const dxf::Entity& entity) { return entity.kind == dxf::Kind::line || entity.kind == dxf::Kind::polyline; }

// 0: layer 1 or 84; 1: layer 14 or 87; 2: a layer without a meaning; 3: any other.
int rank_of(const dxf::Entity& entity) {
  switch (role_of(entity.layer)) {
    case Role::cut_line:
    case Role::dense_cut_line:
      return 0;
    case Role::sew_line:
    case Role::dense_sew_line:
      return 1;
    case Role::unknown:
      return 2;
    default:
      return 3;
  }
}

bool inside(const Points<2>& ring, const Vector2d& p) {
  bool odd = false;
  for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++)
    if ((ring[i].y() > p.y()) != (ring[k].y() > p.y()) &&
        p.x() < (ring[k].x() - ring[i].x()) * (p.y() - ring[i].y()) / (ring[k].y() - ring[i].y()) + ring[i].x())
      odd = !odd;
  return odd;
}

struct Ring {
  Points<2> points;
  AlignedBox2d box;
  double area = 0;
  int line = 0;
  std::string layer;
};

// Whether nearly all of `points` lies in the ring or on it.
bool holds(const Ring& ring, const Points<2>& points) {
  if (!ring.box.intersects(box_of(points))) return false;
  const std::size_t step = std::max<std::size_t>(1, points.size() / 64);
  const Points<2> loop = closed_polyline(ring.points);
  int in = 0, all = 0;
  for (std::size_t i = 0; i < points.size(); i += step) {
    ++all;
    in += inside(ring.points, points[i]) || nearest_on<2>(loop, points[i]).distance <= closing_gap;
  }
  return in >= .9 * all;
}

bool is_upright_rectangle(const Ring& ring) { return std::abs(ring.area - ring.box.volume()) <= 1e-3 * ring.box.volume(); }

// The drawing at a size of 25 m, so that the tolerances of chains() are those of a drawing.
class Flat {
 public:
  Flat(const std::vector<dxf::Entity>& entities, const std::string& file, Report& report)
      : entities_(entities), file_(file), report_(report) {
    AlignedBox2d box;
    for (const dxf::Entity& entity : entities)
      if (is_line(entity))
        for (const Vector2d& p : entity.points) box.extend(p);
    size_ = box.isEmpty() ? 1 : std::max(box.diagonal().norm(), 1e-9);
    scale_ = closing_gap / (joined_at * size_);
  }

  std::vector<dxf::Block> pieces() {
    if (static_cast<std::size_t>(std::count_if(entities_.begin(), entities_.end(), is_line)) > most_lines) {
      report_.error("dxf.too-large", file_, "a flat drawing of more than 20000 lines",
                    "export the pieces as DXF-AAMA or DXF-ASTM, or the drawing without its lettering");
      return {};
    }
    for (int rank = 0; rank < 3 && rings_.empty(); ++rank) find_rings(rank);
    if (rings_.empty()) return {};
    choose_outlines();
    for (const Ring& outline : outlines_) {
      dxf::Block block;
      block.line = outline.line;
      block.entities.push_back(polyline(outline.points, true, "1", outline.line));
      blocks_.push_back(std::move(block));
    }
    add_lines();
    add_marks();
    name_pieces();
    report_findings();
    return std::move(blocks_);
  }

 private:
  Run run_of(const dxf::Entity& entity) const {
    Run run{{}, entity.closed, entity.line};
    for (const Vector2d& p : entity.kind == dxf::Kind::polyline ? dxf::flattened(entity, chord * size_) : entity.points)
      run.points.push_back(scale_ * p);
    return run;
  }

  dxf::Entity polyline(const Points<2>& points, bool closed, const std::string& layer, int line) const {
    dxf::Entity entity;
    entity.kind = dxf::Kind::polyline;
    entity.type = "POLYLINE";
    entity.layer = layer;
    entity.line = line;
    entity.closed = closed;
    for (const Vector2d& p : points) entity.points.push_back(p / scale_);
    return entity;
  }

  // Drawing programs write a path piece by piece: what goes on exactly where the line before ended belongs to it, even where
  // other lines end there too.
  static std::vector<Run> joined_in_file_order(const std::vector<Run>& runs) {
    constexpr double exactly = closing_gap / 20;
    std::vector<Run> joined;
    for (const Run& run : runs) {
      const bool goes_on = !joined.empty() && !joined.back().closed && !run.closed && !run.points.empty() &&
                           !joined.back().points.empty() &&
                           (joined.back().points.back() - run.points.front()).norm() <= exactly &&
                           (joined.back().points.size() < 3 ||
                            (joined.back().points.back() - joined.back().points.front()).norm() > closing_gap);
      if (goes_on)
        joined.back().points.insert(joined.back().points.end(), run.points.begin() + 1, run.points.end());
      else
        joined.push_back(run);
    }
    return joined;
  }

  void find_rings(int rank) {
    std::map<std::string, std::vector<Run>> by_layer;
    for (const dxf::Entity& entity : entities_)
      if (is_line(entity) && rank_of(entity) == rank) by_layer[entity.layer].push_back(run_of(entity));
    rank_ = rank;
    for (const auto& [layer, runs] : by_layer)
      for (Chain& chain : chains(joined_in_file_order(runs))) {
        const double area = std::abs(signed_area(chain.points));
        if (chain.closed && chain.points.size() > 2 && area > 0) {
          const AlignedBox2d box = box_of(chain.points);
          rings_.push_back({std::move(chain.points), box, area, chain.line, layer});
        } else {
          open_.emplace_back(layer, std::move(chain));
        }
      }
    std::stable_sort(rings_.begin(), rings_.end(), [](const Ring& a, const Ring& b) { return a.area > b.area; });
  }

  void choose_outlines() {
    // The sheet: a rectangle round everything, with pieces side by side in it.
    if (rings_.size() > 2 && is_upright_rectangle(rings_[0])) {
      std::vector<const Ring*> in_it;
      for (std::size_t i = 1; i < rings_.size(); ++i)
        if (holds(rings_[0], rings_[i].points) &&
            std::none_of(in_it.begin(), in_it.end(), [&](const Ring* other) { return holds(*other, rings_[i].points); }) &&
            rings_[i].box.sizes().maxCoeff() > smallest_piece * rings_[0].box.sizes().maxCoeff())
          in_it.push_back(&rings_[i]);
      if (in_it.size() > 1) {
        sheet_line_ = rings_[0].line;
        rings_.erase(rings_.begin());
      }
    }
    const double largest = rings_.front().box.sizes().maxCoeff();
    for (Ring& ring : rings_) {
      const double size = ring.box.sizes().maxCoeff();
      const bool top =
          std::none_of(outlines_.begin(), outlines_.end(), [&](const Ring& outline) { return holds(outline, ring.points); });
      (top && size >= smallest_piece * largest ? outlines_ : inner_).push_back(ring);
    }
    smallest_line_ = lettering * largest;
    // In the order of the file.
    std::stable_sort(outlines_.begin(), outlines_.end(), [](const Ring& a, const Ring& b) { return a.line < b.line; });
  }

  dxf::Block* piece_with(const Points<2>& points) {
    for (std::size_t i = 0; i < outlines_.size(); ++i)
      if (holds(outlines_[i], points)) return &blocks_[i];
    return nullptr;
  }

  static std::string inner_layer(const std::string& layer) {
    const Role role = role_of(layer);
    return role == Role::unknown || role == Role::cut_line || role == Role::dense_cut_line ? "8" : layer;
  }

  void add_line(const Points<2>& points, bool closed, const std::string& layer, int line) {
    dxf::Block* block = piece_with(points);
    if (!block)
      ++outside_;
    else if (rank_ == 2 && box_of(points).sizes().maxCoeff() < smallest_line_)
      ++lettering_;
    else
      block->entities.push_back(polyline(points, closed, inner_layer(layer), line));
  }

  void add_lines() {
    for (const Ring& ring : inner_) add_line(ring.points, true, ring.layer, ring.line);
    for (const auto& [layer, chain] : open_) add_line(chain.points, false, layer, chain.line);
    for (const dxf::Entity& entity : entities_) {
      if (!is_line(entity) || rank_of(entity) == rank_) continue;
      const Run run = run_of(entity);
      if (dxf::Block* block = piece_with(run.points)) {
        block->entities.push_back(entity);
        block->entities.back().layer = inner_layer(entity.layer);
      } else {
        ++outside_;
      }
    }
  }

  void add_marks() {
    for (const dxf::Entity& entity : entities_) {
      if (is_line(entity)) continue;
      dxf::Block* block = entity.points.empty() ? nullptr : piece_with({scale_ * entity.points.front()});
      if (!block) {
        // Texts and inserts outside were read as the style's.
        if (entity.kind != dxf::Kind::text) ++outside_;
        continue;
      }
      block->entities.push_back(entity);
      if (entity.kind == dxf::Kind::text && role_of(entity.layer) == Role::unknown) block->entities.back().layer = "1";
    }
  }

  void name_pieces() {
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      blocks_[i].layer = "1";
      blocks_[i].name = "piece-" + std::to_string(i + 1);
      for (const dxf::Entity& entity : blocks_[i].entities)
        if (is_piece_text(entity) && key_value(entity.text).key.empty() && !entity.text.empty() && !grade_rule(entity.text)) {
          blocks_[i].name = entity.text;
          break;
        }
    }
  }

  void report_findings() {
    const auto many = [](int count, const char* what) { return std::to_string(count) + " " + what + (count == 1 ? "" : "s"); };
    report_.warn("aama.flat-drawing", file_,
                 "a flat drawing without a block for each piece: " + many(static_cast<int>(blocks_.size()), "piece") +
                     " found by which closed lines lie in no other",
                 "check the pieces; if some are missing or joined, export as DXF-AAMA or DXF-ASTM");
    if (sheet_line_ > 0)
      report_.note("aama.sheet-frame", file_ + ":" + std::to_string(sheet_line_),
                   "the rectangle round all pieces is taken for the sheet and left out");
    if (lettering_ > 0)
      report_.note(
          "aama.lettering", file_,
          many(lettering_, "line") + " inside pieces, smaller than 2 % of the largest, are taken for lettering and left out");
    if (outside_ > 0) report_.note("aama.outside-pieces", file_, many(outside_, "entity") + " in no piece left out");
  }

  const std::vector<dxf::Entity>& entities_;
  const std::string& file_;
  Report& report_;
  double size_ = 1, scale_ = 1, smallest_line_ = 0;
  int rank_ = 0, lettering_ = 0, outside_ = 0, sheet_line_ = 0;
  std::vector<Ring> rings_, outlines_, inner_;
  std::vector<std::pair<std::string, Chain>> open_;
  std::vector<dxf::Block> blocks_;
};

}  // namespace

std::vector<dxf::Block> pieces_by_containment(const std::vector<dxf::Entity>& entities, const std::string& file,
                                              Report& report) {
  return Flat(entities, file, report).pieces();
}

}  // namespace toile::aama
