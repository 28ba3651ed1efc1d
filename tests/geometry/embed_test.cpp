#include "geometry/embed.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "geometry/triangle_shape.h"

namespace toile {
namespace {

// A panel of columns x rows squares, each cut in two.
struct Sheet {
  FlatMesh mesh;
  Eigen::Matrix2Xd at;
};

Sheet sheet(int columns, int rows, double width, double height) {
  Sheet s;
  s.mesh.vertex_count = (columns + 1) * (rows + 1);
  s.at.resize(2, s.mesh.vertex_count);
  const auto id = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) s.at.col(id(i, j)) << width * i / columns, height * j / rows;
  s.mesh.triangles.resize(3, 2 * columns * rows);
  Eigen::Index t = 0;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      s.mesh.triangles.col(t++) << id(i, j), id(i + 1, j), id(i + 1, j + 1);
      s.mesh.triangles.col(t++) << id(i, j), id(i + 1, j + 1), id(i, j + 1);
    }
  return s;
}

std::vector<Eigen::Matrix2d> shapes_of(const FlatMesh& mesh, const Eigen::Matrix2Xd& at) {
  std::vector<Eigen::Matrix2d> shapes;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    Eigen::Matrix2d edges;
    edges << at.col(mesh.triangles(1, t)) - at.col(mesh.triangles(0, t)),
        at.col(mesh.triangles(2, t)) - at.col(mesh.triangles(0, t));
    shapes.push_back(edges);
  }
  return shapes;
}

std::vector<Eigen::Matrix2d> laid_on_x(std::vector<Eigen::Matrix2d> shapes) {
  for (Eigen::Matrix2d& shape : shapes) shape = triangle_shape(shape);
  return shapes;
}

Eigen::Matrix2Xd mapped(const Eigen::Matrix2Xd& at, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map) {
  Eigen::Matrix2Xd result(2, at.cols());
  for (Eigen::Index i = 0; i < at.cols(); ++i) result.col(i) = map(at.col(i));
  return result;
}

// Largest difference of the two after the best rotation and shift (Procrustes).
double difference(const Eigen::Matrix2Xd& a, const Eigen::Matrix2Xd& b) {
  const Eigen::Matrix2Xd ca = a.colwise() - a.rowwise().mean(), cb = b.colwise() - b.rowwise().mean();
  const Eigen::Matrix2d covariance = cb * ca.transpose();
  const double angle = std::atan2(covariance(1, 0) - covariance(0, 1), covariance(0, 0) + covariance(1, 1));
  return (Eigen::Rotation2Dd(angle).toRotationMatrix() * ca - cb).colwise().norm().maxCoeff();
}

const Sheet panel = sheet(12, 30, .24, .6);

TEST(Embedder, GivesTrianglesThatAgreeBackExactly) {
  // A quarter turn bend: what local/global from the start alone needs hundreds of iterations for.
  const Eigen::Matrix2Xd bent = mapped(panel.at, [](const Eigen::Vector2d& x) {
    const double radius = .5 + 1.1 * x.x(), angle = 2.6 * x.y();
    return Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle));
  });
  const Embedder embedder({panel.mesh}, {}, shapes_of(panel.mesh, panel.at));
  const Embedding result = embedder.embed(laid_on_x(shapes_of(panel.mesh, bent)), {panel.at});
  EXPECT_LT(difference(bent, result.panels[0]), 1e-9);
  EXPECT_LT(result.mean_distortion, 1e-9);
  EXPECT_EQ(result.inverted, 0);
}

TEST(Embedder, LeavesAPanelWhereItIs) {
  const Embedder embedder({panel.mesh}, {}, shapes_of(panel.mesh, panel.at));
  const Embedding result = embedder.embed(laid_on_x(shapes_of(panel.mesh, panel.at)), {panel.at});
  EXPECT_LT((result.panels[0] - panel.at).colwise().norm().maxCoeff(), 1e-10);
}

TEST(Embedder, KeepsTheGrainWhereItWasUnderAStretch) {
  const Eigen::Matrix2Xd stretched = mapped(panel.at, [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return {1.1 * x.x() + .02 * x.y(), .02 * x.x() + .9 * x.y()};
  });
  const Embedder embedder({panel.mesh}, {}, shapes_of(panel.mesh, panel.at));
  const Embedding result = embedder.embed(laid_on_x(shapes_of(panel.mesh, stretched)), {panel.at});
  const Eigen::Vector2d shift = (panel.at - stretched).rowwise().mean();
  // The map is symmetric, so it turns nothing.
  const Eigen::Matrix2Xd wanted = stretched.colwise() + shift;
  EXPECT_LT((result.panels[0] - wanted).colwise().norm().maxCoeff(), 1e-9);
}

