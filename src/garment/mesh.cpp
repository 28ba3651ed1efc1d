#include "garment/mesh.h"

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>

namespace toile {
namespace {

// Eigen compares only what is of one size.
template <class Matrix>
bool same(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

}  // namespace

bool PanelMesh::operator==(const PanelMesh& other) const {
  return piece == other.piece && copy == other.copy && mirrored == other.mirrored && name == other.name &&
         same(rest, other.rest) && same(triangles, other.triangles) && boundary == other.boundary && warp == other.warp &&
         same(layers, other.layers);
}

bool GarmentMesh::operator==(const GarmentMesh& other) const {
  return panels == other.panels && vertex_count == other.vertex_count && same(triangles, other.triangles) &&
         std::equal(welded.begin(), welded.end(), other.welded.begin(), other.welded.end(), same<Eigen::VectorXi>);
}

RestShape rest_shape(const GarmentMesh& garment) {
  RestShape rest;
  rest.reserve(garment.panels.size());
  for (const PanelMesh& panel : garment.panels) rest.push_back(panel.rest);
  return rest;
}

GarmentMesh with_rest(GarmentMesh garment, const RestShape& rest) {
  if (rest.size() != garment.panels.size()) throw std::invalid_argument("with_rest: number of panels differs");
  for (std::size_t p = 0; p < rest.size(); ++p) {
    if (rest[p].cols() != garment.panels[p].rest.cols())
      throw std::invalid_argument("with_rest: vertex count of panel '" + garment.panels[p].name + "' differs");
    garment.panels[p].rest = rest[p];
  }
  return garment;
}

int triangle_count(const GarmentMesh& garment) { return static_cast<int>(garment.triangles.cols()); }

std::vector<int> triangle_offsets(const GarmentMesh& garment) {
  std::vector<int> offsets{0};
  for (const PanelMesh& panel : garment.panels) offsets.push_back(offsets.back() + static_cast<int>(panel.triangles.cols()));
  return offsets;
}

std::vector<Eigen::Matrix2d> rest_triangles(const GarmentMesh& garment) {
  std::vector<Eigen::Matrix2d> shapes;
  shapes.reserve(static_cast<std::size_t>(triangle_count(garment)));
  for (const PanelMesh& panel : garment.panels)
    for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
      const Eigen::Vector2d a = panel.rest.col(panel.triangles(0, t));
      Eigen::Matrix2d shape;
      shape << panel.rest.col(panel.triangles(1, t)) - a, panel.rest.col(panel.triangles(2, t)) - a;
      shapes.push_back(shape);
    }
  return shapes;
}

Eigen::VectorXd triangle_layers(const GarmentMesh& garment) {
  Eigen::VectorXd layers = Eigen::VectorXd::Ones(garment.triangles.cols());
  const std::vector<int> offsets = triangle_offsets(garment);
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    if (garment.panels[p].layers.size() > 0)
      layers.segment(offsets[p], garment.panels[p].layers.size()) = garment.panels[p].layers;
  return layers;
}

Eigen::VectorXd vertex_areas(const GarmentMesh& garment) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(garment.vertex_count);
  const auto shapes = rest_triangles(garment);
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t)
    for (int corner = 0; corner < 3; ++corner)
      areas(garment.triangles(corner, t)) += shapes[static_cast<std::size_t>(t)].determinant() / 6;
  return areas;
}

void check(const GarmentMesh& garment) {
  if (garment.welded.size() != garment.panels.size()) throw std::invalid_argument("check: one weld list per panel is needed");
  const std::vector<int> offsets = triangle_offsets(garment);
  if (offsets.back() != garment.triangles.cols()) throw std::invalid_argument("check: garment triangles are not the panels'");
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const auto fail = [&](const char* what) { throw std::invalid_argument("check: panel '" + panel.name + "': " + what); };
    if (garment.welded[p].size() != panel.rest.cols()) fail("weld list has the wrong length");
    if (panel.layers.size() != 0 && panel.layers.size() != panel.triangles.cols()) fail("layers are not one a triangle");
    if (!panel.rest.allFinite()) fail("rest positions are not finite");
    if ((garment.welded[p].array() < 0).any() || (garment.welded[p].array() >= garment.vertex_count).any())
      fail("weld list names a vertex that does not exist");
    for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t)
      for (int corner = 0; corner < 3; ++corner)
        if (garment.triangles(corner, offsets[p] + t) != garment.welded[p](panel.triangles(corner, t)))
          fail("garment triangles differ from the panel's");
  }
}

}  // namespace toile
