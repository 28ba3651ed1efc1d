#include <cmath>

#include "draft/hand_made.h"

namespace toile {
namespace {

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

}  // namespace toile
