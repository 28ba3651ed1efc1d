// Sleeves and collars of garments as they are worn, not as their edges are called.

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "body/parametric.h"
#include "cli/templates.h"
#include "edit/loops.h"
#include "edit/mix/hanging.h"
#include "edit/worn_loops.h"
#include "formats/formats.h"
#include "geometry/polyline.h"
#include "triangulate/triangulate.h"
#include "workbench/workbench.h"

namespace toile {
namespace {

constexpr double edge_length = 40e-3;  // m
constexpr double tolerance = 1e-2;

const Scene& scene() {
  static const Scene one{
      make_body(build_mannequin(value_or_throw(read_size_chart_row(template_file("mannequins", "women.csv"), "38")))),
      value_or_throw(read_fabric(template_file("fabrics", "jersey.toml"))), find_simulator("fem")};
  return one;
}

Pattern t_shirt() { return value_or_throw(read_pattern(std::string(TOILE_SOURCE_DIR) + "/samples/t_shirt/t_shirt.dxf")); }

// With a stand of 3 cm round its neck, closed at the wearer's left shoulder.
Pattern with_stand() {
  Pattern pattern = t_shirt();
  const double back = span_length(pattern, {"BACK", 1, "neck", 0, 1}), front = span_length(pattern, {"FRONT", 1, "neck", 0, 1});
  Piece stand;
  stand.name = "STAND";
  const auto edge = [&](const char* id, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    stand.outline.push_back({id, {{from, true, {}}, {to, true, {}}}, {}, false, false});
  };
  const double length = back + front, height = 30e-3;
  edge("bottom", {0, 0}, {length, 0});
  edge("end", {length, 0}, {length, height});
  edge("top", {length, height}, {0, height});
  edge("begin", {0, height}, {0, 0});
  pattern.pieces.push_back(stand);
  pattern.seams.push_back({"neck back", {"STAND", 1, "bottom", 0, back / length}, {"BACK", 1, "neck", 1, 0}, false});
  pattern.seams.push_back({"neck front", {"STAND", 1, "bottom", back / length, 1}, {"FRONT", 1, "neck", 1, 0}, false});
  pattern.seams.push_back({"stand", {"STAND", 1, "end", 0, 1}, {"STAND", 1, "begin", 1, 0}, false});
  return pattern;
}

const WornGarment& worn_t_shirt() {
  static const WornGarment one = as_worn(wear(t_shirt(), scene(), edge_length, tolerance), edge_length);
  return one;
}

// As if its stand stood upright on the neck of the T-shirt.
WornGarment worn_with_stand() {
  const WornGarment& below = worn_t_shirt();
  const auto hangs = [&](const std::string& piece, int copy, const Eigen::Vector2d& rest) {
    for (std::size_t p = 0; p < below.garment.panels.size(); ++p) {
      const PanelMesh& panel = below.garment.panels[p];
      if (below.pattern.pieces[static_cast<std::size_t>(panel.piece)].name == piece && panel.copy == copy)
        return HangingPanel(panel, below.garment.welded[p], below.drape).at(rest);
    }
    throw std::logic_error("no such panel");
  };
  WornGarment worn;
  worn.pattern = with_stand();
  worn.edge_length = edge_length;
  worn.garment = sew(worn.pattern, triangulate(worn.pattern, {.edge_length = edge_length}));
  worn.drape.resize(3, worn.garment.vertex_count);
  const Piece& stand = worn.pattern.pieces.back();
  const auto neck = [&](const char* piece, double at) {
    return hangs(piece, 1, point_at<2>(positions(*find_edge(*find_piece(worn.pattern, piece), "neck")), at));
  };
  const double length = toile::length(stand.outline[0]), back = worn.pattern.seams[worn.pattern.seams.size() - 3].a.end;
  for (std::size_t p = 0; p < worn.garment.panels.size(); ++p) {
    const PanelMesh& panel = worn.garment.panels[p];
    for (Eigen::Index v = 0; v < panel.rest.cols(); ++v) {
      const Eigen::Vector2d at = panel.rest.col(v);
      const double share = at.x() / length;
      worn.drape.col(worn.garment.welded[p](v)) =
          panel.name != "STAND"
              ? hangs(worn.pattern.pieces[static_cast<std::size_t>(panel.piece)].name, panel.copy, at)
              : Eigen::Vector3d((share < back ? neck("BACK", 1 - share / back) : neck("FRONT", (1 - share) / (1 - back))) +
                                at.y() * Eigen::Vector3d::UnitY());
    }
  }
  return worn;
}

EditInput input_of(const WornGarment& worn) { return {worn.pattern, worn.garment, worn.drape, scene().body}; }

std::set<int> vertices(const std::vector<VertexLoop>& loops) {
  std::set<int> all;
  for (const VertexLoop& loop : loops) all.insert(loop.begin(), loop.end());
  return all;
}

TEST(WornLoops, ArmholesAndNecklineOfATShirtAreTheSeamsThere) {
  const EditInput input = input_of(worn_t_shirt());
  const std::vector<Armhole> found = armholes(input);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].left);
  EXPECT_FALSE(found[1].left);
  EXPECT_GT(loop_centre(input.drape, found[0].loop).x(), 0.1);
  EXPECT_EQ(vertices(resolve_loops(input, "armhole", "").loops),
            vertices(resolve_loops(input, "SLEEVE.cap_front,SLEEVE.cap_back", "").loops));
  EXPECT_EQ(vertices(resolve_loops(input, "armhole.R", "").loops), vertices({found[1].loop}));
  EXPECT_EQ(vertices(resolve_loops(input, "neckline", "").loops),
            vertices(resolve_loops(input, "FRONT.neck,BACK.neck", "").loops));
}

