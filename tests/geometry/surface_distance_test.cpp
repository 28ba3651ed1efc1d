#include "geometry/surface_distance.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace toile {
namespace {

struct Mesh {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi triangles;
  Surface surface() const { return {positions, triangles}; }
};

// An (x, y) grid of `n` by `n` squares over [0, width] x [0, length], lifted by height(x, y).
template <class Height>
Mesh sheet(int n, double width, double length, const Height& height) {
  Mesh mesh;
  mesh.positions.resize(3, (n + 1) * (n + 1));
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = width * i / n, y = length * j / n;
      mesh.positions.col(j * (n + 1) + i) << x, y, height(x, y);
    }
  mesh.triangles.resize(3, 2 * n * n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
      mesh.triangles.col(2 * (j * n + i)) << a, b, c;
      mesh.triangles.col(2 * (j * n + i) + 1) << a, c, d;
    }
  return mesh;
}

// Sphere about the origin from a sheet wrapped round it; open at hair-thin polar caps.
Mesh sphere(int n, double radius) {
  Mesh mesh = sheet(n, 2 * std::numbers::pi, std::numbers::pi, [](double, double) { return 0.0; });
  for (Eigen::Index v = 0; v < mesh.positions.cols(); ++v) {
    const double around = mesh.positions(0, v), down = mesh.positions(1, v);
    mesh.positions.col(v) << radius * std::sin(down) * std::cos(around), radius * std::sin(down) * std::sin(around),
        radius * std::cos(down);
  }
  return mesh;
}

TEST(SurfaceDistance, OfParallelPlanesIsTheirOffset) {
  const Mesh low = sheet(7, .3, .2, [](double, double) { return 0.0; });
  const Mesh high = sheet(5, .3, .2, [](double, double) { return .013; });
  const SurfaceDistance d = surface_distance(low.surface(), high.surface());
  EXPECT_NEAR(d.hausdorff, .013, 1e-15);
  EXPECT_NEAR(d.mean, .013, 1e-15);
  ASSERT_EQ(d.a_vertices.size(), low.positions.cols());
  EXPECT_NEAR(d.a_vertices.minCoeff(), .013, 1e-15);
  EXPECT_NEAR(d.a_vertices.maxCoeff(), .013, 1e-15);
}

TEST(SurfaceDistance, OfASurfaceToItselfIsZero) {
  const Mesh ball = sphere(20, .08);
  const SurfaceDistance d = surface_distance(ball.surface(), ball.surface());
  EXPECT_LT(d.hausdorff, 1e-15);
  EXPECT_LT(d.mean, 1e-16);
}

// Vertices of the outer sphere are nearest to the inner facets; both maxima lie within the facets' height.
TEST(SurfaceDistance, OfConcentricSpheresIsTheDifferenceOfRadii) {
  const double facet = .2 * (1 - std::cos(std::numbers::pi / 32)) * 2;
  const SurfaceDistance d = surface_distance(sphere(32, .2).surface(), sphere(32, .21).surface(), 2e-2);
  EXPECT_NEAR(d.hausdorff, .01, facet);
  EXPECT_NEAR(d.mean, .01, facet);
}

TEST(SurfaceDistance, TellsItsTwoSidesApart) {
  const Mesh half = sheet(4, .1, .1, [](double, double) { return 0.0; });
  const Mesh whole = sheet(8, .3, .1, [](double, double) { return 0.0; });
  const SurfaceDistance d = surface_distance(half.surface(), whole.surface());
  EXPECT_NEAR(d.a_to_b_max, 0, 1e-15);
  EXPECT_NEAR(d.b_to_a_max, .2, 1e-15);
  EXPECT_NEAR(d.hausdorff, .2, 1e-15);
  EXPECT_NEAR(d.mean, .2 * .2 / .3 / 2, 1e-4);  // grows linearly over the two thirds that stick out
  const SurfaceDistance back = surface_distance(whole.surface(), half.surface());
  EXPECT_EQ(back.a_to_b_max, d.b_to_a_max);
  EXPECT_EQ(back.mean, d.mean);
}

TEST(SurfaceDistance, MeanOfATiltedSheetIsHalfItsRise) {
  const Mesh flat = sheet(1, .4, .4, [](double, double) { return 0.0; });
  const Mesh tilted = sheet(3, .4, .4, [](double x, double) { return .02 * x / .4; });
  EXPECT_NEAR(surface_distance(tilted.surface(), flat.surface()).mean, .01, 2e-5);
}

TEST(SurfaceDistance, SeesWhatLiesBetweenVertices) {
  const Mesh flat = sheet(1, .2, .2, [](double, double) { return 0.0; });
  Mesh dented = sheet(40, .2, .2, [](double, double) { return 0.0; });
  dented.positions(2, 20 * 41 + 20) = -.03;
  EXPECT_GT(surface_distance(flat.surface(), dented.surface(), 2e-3).a_to_b_max, 1e-4);
}

