#include "edit/mix/recut.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "draft/alike.h"
#include "draft/carry.h"
#include "draft/places.h"
#include "draft/redraw.h"
#include "geometry/embed.h"
#include "geometry/polyline.h"
#include "geometry/triangle_shape.h"
#include "triangulate/mating.h"

namespace toile {
namespace {

Eigen::Matrix2d shape_at(const GarmentMesh& garment, Eigen::Index t, const Eigen::Matrix3Xd& at) {
  return triangle_shape(Eigen::Vector3d(at.col(garment.triangles(0, t))), at.col(garment.triangles(1, t)),
                        at.col(garment.triangles(2, t)));
}

RestShape laid_flat(const JoinedPattern& joined, const JoinedGarment& hung, const Eigen::Matrix3Xd& positions) {
  constexpr int rounds = 3;  // each leaves about a tenth of the mismatch
  const GarmentMesh& garment = hung.garment;
  const std::vector<Eigen::Matrix2d> rest = rest_triangles(garment);
  const std::vector<int> offsets = triangle_offsets(garment);
  std::vector<Eigen::Matrix2d> shapes;
  std::vector<FlatMesh> panels;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    panels.push_back({garment.panels[p].rest.cols(), garment.panels[p].triangles});
    for (int t = offsets[p]; t < offsets[p + 1]; ++t)
      shapes.push_back(next_rest(triangle_shape(rest[static_cast<std::size_t>(t)]),
                                 shape_at(garment, t, hung.hanging[hung.side[p]]), shape_at(garment, t, positions)));
  }
  std::vector<MatingEdges> mating = mating_edges(joined.pattern, garment);
  for (MatingEdges& pair : mating)
    if (hung.side[static_cast<std::size_t>(pair.panel_a)] != hung.side[static_cast<std::size_t>(pair.panel_b)]) pair.ratio = 1;
  const Embedder embedder(std::move(panels), std::move(mating), rest);
  RestShape flat = rest_shape(garment);
  for (int round = 0; round < rounds; ++round) {
    flat = embedder.embed(shapes, flat).panels;
    if (round + 1 == rounds) break;
    shapes = rest_triangles(with_rest(garment, flat));
    for (Eigen::Matrix2d& shape : shapes) shape = triangle_shape(shape);
  }
  return flat;
}

// How the boundary of one panel moved, in its order: places on the outline, in the frame of the shape that it shares with
// others.
struct Moved {
  int piece = 0;
  std::vector<int> edges;
  std::vector<double> at;
  std::vector<Eigen::Vector2d> places, by;
};

std::vector<std::vector<Moved>> moves_by_shape(const Pattern& pattern, const GarmentMesh& garment, const RestShape& flat,
                                               const Likeness& likeness) {
  std::vector<std::vector<Moved>> moves(likeness.shapes.size());
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const Lay& lay = likeness.lays[static_cast<std::size_t>(panel.piece)];
    const Eigen::Matrix2Xd before = as_drawn(panel, panel.rest),
                           after = as_drawn(panel, laid_on(panel.rest, panel.triangles, flat[p]));
    Moved moved;
    moved.piece = panel.piece;
    for (const BoundaryVertex& v : panel.boundary) {
      const Edge& edge = pattern.pieces[static_cast<std::size_t>(panel.piece)].outline[static_cast<std::size_t>(v.edge)];
      moved.edges.push_back(v.edge);
      moved.at.push_back(v.at);
      moved.places.push_back(lay.to_shape(point_at<2>(positions(edge), v.at)));
      moved.by.push_back(lay.to_shape.turn * (after.col(v.vertex) - before.col(v.vertex)));
    }
    moves[static_cast<std::size_t>(lay.shape)].push_back(std::move(moved));
  }
  return moves;
}

// What the boundary moved by at `place`, between its vertices; absent where it does not pass there.
std::optional<Eigen::Vector2d> move_at(const Moved& moved, const Eigen::Vector2d& place) {
  constexpr double same = 2e-3;  // m
  double nearest = same;
  std::optional<Eigen::Vector2d> by;
  const std::size_t count = moved.places.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d &a = moved.places[i], way = moved.places[(i + 1) % count] - a;
    const double t = std::clamp((place - a).dot(way) / std::max(1e-18, way.squaredNorm()), 0.0, 1.0);
    const double off = (a + t * way - place).norm();
    if (off > nearest) continue;
    nearest = off;
    by = (1 - t) * moved.by[i] + t * moved.by[(i + 1) % count];
  }
  return by;
}