Target mixed(const WornGarment& first, const WornGarment& second, EditArguments arguments) {
  arguments["with"] = "other";
  return find_operation("mix").apply(
      {first.pattern,
       first.garment,
       first.drape,
       scene().body,
       {},
       [&](const std::string&, const Body&, const std::string&) { return std::make_shared<const WornGarment>(second); }},
      arguments);
}

TEST(WornLoops, SleevesOfTheSameGarmentUnderOtherNamesChangeNothing) {
  WornGarment other = worn_t_shirt();
  for (Piece& piece : other.pattern.pieces) {
    piece.name += " B";
    for (Edge& edge : piece.outline) edge.id += "b";
  }
  for (Seam& seam : other.pattern.seams)
    for (EdgeSpan* span : {&seam.a, &seam.b}) {
      span->piece += " B";
      span->edge += "b";
    }
  const Target target = mixed(worn_t_shirt(), other, {{"loop", "SLEEVE.cap_front,SLEEVE.cap_back"}});
  EXPECT_LT((target.positions - target.source).colwise().norm().maxCoeff(), 2e-3);
  EXPECT_TRUE(find_piece(*target.pattern, "SLEEVE B"));
  EXPECT_FALSE(find_piece(*target.pattern, "SLEEVE"));
}

TEST(WornLoops, AStandIsPutOnTheNeckOfAnotherGarment) {
  const WornGarment other = worn_with_stand();
  const EditInput with = input_of(other);
  const auto neck = necklines(with);
  ASSERT_EQ(neck.size(), 1u);
  EXPECT_EQ(vertices(neck), vertices(resolve_loops(with, "STAND.bottom", "").loops));
  const Target target = mixed(worn_t_shirt(), other, {{"loop", "neckline"}, {"keep", "beyond"}});
  EXPECT_TRUE(find_piece(*target.pattern, "STAND"));
  EXPECT_TRUE(find_piece(*target.pattern, "SLEEVE"));
  EXPECT_EQ(target.pattern->pieces.size(), 4u);
  EXPECT_GT(target.positions.row(1).maxCoeff(), worn_t_shirt().drape.row(1).maxCoeff() + 0.015);
  EXPECT_LT(target.normal_deviation_mean, 0.1);
}

}  // namespace
}  // namespace toile
