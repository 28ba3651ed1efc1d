#include "edit/as_rigid_as_possible.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <stdexcept>

namespace toile::testing {

Eigen::Matrix3Xd as_rigid_as_possible(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xi& triangles,
                                      const std::vector<int>& held, const Eigen::Matrix3Xd& to) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (Eigen::Index v = 0; v < x.cols(); ++v) vertices.push_back(mesh.add_vertex({x(0, v), x(1, v), x(2, v)}));
  const auto vertex = [&](int v) { return vertices[static_cast<std::size_t>(v)]; };
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    if (mesh.add_face(vertex(triangles(0, t)), vertex(triangles(1, t)), vertex(triangles(2, t))) == Mesh::null_face())
      throw std::invalid_argument("as_rigid_as_possible: not a manifold");
  CGAL::Surface_mesh_deformation<Mesh> deformation(mesh);
  for (const auto v : vertices) deformation.insert_roi_vertex(v);
  for (const int v : held) deformation.insert_control_vertex(vertex(v));
  if (!deformation.preprocess()) throw std::runtime_error("as_rigid_as_possible: cannot be solved");
  for (std::size_t i = 0; i < held.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    deformation.set_target_position(vertex(held[i]), Kernel::Point_3(to(0, k), to(1, k), to(2, k)));
  }
  deformation.deform(200, 1e-6);
  Eigen::Matrix3Xd result(3, x.cols());
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    for (int i = 0; i < 3; ++i) result(i, v) = mesh.point(vertex(static_cast<int>(v)))[i];
  return result;
}

}  // namespace toile::testing