// The mean over all panels of the shape.
Eigen::Vector2d mean_move(const std::vector<Moved>& moves, const Eigen::Vector2d& place, bool mirror) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0;
  for (const Moved& moved : moves)
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && !mirror) continue;
      const auto by = move_at(moved, {side * place.x(), place.y()});
      if (!by) continue;
      sum += Eigen::Vector2d(side * by->x(), by->y());
      ++count;
    }
  return count > 0 ? Eigen::Vector2d(sum / count) : Eigen::Vector2d::Zero();
}

// A cubic through both ends, nearest to the others.
Eigen::Vector2d smooth_move(const std::vector<double>& at, const std::vector<Eigen::Vector2d>& by, double t) {
  const auto straight = [&](double s) { return Eigen::Vector2d((1 - s) * by.front() + s * by.back()); };
  if (at.size() < 4) return straight(t);
  Eigen::MatrixXd terms(static_cast<Eigen::Index>(at.size()), 2);
  Eigen::MatrixXd off(static_cast<Eigen::Index>(at.size()), 2);
  const auto row = [](double s) { return Eigen::RowVector2d(s * (1 - s), s * (1 - s) * (2 * s - 1)); };
  for (std::size_t i = 0; i < at.size(); ++i) {
    terms.row(static_cast<Eigen::Index>(i)) = row(at[i]);
    off.row(static_cast<Eigen::Index>(i)) = (by[i] - straight(at[i])).transpose();
  }
  const Eigen::MatrixXd weights = terms.colPivHouseholderQr().solve(off);
  return straight(t) + (row(t) * weights).transpose();
}

}  // namespace

double joint_mismatch(const JoinedPattern& joined) {
  double worst = 0;
  for (std::size_t s = static_cast<std::size_t>(joined.first_joint); s < joined.pattern.seams.size(); ++s) {
    const double a = span_length(joined.pattern, joined.pattern.seams[s].a),
                 b = span_length(joined.pattern, joined.pattern.seams[s].b);
    worst = std::max(worst, 2 * std::abs(a - b) / (a + b));
  }
  return worst;
}

Recut recut(const JoinedPattern& joined, const JoinedGarment& hung, const Eigen::Matrix3Xd& positions) {
  return drawn_through(joined.pattern, hung.garment, laid_flat(joined, hung, positions));
}

Recut drawn_through(const Pattern& pattern, const GarmentMesh& garment, const RestShape& flat) {
  const Likeness likeness = find_likeness(pattern, 1e-4);
  const auto moves = moves_by_shape(pattern, garment, flat, likeness);
  Recut result;
  result.pattern = pattern;
  for (std::size_t p = 0; p < result.pattern.pieces.size(); ++p) {
    const Lay& lay = likeness.lays[p];
    const auto shape = static_cast<std::size_t>(lay.shape);
    Piece& piece = result.pattern.pieces[p];
    const auto count = piece.outline.size();
    std::vector<std::vector<double>> at(count);
    for (const Moved& moved : moves[shape])
      for (std::size_t i = 0; moved.piece == static_cast<int>(p) && i < moved.at.size(); ++i)
        at[static_cast<std::size_t>(moved.edges[i])].push_back(moved.at[i]);
    for (std::size_t e = 0; e < count; ++e) {
      Edge& edge = piece.outline[e];
      const Edge whole = pattern.pieces[p].outline[e];
      std::vector<double>& places = at[e];
      places.push_back(0);
      places.push_back(1);
      std::sort(places.begin(), places.end());
      places.erase(std::unique(places.begin(), places.end()), places.end());
      std::vector<Eigen::Vector2d> by;
      for (const double place : places)
        by.push_back(lay.to_shape.turn.transpose() * mean_move(moves[shape],
                                                               lay.to_shape(point_at<2>(toile::positions(whole), place)),
                                                               likeness.shapes[shape].mirror.has_value()));
      double along = 0;
      const double size = length(whole);
      for (std::size_t i = 0; i < edge.points.size(); ++i) {
        if (i > 0) along += (whole.points[i].at - whole.points[i - 1].at).norm();
        edge.points[i].at += smooth_move(places, by, i + 1 == edge.points.size() ? 1 : along / size);
      }
    }
  }
  result.garment = with_rest(garment, rest_on_outlines(result.pattern, garment, flat));
  const std::vector<std::vector<double>> places = places_on_outline(garment, flat);
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    for (std::size_t i = 0; i < places[p].size(); ++i) result.garment.panels[p].boundary[i].at = places[p][i];
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    if (panel.copy != 1) continue;
    Eigen::Matrix3Xi triangles = panel.triangles;
    if (panel.mirrored) triangles.row(1).swap(triangles.row(2));
    carry_marks(result.pattern.pieces[static_cast<std::size_t>(panel.piece)], triangles, as_drawn(panel, panel.rest),
                as_drawn(panel, result.garment.panels[p].rest));
  }
  return result;
}

}  // namespace toile