TEST(Embedder, FindsAMinimumWhenTrianglesDisagree) {
  auto shapes = shapes_of(panel.mesh, panel.at);
  for (std::size_t t = 0; t < shapes.size(); ++t) shapes[t] *= 1 + .05 * std::sin(1.7 * static_cast<double>(t));
  const auto reference = shapes_of(panel.mesh, panel.at);
  const auto run = [&](int iterations) {
    return Embedder({panel.mesh}, {}, reference, {.most_iterations = iterations, .tolerance = 1e-12}).embed(shapes, {panel.at});
  };
  const Embedding result = run(200), longer = run(2000);
  EXPECT_LT((result.panels[0] - longer.panels[0]).colwise().norm().maxCoeff(), 1e-8);
  EXPECT_GT(result.mean_distortion, .01);
}

std::vector<MatingEdges> side_by_side(int rows, int columns, double ratio) {
  std::vector<MatingEdges> mating;
  for (int j = 0; j < rows; ++j) {
    const int low = j * (columns + 1), high = low + columns + 1;
    mating.push_back({0, low + columns, high + columns, 1, low, high, ratio});
  }
  return mating;
}

double side_length(const Eigen::Matrix2Xd& at, int rows, int columns, int column) {
  double sum = 0;
  for (int j = 0; j < rows; ++j) sum += (at.col((j + 1) * (columns + 1) + column) - at.col(j * (columns + 1) + column)).norm();
  return sum;
}

TEST(Embedder, DrawsMatingEdgesToTheirRatioAndNotToEqualLengths) {
  const int columns = 12, rows = 30;
  const Sheet eased = sheet(columns, rows, .24, .63);
  const double ratio = .6 / .63;
  auto shapes = shapes_of(panel.mesh, panel.at);
  const auto other = shapes_of(eased.mesh, eased.at);
  shapes.insert(shapes.end(), other.begin(), other.end());
  const Embedder embedder({panel.mesh, eased.mesh}, side_by_side(rows, columns, ratio), shapes);

  const Embedding kept = embedder.embed(shapes, {panel.at, eased.at});
  EXPECT_LT(difference(kept.panels[1], eased.at), 1e-9);

  // One panel 4 mm too long: without the seam term the seam is off by 4 mm.
  auto longer = shapes;
  for (std::size_t t = 0; t < other.size(); ++t) longer[t].row(1) *= 1 + 4e-3 / .6;
  const Embedding trued = embedder.embed(longer, {panel.at, eased.at});
  const double a = side_length(trued.panels[0], rows, columns, columns), b = side_length(trued.panels[1], rows, columns, 0);
  EXPECT_LT(std::abs(a - ratio * b), .5e-3);
}

TEST(Embedder, HoldsSeamsAsWellWhenTheMeshIsFiner) {
  for (const int fine : {1, 2, 4}) {
    const Sheet s = sheet(10 * fine, 20 * fine, .24, .5);
    auto shapes = shapes_of(s.mesh, s.at);
    const std::size_t count = shapes.size();
    shapes.insert(shapes.end(), shapes.begin(), shapes.begin() + static_cast<std::ptrdiff_t>(count));
    const Embedder embedder({s.mesh, s.mesh}, side_by_side(20 * fine, 10 * fine, 1), shapes);
    for (std::size_t t = 0; t < count; ++t) shapes[t].row(1) *= 1.008;
    const Embedding result = embedder.embed(shapes, {s.at, s.at});
    const double mismatch = std::abs(side_length(result.panels[0], 20 * fine, 10 * fine, 10 * fine) -
                                     side_length(result.panels[1], 20 * fine, 10 * fine, 0));
    EXPECT_LT(mismatch, .5e-3) << "at " << count << " triangles a panel";
  }
}

TEST(Embedder, TakesPanelsInAnyPlaceAndTurn) {
  const Eigen::Matrix2Xd turned = mapped(panel.at, [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return Eigen::Rotation2Dd(2.5) * x + Eigen::Vector2d(3, -1);
  });
  const Embedder embedder({panel.mesh}, {}, shapes_of(panel.mesh, panel.at));
  const Embedding result = embedder.embed(laid_on_x(shapes_of(panel.mesh, panel.at)), {turned});
  EXPECT_LT((result.panels[0] - turned).colwise().norm().maxCoeff(), 1e-9);
}

TEST(Embedder, RefusesWhatIsNotAMesh) {
  auto shapes = shapes_of(panel.mesh, panel.at);
  EXPECT_THROW(Embedder({panel.mesh}, {{0, 0, 500, 0, 0, 1, 1.0}}, shapes), std::invalid_argument);
  shapes[3].col(1) = shapes[3].col(0);
  EXPECT_THROW(Embedder({panel.mesh}, {}, shapes), std::invalid_argument);
}

}  // namespace
}  // namespace toile
