#include "edit/loops.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <set>

#include "style/synthetic_skirt.h"

namespace toile {
namespace {

using testing::SkirtShape;
using testing::synthetic_skirt;
using testing::SyntheticSkirt;

constexpr int columns = 48, rows = 30;

struct Scene {
  SyntheticSkirt skirt;
  Body body;
  explicit Scene(bool named_edges)
      : skirt(synthetic_skirt({.columns = columns, .rows = rows, .named_edges = named_edges})), body(make_body(skirt.form)) {}
  NamedLoops loops(const std::string& name, LevelSide side = LevelSide::nearer) const {
    return resolve_loops({skirt.pattern, skirt.garment, skirt.drape, body}, name, "here", side);
  }
  Finding finding(const std::string& name) const {
    try {
      loops(name);
    } catch (const BadInput& bad) {
      return bad.finding();
    }
    return {};
  }
};

const Scene& named() {
  static const Scene scene(true);
  return scene;
}
const Scene& unnamed() {
  static const Scene scene(false);
  return scene;
}

std::set<int> row(int r) {
  std::set<int> vertices;
  for (int c = 0; c < columns; ++c) vertices.insert(r * columns + c);
  return vertices;
}
std::set<int> as_set(const VertexLoop& loop) { return {loop.begin(), loop.end()}; }

void expect_edges_of_the_garment(const Scene& scene, const VertexLoop& loop) {
  std::set<std::pair<int, int>> edges;
  for (const MeshEdge& edge : mesh_edges(scene.skirt.garment.triangles)) edges.insert({edge.vertex[0], edge.vertex[1]});
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int a = loop[i], b = loop[(i + 1) % loop.size()];
    EXPECT_TRUE(edges.count({std::min(a, b), std::max(a, b)})) << a << " to " << b;
  }
  EXPECT_EQ(as_set(loop).size(), loop.size());
}

TEST(Loops, ChainEdgesOfOneNameThroughTheSeams) {
  for (const char* name : {"hem", "gore.hem"}) {
    const NamedLoops hem = named().loops(name);
    ASSERT_EQ(hem.loops.size(), 1u);
    EXPECT_EQ(as_set(hem.loops[0]), row(rows - 1));
    expect_edges_of_the_garment(named(), hem.loops[0]);
  }
  EXPECT_EQ(as_set(named().loops("waist").loops.at(0)), row(0));
}

TEST(Loops, FallBackOnTheLowestAndHighestFreeBoundary) {
  EXPECT_EQ(as_set(unnamed().loops("hem").loops.at(0)), row(rows - 1));
  EXPECT_EQ(as_set(unnamed().loops("waist").loops.at(0)), row(0));
}

TEST(Loops, ChainListedEdgesOfPanels) {
  std::string list;
  for (int g = 1; g <= 8; ++g) list += (g > 1 ? ", gore:" : "gore:") + std::to_string(g) + ".e0";
  EXPECT_EQ(as_set(unnamed().loops(list).loops.at(0)), row(rows - 1));
}

TEST(Loops, SayWhereAChainIsOpen) {
  const Finding finding = named().finding("gore:3.hem");
  EXPECT_EQ(finding.code, "edit.open-chain");
  EXPECT_NE(finding.text.find("gore:3.hem"), std::string::npos) << finding.text;
  EXPECT_NE(finding.text.find("400 mm"), std::string::npos) << "the hem is 400 mm above the floor: " << finding.text;
}

TEST(Loops, SayWhereAChainBranches) { EXPECT_EQ(named().finding("hem,gore:1.side_left").code, "edit.open-chain"); }

TEST(Loops, EdgesCalledLikeALandmarkThatDoNotCloseMeanTheLandmark) {
  Scene scene(true);
  const NamedLoops level = scene.loops("hip");
  for (Edge& edge : scene.skirt.pattern.pieces.front().outline)
    if (edge.id == "side_left" || edge.id == "hem") edge.id = "hip";
  const NamedLoops loops = scene.loops("hip");
  EXPECT_EQ(loops.loops, level.loops);
  EXPECT_TRUE(loops.level.has_value());
}

TEST(Loops, OfALevelStayWithinHalfAnEdge) {
  const SyntheticSkirt& skirt = named().skirt;
  double longest = 0;
  for (const MeshEdge& edge : mesh_edges(skirt.garment.triangles))
    longest = std::max(longest, std::abs(skirt.drape(1, edge.vertex[0]) - skirt.drape(1, edge.vertex[1])));
  for (const char* name : {"hip", "thigh.L:0.3", "spine_low:0.4"}) {
    const NamedLoops found = named().loops(name);
    ASSERT_EQ(found.loops.size(), 1u) << name;
    ASSERT_TRUE(found.level.has_value());
    expect_edges_of_the_garment(named(), found.loops[0]);
    for (const int v : found.loops[0]) EXPECT_LE(found.level->absDistance(skirt.drape.col(v)), longest / 2 + 1e-12);
  }
}

TEST(Loops, OfALevelPartTheGarmentOnEitherSide) {
  const SyntheticSkirt& skirt = named().skirt;
  for (const LevelSide side : {LevelSide::before, LevelSide::after}) {
    const NamedLoops found = named().loops("hip", side);
    const std::set<int> cut = as_set(found.loops.at(0));
    for (const int v : cut) EXPECT_EQ(found.level->signedDistance(skirt.drape.col(v)) >= 0, side == LevelSide::after);
    std::vector<int> kept;
    for (Eigen::Index t = 0; t < skirt.garment.triangles.cols(); ++t) {
      const Eigen::Vector3i corners = skirt.garment.triangles.col(t);
      if (!cut.count(corners(0)) && !cut.count(corners(1)) && !cut.count(corners(2))) kept.push_back(static_cast<int>(t));
    }
    const std::vector<int> part =
        components(Eigen::Matrix3Xi(skirt.garment.triangles(Eigen::all, kept)), skirt.garment.vertex_count);
    EXPECT_NE(part[0], part[columns * rows - 1]);
  }
}

TEST(Loops, ListTheNamesThereAre) {
  const Finding finding = named().finding("cuff");
  EXPECT_EQ(finding.code, "edit.unknown-loop");
  for (const char* name : {"gore.hem", "hip", "thigh.L"}) EXPECT_NE(finding.remedy.find(name), std::string::npos) << name;
}

TEST(Loops, RefuseLevelsTheGarmentDoesNotReach) {
  EXPECT_EQ(named().finding("foot.L:0.9").code, "edit.no-loop-there");
  EXPECT_EQ(named().finding("spine_low:2").code, "edit.unknown-loop");
  EXPECT_EQ(named().finding("spine_low:half").code, "edit.unknown-loop");
  EXPECT_EQ(named().finding("").code, "edit.unknown-loop");
}

TEST(Loops, OfALandmarkJustPastTheGarmentAreItsEdge) {
  const Scene& scene = named();
  Mannequin form = scene.skirt.form;
  const double hem = scene.skirt.drape.row(1).minCoeff();
  form.landmarks["below_hem"] = hem - .03;
  form.landmarks["far_below"] = hem - .08;
  const Body body = make_body(form);
  const EditInput input{scene.skirt.pattern, scene.skirt.garment, scene.skirt.drape, body};
  EXPECT_EQ(resolve_loops(input, "below_hem", "here").loops, scene.loops("hem").loops);
  EXPECT_THROW(resolve_loops(input, "far_below", "here"), BadInput);
}

TEST(Loops, OfTrousersAreBothHems) {
  const Scene& scene = named();
  // Two tubes round the legs, joined to nothing.
  constexpr int around = 12, along = 6;
  GarmentMesh tubes;
  tubes.vertex_count = 2 * around * along;
  Eigen::Matrix3Xd drape(3, tubes.vertex_count);
  std::vector<Eigen::Vector3i> triangles;
  for (int leg = 0; leg < 2; ++leg)
    for (int r = 0; r < along; ++r)
      for (int c = 0; c < around; ++c) {
        const int v = (leg * along + r) * around + c;
        const double angle = 2 * 3.14159265 * c / around;
        drape.col(v) = Eigen::Vector3d((leg ? -0.08 : 0.08) + 0.06 * std::sin(angle), 0.6 - 0.08 * r, 0.06 * std::cos(angle));
        if (r + 1 == along) continue;
        const int next = (leg * along + r) * around + (c + 1) % around;
        triangles.emplace_back(v, v + around, next);
        triangles.emplace_back(next, v + around, next + around);
      }
  tubes.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) tubes.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
  const EditInput input{scene.skirt.pattern, tubes, drape, scene.body};
  const auto hems = resolve_loops(input, "hem", "here").loops;
  ASSERT_EQ(hems.size(), 2u);
  for (const VertexLoop& hem : hems)
    for (const int v : hem) EXPECT_NEAR(drape(1, v), 0.2, 1e-12);
  EXPECT_EQ(resolve_loops(input, "thigh.L:0.8", "here").loops.size(), 1u);
  EXPECT_EQ(resolve_loops(input, "knee", "here").loops.size(), 2u);
}

}  // namespace
}  // namespace toile
