#include "body/parametric_polygonise.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <functional>

namespace toile {
using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
using Kernel = Triangulation::Geom_traits;
using Function = std::function<double(const Kernel::Point_3&)>;

Surface polygonise(const BodyForm& form, const Figure& figure, double edge_length) {
  Triangulation triangulation;
  Complex complex(triangulation);
  const Kernel::Point_3 centre(0, .62 * figure.height, .03);
  const double reach = .75 * figure.height;
  const Function function = [&](const Kernel::Point_3& p) { return form.distance({p.x(), p.y(), p.z()}); };
  CGAL::get_default_random() = CGAL::Random(7);
  CGAL::Implicit_surface_3<Kernel, Function> surface(function, Kernel::Sphere_3(centre, reach * reach), 1e-5);
  CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(28, edge_length, edge_length * .1);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag(), 200);
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
  if (!CGAL::Polygon_mesh_processing::is_outward_oriented(mesh)) CGAL::Polygon_mesh_processing::reverse_face_orientations(mesh);
  Surface result{Eigen::Matrix3Xd(3, mesh.number_of_vertices()), Eigen::Matrix3Xi(3, mesh.number_of_faces())};
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.positions.col(static_cast<int>(v.idx())) << p.x(), p.y(), p.z();
  }
  for (const auto f : mesh.faces()) {
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      result.triangles(k++, static_cast<int>(f.idx())) = static_cast<int>(v.idx());
  }
  return result;
}

}  // namespace toile
