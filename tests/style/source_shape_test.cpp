#include "style/source_shape.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>

#include "style/synthetic_skirt.h"

namespace toile {
namespace {

using testing::SkirtShape;
using testing::synthetic_skirt;
using testing::SyntheticSkirt;

SyntheticSkirt small_skirt() { return synthetic_skirt({.columns = 24, .rows = 12, .gores = 4}); }

Eigen::Matrix3Xd shaken(const Eigen::Matrix3Xd& x, double by) {
  Eigen::Matrix3Xd out = x;
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    out.col(v) += by * Eigen::Vector3d(std::sin(3.1 * double(v)), std::cos(1.7 * double(v)), std::sin(0.9 * double(v) + 1));
  return out;
}

std::vector<Eigen::Matrix2d> plane_maps(const std::vector<SourceTriangle>& triangles, const Eigen::Matrix3Xd& x) {
  std::vector<Eigen::Matrix2d> maps;
  for (const SourceTriangle& triangle : triangles) maps.push_back(plane_map_of(triangle, x));
  return maps;
}

// The original statement: P = [p4-p1, p4-p2, p4-p3] with p4 = p1 + n; T' = P' P^-1, P' being the current triangle projected
// onto the source plane with the same n; minimised over the position of the current fourth vertex.
double four_vertex_energy(const SourceTriangle& triangle, const Eigen::Matrix3Xd& source, const Eigen::Matrix3Xd& last,
                          const Eigen::Matrix3Xd& x) {
  const Eigen::Vector3d normal = triangle.plane.col(0).cross(triangle.plane.col(1));
  const auto frame = [&](const Eigen::Matrix3d& corners, const Eigen::Vector3d& fourth) {
    return Eigen::Matrix3d((-corners).colwise() + fourth);
  };
  Eigen::Matrix3d p, projected, now;
  for (int i = 0; i < 3; ++i) {
    p.col(i) = source.col(triangle.corners(i));
    const Eigen::Vector3d q = last.col(triangle.corners(i));
    projected.col(i) = q - normal * normal.dot(q - source.col(triangle.corners(0)));
    now.col(i) = x.col(triangle.corners(i));
  }
  const Eigen::Matrix3d inverse = frame(p, p.col(0) + normal).inverse();
  const Eigen::Matrix3d frozen = frame(projected, projected.col(0) + normal) * inverse;
  // F(x4) = (x4 1^T - X) P^-1 - T' is linear in x4: least squares in closed form.
  const Eigen::RowVector3d ones = Eigen::RowVector3d::Ones() * inverse;
  const Eigen::Matrix3d rest = now * inverse + frozen;
  const Eigen::Vector3d fourth = rest * ones.transpose() / ones.squaredNorm();
  return triangle.area * (fourth * ones - rest).squaredNorm();
}

TEST(ShapeEnergy, EqualsTheFourVertexFormMinimisedOverTheFourthVertex) {
  const SyntheticSkirt skirt = small_skirt();
  const auto triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  const Eigen::Matrix3Xd last = shaken(skirt.drape, 0.01), x = shaken(skirt.drape, -0.02);
  const auto maps = plane_maps(triangles, last);
  double four = 0;
  for (const SourceTriangle& triangle : triangles) four += four_vertex_energy(triangle, skirt.drape, last, x);
  const double reduced = shape_energy(triangles, maps, x);
  ASSERT_GT(reduced, 1e-4);
  EXPECT_NEAR(reduced / four, 1, 1e-9);
}

TEST(ShapeEnergy, HasTheGradientOfFiniteDifferences) {
  const SyntheticSkirt skirt = small_skirt();
  const auto triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  const auto maps = plane_maps(triangles, shaken(skirt.drape, 0.01));
  const Eigen::Matrix3Xd x = shaken(skirt.drape, -0.02);
  const Eigen::Matrix3Xd gradient = shape_gradient(triangles, maps, x);
  for (const Eigen::Index v : {0, 30, 100, 250}) {
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::Matrix3Xd more = x, less = x;
      more(axis, v) += 1e-4;
      less(axis, v) -= 1e-4;
      const double difference = (shape_energy(triangles, maps, more) - shape_energy(triangles, maps, less)) / 2e-4;
      EXPECT_NEAR(difference, gradient(axis, v), 1e-9 * gradient.cwiseAbs().maxCoeff());
    }
  }
}

TEST(ShapeEnergy, IsTiltAloneOnceTheMapsFollow) {
  const SyntheticSkirt skirt = small_skirt();
  const auto triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  const Eigen::Matrix3Xd x = shaken(skirt.drape, 0.01);
  EXPECT_NEAR(shape_energy(triangles, plane_maps(triangles, x), x) / tilt_energy(triangles, x), 1, 1e-12);
}

TEST(ShapeEnergy, IsZeroForStretchInThePlaneOfAFlatSheet) {
  Eigen::Matrix3Xd flat(3, 4);
  flat << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  Eigen::Matrix3Xi two(3, 2);
  two << 0, 0, 1, 2, 2, 3;
  const auto triangles = source_triangles(flat, two);
  Eigen::Matrix3Xd sheared = flat;
  sheared.row(0) = 1.4 * flat.row(0) + 0.3 * flat.row(1);
  EXPECT_NEAR(tilt_energy(triangles, sheared), 0, 1e-15);
  sheared.row(2) = 0.5 * flat.row(0);  // a tilt of slope one half over an area of 1 m^2
  EXPECT_NEAR(tilt_energy(triangles, sheared), 0.25, 1e-12);
}

TEST(ShapeEnergy, DoesNotSeeTranslationOrTheFrameOfTheBody) {
  const SyntheticSkirt skirt = small_skirt();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Eigen::Vector3d shift(0.3, -2, 5);
  const Eigen::Matrix3Xd x = shaken(skirt.drape, 0.01);
  const Eigen::Matrix3Xd turned_source = (turn * skirt.drape).colwise() + shift;
  const Eigen::Matrix3Xd turned_x = (turn * x).colwise() + 2 * shift;
  const double here = tilt_energy(source_triangles(skirt.drape, skirt.garment.triangles), x);
  const double there = tilt_energy(source_triangles(turned_source, skirt.garment.triangles), turned_x);
  EXPECT_NEAR(there / here, 1, 1e-9);
}

TEST(SourceTriangles, LeaveOutWhatHasNoArea) {
  Eigen::Matrix3Xd points(3, 4);
  points << 0, 1, 2, 0, 0, 0, 0, 1, 0, 0, 0, 0;
  Eigen::Matrix3Xi two(3, 2);
  two << 0, 0, 1, 1, 2, 3;
  const auto triangles = source_triangles(points, two);
  ASSERT_EQ(triangles.size(), 1u);
  EXPECT_EQ(triangles[0].corners, Eigen::Vector3i(0, 1, 3));
  EXPECT_NEAR(vertex_areas(triangles, 4).sum(), 0.5, 1e-15);
}

TEST(Clamped, LeavesMapsInRangeAlone) {
  Eigen::Matrix2d map;
  map << 1.2, 0.3, -0.1, 0.8;
  EXPECT_EQ(clamped(map, 0.5, 2), map);
}

TEST(Clamped, MovesSingularValuesIntoRangeAndNeverTurnsOver) {
  Eigen::Matrix2d large, over, none = Eigen::Matrix2d::Zero();
  large << 3, 0.5, 0.2, 0.1;
  over << 1, 0.1, 0.2, -0.9;
  for (const Eigen::Matrix2d& map : {large, over, none}) {
    const Eigen::Vector2d values = signed_singular_values(clamped(map, 0.5, 2));
    EXPECT_LE(values(0), 2 + 1e-12);
    EXPECT_GE(values(1), 0.5 - 1e-12);
  }
  EXPECT_LT(signed_singular_values(over)(1), 0);
}

}  // namespace
}  // namespace toile
