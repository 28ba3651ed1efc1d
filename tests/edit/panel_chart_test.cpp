#include "edit/length/panel_chart.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "geometry/normals.h"

namespace toile {
namespace {

constexpr double radius = 0.1, spacing = 0.02;  // m: facets of a cylinder that lie half a millimetre inside it
constexpr int columns = 11, rows = 11;

// A square panel of 20 cm bent round a vertical cylinder; its lowest row comes first.
struct OnCylinder {
  PanelMesh panel;
  Eigen::Matrix3Xd draped, normals;

  OnCylinder() {
    panel.rest.resize(2, columns * rows);
    draped.resize(3, columns * rows);
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        panel.rest.col(r * columns + c) = spacing * Eigen::Vector2d(c, r);
        draped.col(r * columns + c) = hangs(spacing * Eigen::Vector2d(c, r));
      }
    panel.triangles.resize(3, 2 * (columns - 1) * (rows - 1));
    int t = 0;
    for (int r = 0; r + 1 < rows; ++r)
      for (int c = 0; c + 1 < columns; ++c) {
        const int a = r * columns + c;
        panel.triangles.col(t++) << a, a + 1, a + columns + 1;
        panel.triangles.col(t++) << a, a + columns + 1, a + columns;
      }
    normals = vertex_normals(draped, panel.triangles);
  }

  static Eigen::Vector3d hangs(const Eigen::Vector2d& rest) {
    return {radius * std::sin(rest.x() / radius), rest.y(), radius * std::cos(rest.x() / radius)};
  }
};

TEST(PanelChart, FollowsTheRoundSurfaceBetweenVertices) {
  const OnCylinder on;
  const PanelChart chart(on.panel, on.draped, on.normals);
  double off = 0;
  for (double x = 0.03; x < 0.17; x += 0.0013)
    for (double y = 0.03; y < 0.17; y += 0.0071) {
      const Eigen::Vector3d at = chart.at({x, y});
      off = std::max(off, std::abs(std::hypot(at.x(), at.z()) - radius));
    }
  EXPECT_LT(off, 0.02e-3);
}

TEST(PanelChart, IsTheVertexAtAVertex) {
  const OnCylinder on;
  const PanelChart chart(on.panel, on.draped, on.normals);
  for (Eigen::Index v = 0; v < on.draped.cols(); ++v)
    EXPECT_LT((chart.at(on.panel.rest.col(v)) - on.draped.col(v)).norm(), 1e-12);
}

TEST(CarriedOn, GoesStraightOnAndStaysRound) {
  const OnCylinder on;
  const PanelChart chart(on.panel, on.draped, on.normals);
  std::vector<int> edge;
  for (int c = 0; c < columns; ++c) edge.push_back(c);
  const CarriedOn carried(on.panel, chart, edge, Eigen::Vector2d(0, -0.01).replicate(1, columns), 0.05);
  for (double x = 0.03; x < 0.17; x += 0.0013) {
    const Eigen::Vector2d beyond(x, -0.08);
    EXPECT_LT((carried.at(beyond) - OnCylinder::hangs(beyond)).norm(), 0.15e-3);
  }
}

}  // namespace
}  // namespace toile
