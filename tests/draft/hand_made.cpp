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

Piece piece(const std::string& name, std::vector<Edge> outline, int quantity = 1, int mirrored = 0) {
  Piece made;
  made.name = name;
  made.outline = std::move(outline);
  made.quantity = quantity;
  made.mirrored_quantity = mirrored;
  return made;
}

Seam seam(const std::string& name, const EdgeSpan& a, const EdgeSpan& b) { return {name, a, b, false}; }

}  // namespace

Edge edge(const std::string& id, const Line& points) {
  Edge made;
  made.id = id;
  for (const Eigen::Vector2d& point : points) made.points.push_back({point, false, std::nullopt});
  made.points.front().turn = made.points.back().turn = true;
  return made;
}

Line bulge(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double rise, int segments) {
  const Eigen::Vector2d chord = b - a, right = Eigen::Vector2d(chord.y(), -chord.x()).normalized();
  Line points;
  for (int i = 0; i <= segments; ++i) {
    const double t = static_cast<double>(i) / segments;
    points.push_back(a + t * chord + 4 * t * (1 - t) * rise * right);
  }
  return points;
}

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

HandMade gored_skirt(double hip) {
  const Eigen::Vector2d a(-.12, 0), b(.12, 0), c(.045, .5), d(-.045, .5);
  const auto side = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return hip > 0 ? bulge(from, to, hip) : Line{from, to};
  };
  HandMade made;
  made.pattern.pieces = {
      piece("gore", {edge("hem", bulge(a, b, .02)), edge("right", side(b, c)), edge("waist", {c, d}), edge("left", side(d, a))},
            8),
      piece("band", {edge("lower", {{0, 0}, {.72, 0}}), edge("end", {{.72, 0}, {.72, .05}}),
                     edge("upper", {{.72, .05}, {0, .05}}), edge("start", {{0, .05}, {0, 0}})})};
  made.pattern.pieces[0].grainline = Grainline{{0, .1}, {0, .4}};
  made.pattern.pieces[0].notches = {{"right", .3, NotchKind::v, 4e-3, 0}, {"left", .7, NotchKind::v, 4e-3, 0}};
  made.pattern.pieces[0].internal_lines = {{{{-.05, .2}, {.05, .2}}, false}};
  made.pattern.pieces[0].drill_holes = {{{.01, .3}, 3e-3}};
  for (int i = 0; i < 8; ++i) {
    made.pattern.seams.push_back(
        seam("side" + std::to_string(i), {"gore", i + 1, "right", 0, 1}, {"gore", (i + 1) % 8 + 1, "left", 1, 0}));
    made.pattern.seams.push_back(
        seam("waist" + std::to_string(i), {"band", 1, "lower", i / 8.0, (i + 1) / 8.0}, {"gore", i + 1, "waist", 1, 0}));
  }
  made.pattern.seams.push_back(seam("back", {"band", 1, "end", 0, 1}, {"band", 1, "start", 1, 0}));
  made.grids = {{{{{0}, {1}, {2}, {3}}}, {8, 20, 8, 20}}, {{{{0}, {1}, {2}, {3}}}, {64, 4, 64, 4}}};
  mesh(made);
  return made;
}

