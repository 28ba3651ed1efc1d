#include "edit/mix/unite.h"

#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <set>

#include "draft/places.h"
#include "edit/mix/marks.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

// Where a copy of a piece went: itself into another place, or into the united piece.
struct Place {
  int piece = 0, copy = 1;
  int role = -1;  // 0: the base of a union, 1: the other piece of it
};

class Renaming {
 public:
  Renaming(const Pattern& before, const PieceJoin& join, const UnitedPiece& united)
      : before_(before), join_(join), united_(united) {}

  std::map<std::pair<int, int>, Place> places;  // (piece, copy) of the pattern before

  // False for a span of the edges that were joined.
  bool follow(const Pattern& after, EdgeSpan& span) const {
    const Piece* piece = find_piece(before_, span.piece);
    const auto index = static_cast<int>(piece - before_.pieces.data());
    const auto edge = static_cast<int>(find_edge(*piece, span.edge) - piece->outline.data());
    const Place& place = places.at({index, span.copy});
    const Piece& now = after.pieces[static_cast<std::size_t>(place.piece)];
    span.piece = now.name;
    span.copy = place.copy;
    if (place.role < 0) return true;
    if (edge == (place.role == 0 ? join_.base_edge : join_.other_edge)) return false;
    const std::size_t e = edge_now(place.role, edge);
    span.edge = now.outline[e].id;
    if (united_.origin[e].reversed) {
      span.begin = 1 - span.begin;
      span.end = 1 - span.end;
    }
    return true;
  }

 private:
  std::size_t edge_now(int role, int edge) const {
    const auto found = std::find_if(united_.origin.begin(), united_.origin.end(), [&](const EdgeOrigin& origin) {
      return origin.of_base == (role == 0) && origin.edge == edge;
    });
    return static_cast<std::size_t>(found - united_.origin.begin());
  }

  const Pattern& before_;
  const PieceJoin& join_;
  const UnitedPiece& united_;
};

std::vector<int> copies_left(const Piece& piece, const std::set<int>& joined) {
  std::vector<int> left;
  for (int copy = 1; copy <= copies(piece); ++copy)
    if (!joined.count(copy)) left.push_back(copy);
  return left;
}

// Boundary vertices of `panel` along an edge of its piece, both ends included, in outline order.
std::vector<BoundaryVertex> along_edge(const PanelMesh& panel, int edge, int edges) {
  std::vector<BoundaryVertex> along;
  const BoundaryVertex* end = nullptr;
  for (const BoundaryVertex& vertex : panel.boundary) {
    if (vertex.edge == edge) along.push_back(vertex);
    if (vertex.edge == (edge + 1) % edges && (!end || vertex.at < end->at)) end = &vertex;
  }
  std::sort(along.begin(), along.end(), [](const BoundaryVertex& a, const BoundaryVertex& b) { return a.at < b.at; });
  if (end) along.push_back({end->vertex, edge, 1});
  return along;
}

struct WeldedPanel {
  PanelMesh panel;
  std::vector<int> before;  // [vertex] -> garment vertex of the garment before
};

WeldedPanel welded(const Pattern& pattern, const GarmentMesh& garment, const PieceJoin& join, const UnitedPiece& united,
                   std::size_t a, std::size_t b) {
  const PanelMesh &base = garment.panels[a], &other = garment.panels[b];
  const auto edges_of = [&](int piece) {
    return static_cast<int>(pattern.pieces[static_cast<std::size_t>(piece)].outline.size());
  };
  WeldedPanel result;
  for (Eigen::Index v = 0; v < base.rest.cols(); ++v) result.before.push_back(garment.welded[a](v));
  std::map<int, int> cut;  // garment vertex -> vertex of the base
  for (const BoundaryVertex& v : along_edge(base, join.base_edge, edges_of(join.base)))
    cut[garment.welded[a](v.vertex)] = v.vertex;
  std::vector<int> vertex(static_cast<std::size_t>(other.rest.cols()), -1);
  for (const BoundaryVertex& v : along_edge(other, join.other_edge, edges_of(join.other)))
    vertex[static_cast<std::size_t>(v.vertex)] = cut.at(garment.welded[b](v.vertex));
  const Eigen::Matrix2Xd base_drawn = as_drawn(base, base.rest), other_drawn = as_drawn(other, other.rest);
  std::vector<Eigen::Vector2d> rest;
  for (Eigen::Index v = 0; v < base_drawn.cols(); ++v) rest.push_back(base_drawn.col(v));
  for (std::size_t v = 0; v < vertex.size(); ++v) {
    const Eigen::Vector2d at = united.lay(Eigen::Vector2d(other_drawn.col(static_cast<Eigen::Index>(v))));
    if (vertex[v] >= 0) {
      Eigen::Vector2d& met = rest[static_cast<std::size_t>(vertex[v])];
      met = (met + at) / 2;
      continue;
    }
    vertex[v] = static_cast<int>(rest.size());
    rest.push_back(at);
    result.before.push_back(garment.welded[b](static_cast<Eigen::Index>(v)));
  }
  PanelMesh& panel = result.panel;
  panel.mirrored = base.mirrored;
  panel.rest.resize(2, static_cast<Eigen::Index>(rest.size()));
  for (std::size_t v = 0; v < rest.size(); ++v) panel.rest.col(static_cast<Eigen::Index>(v)) = rest[v];
  panel.rest = as_drawn(panel, panel.rest);
  panel.warp = base.warp;
  panel.triangles.resize(3, base.triangles.cols() + other.triangles.cols());
  panel.triangles.leftCols(base.triangles.cols()) = base.triangles;
  for (Eigen::Index t = 0; t < other.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k)
      panel.triangles(k, base.triangles.cols() + t) = vertex[static_cast<std::size_t>(other.triangles(k, t))];
  if (base.layers.size() > 0 || other.layers.size() > 0) {
    panel.layers = Eigen::VectorXd::Ones(panel.triangles.cols());
    if (base.layers.size() > 0) panel.layers.head(base.layers.size()) = base.layers;
    if (other.layers.size() > 0) panel.layers.tail(other.layers.size()) = other.layers;
  }
  for (std::size_t e = 0; e < united.origin.size(); ++e) {
    const EdgeOrigin& origin = united.origin[e];
    auto along = along_edge(origin.of_base ? base : other, origin.edge, edges_of(origin.of_base ? join.base : join.other));
    if (origin.reversed) std::reverse(along.begin(), along.end());
    along.pop_back();
    for (const BoundaryVertex& v : along)
      panel.boundary.push_back({origin.of_base ? v.vertex : vertex[static_cast<std::size_t>(v.vertex)], static_cast<int>(e),
                                origin.reversed ? 1 - v.at : v.at});
  }
  if (panel.mirrored) std::reverse(panel.boundary.begin(), panel.boundary.end());
  return result;
}

}  // namespace

