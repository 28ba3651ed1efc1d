#include "triangulate/constrained_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <stdexcept>

namespace toile {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Face = CGAL::Triangulation_face_base_with_info_2<bool, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                                            CGAL::No_constraint_intersection_tag>;

// Marks every face that can be reached from outside without crossing a side of the polygon.
void mark_outside(Delaunay& mesh) {
  for (const auto face : mesh.all_face_handles()) face->info() = false;
  std::vector<Delaunay::Face_handle> open{mesh.infinite_face()};
  mesh.infinite_face()->info() = true;
  while (!open.empty()) {
    const Delaunay::Face_handle face = open.back();
    open.pop_back();
    for (int side = 0; side < 3; ++side) {
      const Delaunay::Face_handle next = face->neighbor(side);
      if (next->info() || mesh.is_constrained({face, side})) continue;
      next->info() = true;
      open.push_back(next);
    }
  }
}

}  // namespace

std::vector<std::array<int, 3>> constrained_delaunay(const std::vector<Eigen::Vector2d>& points, int corners) {
  Delaunay mesh;
  std::vector<Delaunay::Vertex_handle> handles;
  Delaunay::Face_handle near;  // points come in neighbourly order
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Delaunay::Vertex_handle vertex = mesh.insert({points[i].x(), points[i].y()}, near);
    if (mesh.number_of_vertices() != i + 1) throw std::invalid_argument("constrained_delaunay: two points are the same");
    vertex->info() = static_cast<int>(i);
    near = vertex->face();
    handles.push_back(vertex);
  }
  try {
    for (int i = 0; i < corners; ++i)
      mesh.insert_constraint(handles[static_cast<std::size_t>(i)], handles[static_cast<std::size_t>((i + 1) % corners)]);
  } catch (const Delaunay::Intersection_of_constraints_exception&) {
    throw std::invalid_argument("constrained_delaunay: the polygon crosses itself");
  }
  mark_outside(mesh);

  std::vector<std::array<int, 3>> triangles;
  for (const auto face : mesh.finite_face_handles()) {
    if (face->info()) continue;
    std::array<int, 3> t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace toile
