#include "drape/fem/bend_friction.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "geometry/topology.h"

namespace toile::fem {
namespace {

// Curvature within which yarns give before they slide, 1/m. Kawabata's loops close over some 0.1-0.2 per cm.
constexpr double slack_curvature = 10;

// Rolled up, a net of equilateral triangles also has hinges that bend against the others: the hinge whose normal is at phi from
// the direction of bending turns by (1 + 2 cos 2 phi) / 3 of the whole. Their absolute sum, on average over all directions.
constexpr double counted_twice = 1 / 3.0 + 2 * 1.7320508075688772 / std::numbers::pi;

// The edge and the two corners off it, seen from the edge's first vertex.
struct Corner {
  Eigen::Vector3d edge, a, b;          // m
  Eigen::Vector3d normal_a, normal_b;  // m^2, twice the areas
};

Corner corner_of(const Hinge& hinge, const Eigen::Matrix3Xd& x) {
  Corner c;
  const Eigen::Vector3d origin = x.col(hinge.vertex[0]);
  c.edge = x.col(hinge.vertex[1]) - origin;
  c.a = x.col(hinge.vertex[2]) - origin;
  c.b = x.col(hinge.vertex[3]) - origin;
  c.normal_a = c.edge.cross(c.a);
  c.normal_b = c.b.cross(c.edge);
  return c;
}

double angle(const Corner& c) {
  return std::atan2(c.normal_a.cross(c.normal_b).dot(c.edge.normalized()), c.normal_a.dot(c.normal_b));
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// Derivatives of the angle by (edge, a, b).
struct AngleDerivatives {
  Vector9 gradient;
  Matrix9 hessian;
};

AngleDerivatives angle_derivatives(const Corner& c, bool with_hessian) {
  AngleDerivatives d;
  const double length = c.edge.norm();
  const double square = length * length;
  const Eigen::Vector3d along = c.edge / length;
  const Eigen::Vector3d m_a = c.normal_a / c.normal_a.squaredNorm();
  const Eigen::Vector3d m_b = c.normal_b / c.normal_b.squaredNorm();
  const double s_a = c.a.dot(c.edge) / square, s_b = c.b.dot(c.edge) / square;
  const Eigen::Vector3d g_a = -length * m_a, g_b = -length * m_b;
  d.gradient << -s_a * g_a - s_b * g_b, g_a, g_b;
  if (!with_hessian) return d;
  // d(n / |n|^2) = (1 - 2 n n^T / |n|^2) / |n|^2 dn
  const auto turned = [](const Eigen::Vector3d& n) -> Eigen::Matrix3d {
    return (Eigen::Matrix3d::Identity() - 2 * n * n.transpose() / n.squaredNorm()) / n.squaredNorm();
  };
  const Eigen::Matrix3d by_a = turned(c.normal_a), by_b = turned(c.normal_b), edge = cross_matrix(c.edge);
  const Eigen::Matrix3d ae = -(m_a * along.transpose() - length * by_a * cross_matrix(c.a));
  const Eigen::Matrix3d be = -(m_b * along.transpose() + length * by_b * cross_matrix(c.b));
  const Eigen::Vector3d ds_a = c.a / square - 2 * s_a * c.edge / square, ds_b = c.b / square - 2 * s_b * c.edge / square;
  d.hessian.setZero();
  d.hessian.block<3, 3>(0, 0) = -g_a * ds_a.transpose() - s_a * ae - g_b * ds_b.transpose() - s_b * be;
  d.hessian.block<3, 3>(3, 3) = -length * by_a * edge;
  d.hessian.block<3, 3>(6, 6) = length * by_b * edge;
  d.hessian.block<3, 3>(3, 0) = ae;
  d.hessian.block<3, 3>(0, 3) = ae.transpose();
  d.hessian.block<3, 3>(6, 0) = be;
  d.hessian.block<3, 3>(0, 6) = be.transpose();
  return d;
}

// Derivatives by (edge, a, b) to those by the four vertices: the edge's first vertex moves all three the other way.
Vector12 to_vertices(const Vector9& g) {
  Vector12 all;
  all << -g.segment<3>(0) - g.segment<3>(3) - g.segment<3>(6), g;
  return all;
}

Matrix12 to_vertices(const Matrix9& h) {
  Matrix12 all;
  const Eigen::Matrix<double, 3, 9> row = -h.topRows<3>() - h.middleRows<3>(3) - h.bottomRows<3>();
  all.block<9, 9>(3, 3) = h;
  all.block<3, 9>(0, 3) = row;
  all.block<9, 3>(3, 0) = row.transpose();
  all.block<3, 3>(0, 0) = -row.leftCols<3>() - row.middleCols<3>(3) - row.rightCols<3>();
  return all;
}

double change(double angle, double anchor) { return std::remainder(angle - anchor, 2 * std::numbers::pi); }

}  // namespace

std::vector<BendFriction> bend_frictions(const GarmentMesh& garment, const Fabric& fabric, const std::vector<Hinge>& hinges) {
  std::vector<BendFriction> frictions(hinges.size());
  if (fabric.bend_friction <= 0) return frictions;
  const auto shapes = rest_triangles(garment);
  const Eigen::VectorXd layers = triangle_layers(garment);
  std::size_t h = 0;
  for (const MeshEdge& edge : mesh_edges(garment.triangles)) {
    if (edge.triangle[1] < 0) continue;
    double area = 0, length = 0, cloths = 0;
    for (const int t : edge.triangle) {
      const Eigen::Matrix2d& shape = shapes[static_cast<std::size_t>(t)];
      Eigen::Matrix<double, 2, 3> corner;
      corner << Eigen::Vector2d::Zero(), shape;
      Eigen::Vector2d along = Eigen::Vector2d::Zero();
      for (int i = 0; i < 3; ++i) {
        if (garment.triangles(i, t) == edge.vertex[0]) along -= corner.col(i);
        if (garment.triangles(i, t) == edge.vertex[1]) along += corner.col(i);
      }
      length += along.norm() / 2;
      area += std::abs(shape.determinant()) / 2;
      cloths += layers(t) / 2;
    }
    frictions[h++] = {fabric.bend_friction * cloths * length / counted_twice, slack_curvature * area / (3 * length)};
  }
  return frictions;
}

double hinge_angle(const Hinge& hinge, const Eigen::Matrix3Xd& x) { return angle(corner_of(hinge, x)); }

double bend_friction_energy(const BendFriction& friction, double anchor, const Hinge& hinge, const Eigen::Matrix3Xd& x) {
  if (friction.moment <= 0) return 0;
  return friction.moment * (std::hypot(change(hinge_angle(hinge, x), anchor), friction.slack) - friction.slack);
}

void bend_friction_derivatives(const BendFriction& friction, double anchor, const Hinge& hinge, const Eigen::Matrix3Xd& x,
                               Curvature curvature, Vector12& gradient, Matrix12* hessian) {
  if (friction.moment <= 0) return;
  const Corner c = corner_of(hinge, x);
  const double least = 1e-6 * c.edge.squaredNorm();
  if (!(c.normal_a.norm() > least && c.normal_b.norm() > least)) return;
  const bool full = hessian && curvature == Curvature::full;
  const AngleDerivatives d = angle_derivatives(c, full);
  const double turned = change(angle(c), anchor);
  const double root = std::hypot(turned, friction.slack);
  const Vector12 slope = to_vertices(d.gradient);
  gradient += friction.moment * turned / root * slope;
  if (!hessian) return;
  *hessian += friction.moment * friction.slack * friction.slack / (root * root * root) * slope * slope.transpose();
  if (full) *hessian += friction.moment * turned / root * to_vertices(d.hessian);
}

}  // namespace toile::fem
