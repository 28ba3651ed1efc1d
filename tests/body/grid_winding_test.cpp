#include "body/grid_winding.h"

#include <gtest/gtest.h>

#include "body/shapes.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

TEST(GridWinding, CountsNodesOnFacesEdgesAndCornersOnce) {
  // The box's faces, edges and corners all fall on nodes, the hardest case for a ray.
  const auto shape = test::box({.5, .5, .5}, {.25, .25, .25});
  GridFrame grid{Vec::Zero(), .125, {9, 9, 9}};
  const auto winding = winding_on_grid(grid, shape.positions, shape.triangles);
  int inside = 0;
  for (int k = 0; k < 9; ++k)
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 9; ++i) {
        const int found = winding[grid.index(i, j, k)];
        const double away = (grid.at(i, j, k) - Vec::Constant(.5)).cwiseAbs().maxCoeff();
        if (away != .25) {
          EXPECT_EQ(found, away < .25 ? 1 : 0);
        }
        inside += found;
      }
  EXPECT_EQ(inside, 4 * 4 * 4);  // each face belongs to one side only
}

}  // namespace
}  // namespace toile
