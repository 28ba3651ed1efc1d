// What write_obj writes, read as a garment that came draped.

#include <gtest/gtest.h>

#include "formats/folder.h"
#include "formats/formats.h"

namespace toile {
namespace {

// A garment of two gores, one mirrored, as write_obj writes it: one piece cut twice.
TEST(ObjOwn, ReadsItsOwnCopiesAsOnePiece) {
  PanelMesh panel;
  panel.copy = 1;
  panel.name = "gore:1";
  panel.rest.resize(2, 4);
  panel.rest << -.1, .2, .1, -.1, 0, 0, .5, .5;
  panel.triangles.resize(3, 2);
  panel.triangles << 0, 0, 1, 2, 2, 3;
  panel.boundary = {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}};
  PanelMesh other = panel;
  other.copy = 2;
  other.mirrored = true;
  other.name = "gore:2";
  other.rest.row(0) *= -1;
  other.triangles.row(1).swap(other.triangles.row(2));
  GarmentMesh garment;
  garment.panels = {panel, other};
  // Sewn along x = -.1 (edge 3), which is x = .1 of the mirrored one.
  garment.welded = {Eigen::Vector4i(0, 1, 2, 3), Eigen::Vector4i(0, 4, 5, 3)};
  garment.vertex_count = 6;
  garment.triangles.resize(3, 4);
  garment.triangles << 0, 0, 0, 0, 1, 2, 5, 3, 2, 3, 4, 5;
  Eigen::Matrix3Xd positions(3, 6);
  positions << 0, .3, .2, 0, -.3, -.2, 1, 1, 1.5, 1.5, 1, 1.5, 0, 0, 0, 0, 0, 0;
  const test::Folder folder;
  write_obj(folder / "gores.obj", garment, positions);
  const auto loaded = read_pattern_file(folder / "gores.obj");
  ASSERT_TRUE(loaded.value) << in_words(loaded.report.findings.back());
  const Pattern& pattern = loaded.value->pattern;
  ASSERT_EQ(pattern.pieces.size(), 1u);
  EXPECT_EQ(pattern.pieces[0].name, "gore");
  EXPECT_EQ(pattern.pieces[0].quantity, 1);
  EXPECT_EQ(pattern.pieces[0].mirrored_quantity, 1);
  for (std::size_t e = 0; e < 4; ++e)
    EXPECT_NEAR((pattern.pieces[0].outline[e].points[0].at - panel.rest.col(static_cast<Eigen::Index>(e))).norm(), 0, 1e-8);
  ASSERT_EQ(pattern.seams.size(), 1u);
  EXPECT_EQ(pattern.seams[0].a, (EdgeSpan{"gore", 1, "e3", 0, 1}));
  EXPECT_EQ(pattern.seams[0].b, (EdgeSpan{"gore", 2, "e3", 0, 1}));
  EXPECT_FALSE(pattern.seams[0].right_to_wrong);
  ASSERT_EQ(loaded.value->drape.size(), 1u);
  EXPECT_EQ(loaded.value->drape[0].garment.panels[1].boundary.size(), 4u);
  EXPECT_NO_THROW(check(loaded.value->drape[0].garment));
}

}  // namespace
}  // namespace toile
