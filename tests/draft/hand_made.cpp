#include "draft/hand_made.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "geometry/polyline.h"

namespace toile {
namespace {

struct OnSide {
  Eigen::Vector2d at;
  BoundaryVertex place;
};

// Vertices along a side in outline order, the first corner included, the last left out.
std::vector<OnSide> side_vertices(const Piece& piece, const Grid& grid, std::size_t side) {
  std::vector<OnSide> vertices;
  for (const int e : grid.sides[side]) {
    const auto points = positions(piece.outline[static_cast<std::size_t>(e)]);
    const int count = grid.divisions[static_cast<std::size_t>(e)];
    for (int i = 0; i < count; ++i) {
      const double at = static_cast<double>(i) / count;
      vertices.push_back({point_at<2>(points, at), {0, e, at}});
    }
  }
  return vertices;
}

PanelMesh panel_mesh(const Piece& piece, const Grid& grid) {
  const auto bottom = side_vertices(piece, grid, 0), right = side_vertices(piece, grid, 1), top = side_vertices(piece, grid, 2),
             left = side_vertices(piece, grid, 3);
  const int nu = static_cast<int>(bottom.size()), nv = static_cast<int>(right.size());
  if (top.size() != bottom.size() || left.size() != right.size()) throw std::logic_error("hand_made: sides do not match");
  const auto id = [&](int i, int j) { return j * (nu + 1) + i; };
  PanelMesh panel;
  panel.rest.resize(2, (nu + 1) * (nv + 1));
  const auto at = [&](const std::vector<OnSide>& side, int i, const std::vector<OnSide>& next) -> Eigen::Vector2d {
    return i < static_cast<int>(side.size()) ? side[static_cast<std::size_t>(i)].at : next[0].at;
  };
  // Coons patch.
  for (int j = 0; j <= nv; ++j)
    for (int i = 0; i <= nu; ++i) {
      const double u = static_cast<double>(i) / nu, v = static_cast<double>(j) / nv;
      const Eigen::Vector2d b = at(bottom, i, right), t = at(top, nu - i, left), r = at(right, j, top),
                            l = at(left, nv - j, bottom);
      panel.rest.col(id(i, j)) =
          (1 - v) * b + v * t + (1 - u) * l + u * r -
          ((1 - u) * (1 - v) * bottom[0].at + u * (1 - v) * right[0].at + u * v * top[0].at + (1 - u) * v * left[0].at);
    }
  panel.triangles.resize(3, 2 * nu * nv);
  Eigen::Index t = 0;
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i) {
      const bool rising = (i < nu / 2) == (j % 2 == 0);
      if (rising) {
        panel.triangles.col(t++) << id(i, j), id(i + 1, j), id(i + 1, j + 1);
        panel.triangles.col(t++) << id(i, j), id(i + 1, j + 1), id(i, j + 1);
      } else {
        panel.triangles.col(t++) << id(i, j), id(i + 1, j), id(i, j + 1);
        panel.triangles.col(t++) << id(i + 1, j), id(i + 1, j + 1), id(i, j + 1);
      }
    }
  const auto add = [&](const OnSide& vertex, int number) {
    panel.boundary.push_back(vertex.place);
    panel.boundary.back().vertex = number;
  };
  for (int i = 0; i < nu; ++i) add(bottom[static_cast<std::size_t>(i)], id(i, 0));
  for (int j = 0; j < nv; ++j) add(right[static_cast<std::size_t>(j)], id(nu, j));
  for (int i = 0; i < nu; ++i) add(top[static_cast<std::size_t>(i)], id(nu - i, nv));
  for (int j = 0; j < nv; ++j) add(left[static_cast<std::size_t>(j)], id(0, nv - j));
  return panel;
}

PanelMesh copy_of(PanelMesh panel, const Piece& piece, int index, int copy) {
  panel.piece = index;
  panel.copy = copy;
  panel.mirrored = is_mirrored(piece, copy);
  panel.name = copies(piece) > 1 ? piece.name + ":" + std::to_string(copy) : piece.name;
  if (panel.mirrored) {
    panel.rest.row(0) *= -1;
    panel.triangles.row(1).swap(panel.triangles.row(2));
    std::reverse(panel.boundary.begin(), panel.boundary.end());
  }
  return panel;
}

// Panel vertices on a span, in its direction.
std::vector<int> on_span(const Pattern& pattern, const std::vector<PanelMesh>& panels, const EdgeSpan& span,
                         std::size_t& panel) {
  const Piece* piece = find_piece(pattern, span.piece);
  const auto edge = static_cast<int>(find_edge(*piece, span.edge) - piece->outline.data());
  panel = 0;
  while (panels[panel].piece != piece - pattern.pieces.data() || panels[panel].copy != span.copy) ++panel;
  std::vector<std::pair<double, int>> found;
  const double low = std::min(span.begin, span.end) - 1e-9, high = std::max(span.begin, span.end) + 1e-9;
  const int next = (edge + 1) % static_cast<int>(piece->outline.size());
  for (const BoundaryVertex& vertex : panels[panel].boundary) {
    if (vertex.edge == edge && vertex.at >= low && vertex.at <= high) found.emplace_back(vertex.at, vertex.vertex);
    if (vertex.edge == next && vertex.at == 0 && high > 1) found.emplace_back(1.0, vertex.vertex);
  }
  std::sort(found.begin(), found.end());
  if (span.begin > span.end) std::reverse(found.begin(), found.end());
  std::vector<int> vertices;
  for (const auto& [at, vertex] : found) vertices.push_back(vertex);
  return vertices;
}

}  // namespace

