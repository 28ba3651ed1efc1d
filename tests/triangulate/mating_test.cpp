#include "triangulate/mating.h"

#include <gtest/gtest.h>

#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

TEST(MatingEdges, AreWeldedEndToEnd) {
  const Pattern skirt = gored_skirt();
  const GarmentMesh garment = sew(skirt, triangulate(skirt));
  const auto edges = mating_edges(skirt, garment);
  ASSERT_GT(edges.size(), 8u * 40);
  for (const MatingEdges& e : edges) {
    const auto& a = garment.welded[static_cast<std::size_t>(e.panel_a)];
    const auto& b = garment.welded[static_cast<std::size_t>(e.panel_b)];
    EXPECT_EQ(a(e.a_from), b(e.b_from));
    EXPECT_EQ(a(e.a_to), b(e.b_to));
    EXPECT_NE(a(e.a_from), a(e.a_to));
  }
}

TEST(MatingEdges, KeepTheEaseThatWasDrawn) {
  const Pattern pattern = eased_seam(1.2);
  GarmentMesh garment = sew(pattern, triangulate(pattern));
  for (const MatingEdges& e : mating_edges(pattern, garment)) EXPECT_NEAR(e.ratio, 1.2, 1e-9);
  garment.panels[0].rest *= 1.1;
  for (const MatingEdges& e : mating_edges(pattern, garment)) EXPECT_NEAR(e.ratio, 1.2, 1e-9);
}

TEST(MatingEdges, AreEvenBetweenMirroredCopies) {
  const Pattern pattern = mirrored_fronts();
  for (const MatingEdges& e : mating_edges(pattern, sew(pattern, triangulate(pattern)))) {
    EXPECT_EQ(e.a_from, e.b_from);
    EXPECT_EQ(e.a_to, e.b_to);
    EXPECT_DOUBLE_EQ(e.ratio, 1);
  }
}

}  // namespace
}  // namespace toile