HandMade gores_one_by_one() {
  HandMade made;
  const Eigen::Vector2d a(0, 0), b(.4, 0), c(.26, .55), d(.14, .55);
  for (int i = 0; i < 4; ++i) {
    std::vector<Edge> outline{edge("e0", {a, b}), edge("e1", {b, c})};
    if (i < 3)
      outline.insert(outline.end(), {edge("e2", {c, d}), edge("e3", {d, a})});
    else
      outline.insert(outline.end(), {edge("e2", {c, {.16, .55}}), edge("e3", {{.16, .55}, d}), edge("e4", {d, a})});
    made.pattern.pieces.push_back(piece("gore_" + std::to_string(i), outline));
    made.grids.push_back(i < 3 ? Grid{{{{0}, {1}, {2}, {3}}}, {6, 12, 6, 12}}
                               : Grid{{{{0}, {1}, {2, 3}, {4}}}, {6, 12, 5, 1, 12}});
  }
  // front meets gores 0, 1 and the last two centimetres of gore 3; back meets the rest of gore 3 and gore 2.
  const auto band = [&](const std::string& name, const std::vector<double>& marks) {
    std::vector<Edge> outline;
    for (std::size_t i = 1; i < marks.size(); ++i)
      outline.push_back(edge("b" + std::to_string(i - 1), {{marks[i - 1], 0}, {marks[i], 0}}));
    const double end = marks.back();
    outline.insert(outline.end(), {edge("end", {{end, 0}, {end, .05}}), edge("upper", {{end, .05}, {0, .05}}),
                                   edge("start", {{0, .05}, {0, 0}})});
    return piece(name, outline);
  };
  made.pattern.pieces.push_back(band("front", {0, .12, .24, .26}));
  made.grids.push_back({{{{0, 1, 2}, {3}, {4}, {5}}}, {6, 6, 1, 3, 13, 3}});
  made.pattern.pieces.push_back(band("back", {0, .1, .22}));
  made.grids.push_back({{{{0, 1}, {2}, {3}, {4}}}, {5, 6, 3, 11, 3}});
  const auto sides = [&](int i, int j, const std::string& left) {
    made.pattern.seams.push_back(seam("side" + std::to_string(i), {"gore_" + std::to_string(i), 1, "e1", 0, 1},
                                      {"gore_" + std::to_string(j), 1, left, 1, 0}));
  };
  sides(0, 1, "e3");
  sides(1, 3, "e4");
  sides(3, 2, "e3");
  sides(2, 0, "e3");
  const auto waist = [&](const std::string& belt, const std::string& be, const std::string& gore, const std::string& ge) {
    made.pattern.seams.push_back(seam(belt + be, {belt, 1, be, 0, 1}, {gore, 1, ge, 1, 0}));
  };
  waist("front", "b0", "gore_0", "e2");
  waist("front", "b1", "gore_1", "e2");
  waist("front", "b2", "gore_3", "e3");
  waist("back", "b0", "gore_3", "e2");
  waist("back", "b1", "gore_2", "e2");
  made.pattern.seams.push_back(seam("band_left", {"front", 1, "end", 0, 1}, {"back", 1, "start", 1, 0}));
  made.pattern.seams.push_back(seam("band_right", {"front", 1, "start", 0, 1}, {"back", 1, "end", 1, 0}));
  mesh(made);
  return made;
}

HandMade curved_bodice(double ease) {
  HandMade made;
  const Eigen::Vector2d a(0, 0), b(.25, 0), c(.24, .22), d(.13, .42);
  // A quarter of an ellipse: deeper than its chord, smooth, met by the side at a corner.
  Line armhole;
  for (int i = 0; i <= 30; ++i) {
    const double t = i / 30.0 * 1.5707963267948966;
    armhole.push_back({c.x() - (c.x() - d.x()) * std::sin(t), d.y() - (d.y() - c.y()) * std::cos(t)});
  }
  made.pattern.pieces.push_back(piece("front",
                                      {edge("hem", {a, b}), edge("side", bulge(b, c, -.008)), edge("armhole", armhole),
                                       edge("shoulder", {d, {.0, .40}}), edge("centre", {{.0, .40}, a})},
                                      1, 1));
  made.pattern.pieces[0].notches = {{"armhole", .4, NotchKind::slit, 4e-3, 0}};
  made.grids.push_back({{{{0}, {1, 2}, {3}, {4}}}, {10, 8, 12, 10, 20}});
  const double w = .26, h = length(made.pattern.pieces[0].outline[1]) / ease;
  made.pattern.pieces.push_back(piece("back", {edge("hem", {{-w, 0}, {w, 0}}), edge("right", {{w, 0}, {w, h}}),
                                               edge("neck", bulge({w, h}, {-w, h}, -.03)), edge("left", {{-w, h}, {-w, 0}})}));
  made.grids.push_back({{{{0}, {1}, {2}, {3}}}, {20, 8, 20, 8}});
  made.pattern.seams = {seam("left", {"front", 1, "side", 0, 1}, {"back", 1, "left", 1, 0}),
                        seam("right", {"front", 2, "side", 0, 1}, {"back", 1, "right", 0, 1})};
  mesh(made);
  return made;
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