void mesh(HandMade& made) {
  std::vector<PanelMesh> panels;
  for (std::size_t p = 0; p < made.pattern.pieces.size(); ++p) {
    const Piece& drawn = made.pattern.pieces[p];
    const PanelMesh first = panel_mesh(drawn, made.grids[p]);
    for (int copy = 1; copy <= copies(drawn); ++copy) panels.push_back(copy_of(first, drawn, static_cast<int>(p), copy));
  }
  std::vector<int> offsets{0};
  for (const PanelMesh& panel : panels) offsets.push_back(offsets.back() + static_cast<int>(panel.rest.cols()));
  std::vector<int> parent(static_cast<std::size_t>(offsets.back()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[static_cast<std::size_t>(v)] != v) v = parent[static_cast<std::size_t>(v)];
    return v;
  };
  for (const Seam& s : made.pattern.seams) {
    std::size_t pa = 0, pb = 0;
    const auto a = on_span(made.pattern, panels, s.a, pa), b = on_span(made.pattern, panels, s.b, pb);
    if (a.size() != b.size()) throw std::logic_error("hand_made: seam '" + s.name + "' does not match");
    for (std::size_t i = 0; i < a.size(); ++i) {
      const int u = root(offsets[pa] + a[i]), v = root(offsets[pb] + b[i]);
      parent[static_cast<std::size_t>(std::max(u, v))] = std::min(u, v);
    }
  }
  std::vector<int> number(parent.size(), -1);
  GarmentMesh& garment = made.garment;
  garment = {};
  garment.triangles.resize(3, 0);
  for (std::size_t p = 0; p < panels.size(); ++p) {
    Eigen::VectorXi welded(panels[p].rest.cols());
    for (Eigen::Index v = 0; v < welded.size(); ++v) {
      int& n = number[static_cast<std::size_t>(root(offsets[p] + static_cast<int>(v)))];
      if (n < 0) n = garment.vertex_count++;
      welded(v) = n;
    }
    const Eigen::Index before = garment.triangles.cols();
    garment.triangles.conservativeResize(3, before + panels[p].triangles.cols());
    for (Eigen::Index t = 0; t < panels[p].triangles.cols(); ++t)
      for (int corner = 0; corner < 3; ++corner) garment.triangles(corner, before + t) = welded(panels[p].triangles(corner, t));
    garment.welded.push_back(std::move(welded));
  }
  garment.panels = std::move(panels);
  check(garment);
}

RestShape mapped(const GarmentMesh& garment, const std::function<Eigen::Vector2d(int panel, const Eigen::Vector2d&)>& map) {
  RestShape rest;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const double sign = garment.panels[p].mirrored ? -1 : 1;
    rest.push_back(garment.panels[p].rest);
    for (Eigen::Index v = 0; v < rest.back().cols(); ++v) {
      Eigen::Vector2d x = rest.back().col(v);
      x.x() *= sign;
      x = map(static_cast<int>(p), x);
      x.x() *= sign;
      rest.back().col(v) = x;
    }
  }
  return rest;
}

RestShape shaken(const GarmentMesh& garment, double size, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&] { return size * (static_cast<double>(random()) / 4294967295.0 * 2 - 1); };
  RestShape rest = rest_shape(garment);
  for (Eigen::Matrix2Xd& panel : rest)
    for (Eigen::Index v = 0; v < panel.cols(); ++v) {
      panel(0, v) += next();
      panel(1, v) += next();
    }
  return rest;
}

}  // namespace toile