United unite(const Pattern& pattern, const GarmentMesh& garment, const std::vector<Eigen::Matrix2d>& shapes,
             const PieceJoin& join) {
  const UnitedPiece united = united_piece(pattern, join);
  United result;
  result.edges_apart = united.edges_apart;
  result.grain_turn = united.grain_turn;
  result.pattern = pattern;
  result.pattern.pieces.clear();
  result.pattern.seams.clear();
  std::set<int> joined[2];
  for (const auto& [of_base, of_other] : join.copies) {
    joined[0].insert(of_base);
    joined[1].insert(of_other);
  }
  Renaming renaming(pattern, join, united);
  // [piece][copy - 1]: panels of the garment before, two of them for a united one.
  std::vector<std::vector<std::vector<std::size_t>>> from;
  std::map<std::pair<int, int>, std::size_t> panel_of;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) panel_of[{garment.panels[p].piece, garment.panels[p].copy}] = p;
  const auto add = [&](Piece piece) {
    const std::string own = piece.name;
    for (int i = 2; find_piece(result.pattern, piece.name); ++i) piece.name = own + "_" + std::to_string(i);
    result.pattern.pieces.push_back(std::move(piece));
    from.emplace_back();
    return static_cast<int>(from.size()) - 1;
  };
  for (int p = 0; p < static_cast<int>(pattern.pieces.size()); ++p) {
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(p)];
    if (p == join.base) {
      result.piece = add(united.piece);
      for (std::size_t i = 0; i < join.copies.size(); ++i) {
        const auto [of_base, of_other] = join.copies[i];
        const int copy = static_cast<int>(i) + 1;
        renaming.places[{join.base, of_base}] = {result.piece, copy, 0};
        renaming.places[{join.other, of_other}] = {result.piece, copy, 1};
        from.back().push_back({panel_of.at({join.base, of_base}), panel_of.at({join.other, of_other})});
      }
    }
    const std::vector<int> left = copies_left(piece, p == join.base    ? joined[0]
                                                     : p == join.other ? joined[1]
                                                                       : std::set<int>());
    if (left.empty()) continue;
    Piece rest = marked_like(piece, piece.outline, left);
    rest.notches = piece.notches;
    const int index = add(std::move(rest));
    for (std::size_t i = 0; i < left.size(); ++i) {
      renaming.places[{p, left[i]}] = {index, static_cast<int>(i) + 1, -1};
      from.back().push_back({panel_of.at({p, left[i]})});
    }
  }
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    Seam seam = pattern.seams[s];
    const bool a = renaming.follow(result.pattern, seam.a), b = renaming.follow(result.pattern, seam.b);
    if (!a || !b) continue;
    result.pattern.seams.push_back(std::move(seam));
    result.seam.push_back(static_cast<int>(s));
  }

  const std::vector<int> offsets = triangle_offsets(garment);
  std::vector<PanelMesh> panels;
  std::vector<std::vector<int>> before;
  for (std::size_t p = 0; p < from.size(); ++p)
    for (std::size_t i = 0; i < from[p].size(); ++i) {
      const std::vector<std::size_t>& parts = from[p][i];
      WeldedPanel one;
      if (parts.size() == 2) {
        one = welded(pattern, garment, join, united, parts[0], parts[1]);
      } else {
        one.panel = garment.panels[parts[0]];
        const Eigen::VectorXi& own = garment.welded[parts[0]];
        one.before.assign(own.data(), own.data() + own.size());
      }
      const Piece& piece = result.pattern.pieces[p];
      one.panel.piece = static_cast<int>(p);
      one.panel.copy = static_cast<int>(i) + 1;
      one.panel.name = copies(piece) == 1 ? piece.name : piece.name + ":" + std::to_string(one.panel.copy);
      for (const std::size_t part : parts)
        for (int t = offsets[part]; t < offsets[part + 1]; ++t) result.shapes.push_back(shapes[static_cast<std::size_t>(t)]);
      panels.push_back(std::move(one.panel));
      before.push_back(std::move(one.before));
    }
  result.garment = sew(result.pattern, std::move(panels));
  result.vertex.resize(static_cast<std::size_t>(result.garment.vertex_count));
  for (std::size_t p = 0; p < before.size(); ++p)
    for (std::size_t v = 0; v < before[p].size(); ++v)
      result.vertex[static_cast<std::size_t>(result.garment.welded[p](static_cast<Eigen::Index>(v)))] = before[p][v];
  return result;
}

}  // namespace toile
