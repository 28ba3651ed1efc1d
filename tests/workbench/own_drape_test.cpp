// Our own drape, written as OBJ and read as a garment that came draped.

#include <gtest/gtest.h>

#include "body/parametric.h"
#include "cli/templates.h"
#include "formats/folder.h"
#include "formats/formats.h"
#include "workbench/workbench.h"

namespace toile {
namespace {

double nearest_corner(const Piece& piece, const Eigen::Vector2d& to) {
  double near = INFINITY;
  for (const Edge& edge : piece.outline) near = std::min(near, (edge.points.front().at - to).norm());
  return near;
}

TEST(OwnDrape, ComesBackAsThePatternItWasSewnFrom) {
  const auto chart = template_file("mannequins", "women.csv");
  const Scene scene{make_body(build_mannequin(value_or_throw(read_size_chart_row(chart, "38")))),
                    value_or_throw(read_fabric(template_file("fabrics", "cotton_poplin.toml"))), find_simulator("fem")};
  const Pattern pattern = value_or_throw(read_pattern(std::string(TOILE_SOURCE_DIR) + "/samples/gored_skirt/gored_skirt.dxf"));
  const Worn worn = wear(pattern, scene, 45e-3, 1e-2);
  const test::Folder folder;
  write_obj(folder / "skirt.obj", worn.garment, worn.drape.positions);
  const auto loaded = read_pattern_file(folder / "skirt.obj");
  ASSERT_TRUE(loaded.value) << in_words(loaded.report.findings.back());
  const PatternFile& file = *loaded.value;
  EXPECT_NEAR(file.units.in_metres, 1, 1e-12);
  ASSERT_EQ(file.pattern.pieces.size(), pattern.pieces.size());
  for (const Piece& piece : pattern.pieces) {
    SCOPED_TRACE(piece.name);
    const Piece* same = find_piece(file.pattern, piece.name);
    ASSERT_TRUE(same);
    EXPECT_EQ(copies(*same), copies(piece));
    EXPECT_EQ(same->outline.size(), piece.outline.size());
    for (const Edge& edge : piece.outline) EXPECT_LT(nearest_corner(*same, edge.points.front().at), .05e-3) << edge.id;
  }
  EXPECT_GE(file.pattern.seams.size(), pattern.seams.size());
  ASSERT_EQ(file.drape.size(), 1u);
  EXPECT_EQ(file.drape[0].positions.cols(), worn.drape.positions.cols());
  EXPECT_NEAR((file.drape[0].positions.rowwise().minCoeff() - worn.drape.positions.rowwise().minCoeff()).norm(), 0, 1e-6);
  EXPECT_NEAR((file.drape[0].positions.rowwise().maxCoeff() - worn.drape.positions.rowwise().maxCoeff()).norm(), 0, 1e-6);
}

}  // namespace
}  // namespace toile
