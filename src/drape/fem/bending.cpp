#include "drape/fem/bending.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geometry/topology.h"

namespace toile::fem {
namespace {

// Cotangents of a rest triangle at the two ends of its edge (from, to), the edge's direction, and the area.
struct Side {
  double cot_from = 0, cot_to = 0, area = 0;
  Eigen::Vector2d across;  // unit, in the rest plane, square to the edge
};

Side side_of(const Eigen::Matrix2Xd& rest, const Eigen::Vector3i& corners, int from, int to, int off) {
  const Eigen::Vector2d a = rest.col(corners(from));
  const Eigen::Vector2d b = rest.col(corners(to));
  const Eigen::Vector2d c = rest.col(corners(off));
  const auto cot = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return u.dot(v) / std::abs(u.x() * v.y() - u.y() * v.x());
  };
  const Eigen::Vector2d edge = (b - a).normalized();
  const double twice_area = std::abs((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
  return {cot(b - a, c - a), cot(a - b, c - b), twice_area / 2, {-edge.y(), edge.x()}};
}

}  // namespace

std::vector<Hinge> bending_hinges(const GarmentMesh& garment, const Fabric& fabric) {
  std::vector<int> panel_of;
  std::vector<int> first;
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    for (Eigen::Index t = 0; t < garment.panels[p].triangles.cols(); ++t) {
      panel_of.push_back(static_cast<int>(p));
      first.push_back(static_cast<int>(t));
    }
  const Eigen::VectorXd layers = triangle_layers(garment);
  // Hinges across the bend take part of it, five sixths to one sixth when they lie in all directions.
  const double least = 0.1 * std::min(fabric.bend_warp, fabric.bend_weft);
  const double bend_warp = std::max(least, (5 * fabric.bend_warp - fabric.bend_weft) / 4);
  const double bend_weft = std::max(least, (5 * fabric.bend_weft - fabric.bend_warp) / 4);
  std::vector<Hinge> hinges;
  for (const MeshEdge& edge : mesh_edges(garment.triangles)) {
    if (edge.triangle[1] < 0) continue;
    Hinge hinge;
    hinge.vertex[0] = edge.vertex[0];
    hinge.vertex[1] = edge.vertex[1];
    double area = 0;
    double stiffness = 0;
    for (std::size_t s = 0; s < 2; ++s) {
      const int t = edge.triangle[s];
      const PanelMesh& panel = garment.panels[static_cast<std::size_t>(panel_of[static_cast<std::size_t>(t)])];
      int from = 0;
      int to = 0;
      int off = 0;
      for (int corner = 0; corner < 3; ++corner) {
        const int vertex = garment.triangles(corner, t);
        if (vertex == edge.vertex[0])
          from = corner;
        else if (vertex == edge.vertex[1])
          to = corner;
        else
          off = corner;
      }
      const Eigen::Vector3i corners = panel.triangles.col(first[static_cast<std::size_t>(t)]);
      const Side side = side_of(panel.rest, corners, from, to, off);
      hinge.vertex[2 + s] = garment.triangles(off, t);
      hinge.weight[0] += side.cot_to;
      hinge.weight[1] += side.cot_from;
      hinge.weight[2 + s] = -side.cot_from - side.cot_to;
      area += side.area;
      const double along_warp = side.across.dot(panel.warp);
      stiffness +=
          std::pow(layers(t), 3) * (bend_warp * along_warp * along_warp + bend_weft * (1 - along_warp * along_warp)) / 2;
    }
    hinge.stiffness = stiffness / area;  // exact for cylinders on equilateral triangles
    hinges.push_back(hinge);
  }
  return hinges;
}

Eigen::Vector3d hinge_vector(const Hinge& hinge, const Eigen::Matrix3Xd& x) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 4; ++i) sum += hinge.weight[i] * x.col(hinge.vertex[i]);
  return sum;
}

}  // namespace toile::fem