TEST(SurfaceDistance, LiesWithinTheBoundsOfCgal) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto cgal = [](const Mesh& mesh) {
    CGAL::Surface_mesh<Kernel::Point_3> result;
    for (Eigen::Index v = 0; v < mesh.positions.cols(); ++v)
      result.add_vertex({mesh.positions(0, v), mesh.positions(1, v), mesh.positions(2, v)});
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      using Vertex = CGAL::Surface_mesh<Kernel::Point_3>::Vertex_index;
      const auto vertex = [&](int corner) { return Vertex(static_cast<unsigned>(mesh.triangles(corner, t))); };
      result.add_face(vertex(0), vertex(1), vertex(2));
    }
    return result;
  };
  const Mesh a = sheet(12, .3, .2, [](double x, double y) { return .03 * std::sin(20 * x) * std::cos(14 * y); });
  const Mesh b = sheet(15, .3, .2, [](double x, double y) { return .03 * std::sin(20 * x + .3) * std::cos(15 * y) + .004; });
  const double bound = 5e-4, spacing = 3e-3;
  const SurfaceDistance d = surface_distance(a.surface(), b.surface(), spacing);
  const auto mesh_a = cgal(a), mesh_b = cgal(b);
  namespace pmp = CGAL::Polygon_mesh_processing;
  const double a_to_b = pmp::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(mesh_a, mesh_b, bound);
  const double b_to_a = pmp::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(mesh_b, mesh_a, bound);
  EXPECT_NEAR(d.a_to_b_max, a_to_b, bound + spacing / std::sqrt(3));
  EXPECT_NEAR(d.b_to_a_max, b_to_a, bound + spacing / std::sqrt(3));
  EXPECT_LE(d.a_to_b_max, a_to_b + bound);
  EXPECT_LE(d.b_to_a_max, b_to_a + bound);
}

TEST(SurfaceDistance, MovesRigidlyWithBothSurfaces) {
  const Mesh a = sheet(12, .4, .4, [](double x, double y) { return .02 * std::sin(15 * x + 3 * y); });
  const Mesh b = sheet(9, .4, .4, [](double x, double y) { return .02 * std::cos(13 * x - y); });
  const Eigen::Isometry3d move =
      Eigen::Translation3d(.3, 1.2, -.1) * Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized());
  const auto moved = [&](Mesh mesh) {
    mesh.positions = move * mesh.positions;
    return mesh;
  };
  const SurfaceDistance before = surface_distance(a.surface(), b.surface());
  const SurfaceDistance after = surface_distance(moved(a).surface(), moved(b).surface());
  EXPECT_NEAR(before.hausdorff, after.hausdorff, 1e-13);
  EXPECT_NEAR(before.mean, after.mean, 1e-13);
}

TEST(SurfaceDistance, GivesTheSameBytesTwice) {
  const Mesh a = sheet(24, .2, .2, [](double x, double y) { return .02 * std::sin(15 * x + 3 * y); });
  const Mesh b = sheet(21, .2, .2, [](double x, double y) { return .02 * std::cos(13 * x - y); });
  const SurfaceDistance first = surface_distance(a.surface(), b.surface());
  const SurfaceDistance second = surface_distance(a.surface(), b.surface());
  EXPECT_EQ(first.hausdorff, second.hausdorff);
  EXPECT_EQ(first.mean, second.mean);
  EXPECT_EQ(first.a_vertices, second.a_vertices);
}

TEST(SurfaceDistance, PassesOverTrianglesWithoutArea) {
  const Mesh flat = sheet(4, .2, .2, [](double, double) { return 0.0; });
  Mesh folded = flat;
  folded.triangles.conservativeResize(3, flat.triangles.cols() + 1);
  folded.triangles.rightCols(1) << 0, 1, 2;
  EXPECT_LT(surface_distance(flat.surface(), folded.surface()).hausdorff, 1e-15);
}

TEST(SurfaceDistance, RefusesWhatIsNoSurface) {
  const Mesh flat = sheet(2, .2, .2, [](double, double) { return 0.0; });
  Mesh broken = flat;
  broken.positions(1, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(surface_distance(flat.surface(), broken.surface()), std::invalid_argument);
  EXPECT_THROW(surface_distance(flat.surface(), flat.surface(), 0), std::invalid_argument);
  Mesh empty = flat;
  empty.triangles.resize(3, 0);
  EXPECT_THROW(surface_distance(empty.surface(), flat.surface()), std::invalid_argument);
}

}  // namespace
}  // namespace toile
