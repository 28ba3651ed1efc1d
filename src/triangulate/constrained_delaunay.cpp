#include "triangulate/constrained_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <stdexcept>

namespace toile {
namespace {

constexpr int outside = -1, not_yet_numbered = -2;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Face = CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                                            CGAL::No_constraint_intersection_tag>;

}  // namespace

struct ConstrainedDelaunay::State {
  Delaunay mesh;
  std::vector<Delaunay::Vertex_handle> vertices;

  void insert(const Eigen::Vector2d& point, Delaunay::Face_handle near) {
    const Delaunay::Vertex_handle vertex = mesh.insert({point.x(), point.y()}, near);
    if (mesh.number_of_vertices() == vertices.size())
      throw std::invalid_argument("ConstrainedDelaunay: two points are the same");
    vertex->info() = static_cast<int>(vertices.size());
    vertices.push_back(vertex);
  }

  // Numbers the faces that cannot be reached from outside without crossing a side of the polygon.
  int number_faces() {
    for (const auto face : mesh.all_face_handles()) face->info() = not_yet_numbered;
    std::vector<Delaunay::Face_handle> open{mesh.infinite_face()};
    mesh.infinite_face()->info() = outside;
    while (!open.empty()) {
      const Delaunay::Face_handle face = open.back();
      open.pop_back();
      for (int side = 0; side < 3; ++side) {
        const Delaunay::Face_handle next = face->neighbor(side);
        if (next->info() == outside || mesh.is_constrained({face, side})) continue;
        next->info() = outside;
        open.push_back(next);
      }
    }
    int count = 0;
    for (const auto face : mesh.finite_face_handles())
      if (face->info() != outside) face->info() = count++;
    return count;
  }
};

ConstrainedDelaunay::ConstrainedDelaunay(const std::vector<Eigen::Vector2d>& loop) : state_(std::make_unique<State>()) {
  Delaunay::Face_handle near;
  for (const Eigen::Vector2d& point : loop) {
    state_->insert(point, near);
    near = state_->vertices.back()->face();
  }
  try {
    for (std::size_t i = 0; i < loop.size(); ++i)
      state_->mesh.insert_constraint(state_->vertices[i], state_->vertices[(i + 1) % loop.size()]);
  } catch (const Delaunay::Intersection_of_constraints_exception&) {
    throw std::invalid_argument("ConstrainedDelaunay: the polygon crosses itself");
  }
}

ConstrainedDelaunay::~ConstrainedDelaunay() = default;

void ConstrainedDelaunay::insert(const Eigen::Vector2d& point, int near) {
  state_->insert(point, state_->vertices[static_cast<std::size_t>(near)]->face());
}

std::vector<DelaunayTriangle> ConstrainedDelaunay::triangles() {
  std::vector<DelaunayTriangle> triangles;
  triangles.reserve(static_cast<std::size_t>(state_->number_faces()));
  for (const auto face : state_->mesh.finite_face_handles()) {
    if (face->info() == outside) continue;
    DelaunayTriangle triangle{};
    for (int corner = 0; corner < 3; ++corner) {
      const bool border = state_->mesh.is_constrained({face, corner});
      triangle.vertex[static_cast<std::size_t>(corner)] = face->vertex(corner)->info();
      triangle.neighbour[static_cast<std::size_t>(corner)] = border ? outside : face->neighbor(corner)->info();
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace toile
