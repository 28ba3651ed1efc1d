#include "triangulate/triangulate.h"

#include <gtest/gtest.h>

#include "geometry/topology.h"
#include "triangulate/sample_patterns.h"

namespace toile {
namespace {

TEST(Sew, MakesARingOfTheGoredSkirt) {
  const Pattern skirt = gored_skirt();
  const GarmentMesh garment = sew(skirt, triangulate(skirt));
  const int edges = static_cast<int>(mesh_edges(garment.triangles).size());
  EXPECT_EQ(garment.vertex_count - edges + triangle_count(garment), 0);
  EXPECT_EQ(boundary_loops(garment.triangles).size(), 2u);
}

}  // namespace
}  // namespace toile
