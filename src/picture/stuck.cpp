#include "picture/stuck.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#include "picture/page.h"

namespace toile {
namespace {

using Eigen::Vector3d;

constexpr Colour cloth{.42, .62, .80}, red{.85, .12, .10};
constexpr double far_apart = 0.5;       // m
constexpr double open_stitch = 2e-3;    // m
constexpr double close_up = 0.12;       // m, from its middle to its sides
constexpr double neighbourhood = 0.05;  // m

// The vertices of the loose panels that are one garment vertex.
std::vector<std::vector<int>> copies(const GarmentMesh& garment) {
  std::vector<std::vector<int>> groups(static_cast<std::size_t>(garment.vertex_count));
  int next = 0;
  for (const Eigen::VectorXi& welded : garment.welded)
    for (const int v : welded) groups[static_cast<std::size_t>(v)].push_back(next++);
  return groups;
}

struct Place {
  Vector3d at = Vector3d::Zero();
  double gap = 0;  // m, of the copies there
};

std::vector<Place> places(const std::vector<std::vector<int>>& copies, const Eigen::Matrix3Xd& positions,
                          const std::vector<int>& where) {
  std::vector<Place> found;
  for (const int v : where) {
    Place place;
    const auto& group = copies[static_cast<std::size_t>(v)];
    for (const int copy : group) {
      place.at += positions.col(copy) / static_cast<double>(group.size());
      for (const int other : group) place.gap = std::max(place.gap, (positions.col(copy) - positions.col(other)).norm());
    }
    found.push_back(place);
  }
  return found;
}

// Whether a closer look shows more: an open stitch, or all of it near together.
bool is_local(const std::vector<Place>& all) {
  Eigen::AlignedBox3d box;
  for (const Place& place : all) {
    if (place.gap > open_stitch) return true;
    box.extend(place.at);
  }
  return !all.empty() && box.diagonal().norm() < far_apart;
}

// The widest open stitch; where all are closed, the place with the most others near to it.
Place worst(const std::vector<Place>& all) {
  const auto widest = std::max_element(all.begin(), all.end(), [](const Place& a, const Place& b) { return a.gap < b.gap; });
  if (widest->gap > open_stitch) return *widest;
  Place most;
  std::ptrdiff_t most_near = 0;
  for (const Place& place : all) {
    const auto near =
        std::count_if(all.begin(), all.end(), [&](const Place& other) { return (other.at - place.at).norm() < neighbourhood; });
    if (near > most_near) most = place, most_near = near;
  }
  return most;
}

}  // namespace

LooseGarment loose_garment(const GarmentMesh& garment, const std::vector<Eigen::Matrix3Xd>& panels) {
  if (panels.size() != garment.panels.size()) throw std::invalid_argument("loose_garment: one set of positions by panel");
  LooseGarment loose{garment, {}};
  const std::vector<int> triangles = triangle_offsets(garment);
  int first = 0;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const auto count = static_cast<int>(panels[p].cols());
    if (count != garment.panels[p].rest.cols())
      throw std::invalid_argument("loose_garment: positions of another panel than '" + garment.panels[p].name + "'");
    loose.mesh.welded[p] = Eigen::VectorXi::LinSpaced(count, first, first + count - 1);
    loose.mesh.triangles.middleCols(triangles[p], garment.panels[p].triangles.cols()) =
        garment.panels[p].triangles.array() + first;
    loose.positions.conservativeResize(3, first + count);
    loose.positions.rightCols(count) = panels[p];
    first += count;
  }
  loose.mesh.vertex_count = first;
  return loose;
}

Image stuck_picture(const Mannequin& body, const GarmentMesh& garment, const std::vector<Eigen::Matrix3Xd>& panels,
                    const std::vector<int>& where, const std::string& title, int samples) {
  const LooseGarment loose = loose_garment(garment, panels);
  const Eigen::Matrix3Xd& positions = loose.positions;
  const auto groups = copies(garment);
  std::vector<Colour> colours(static_cast<std::size_t>(positions.cols()), cloth);
  ViewRow whole{{0, 1, 2}, page_width / 3, {}};
  for (const int v : where) {
    const auto& group = groups.at(static_cast<std::size_t>(v));
    for (const int copy : group) {
      colours[static_cast<std::size_t>(copy)] = red;
      if ((positions.col(copy) - positions.col(group.front())).norm() > open_stitch)
        whole.marks.push_back({{positions.col(group.front()), positions.col(copy)}, red, 2});
    }
  }
  Eigen::Matrix3Xd everything(3, body.positions.cols() + positions.cols());
  everything << body.positions, positions;
  std::vector<Image> rows{title_strip(title, page_width),
                          view_row({body, loose.mesh, everything, samples}, positions, colours, whole)};
  if (const std::vector<Place> stuck = places(groups, positions, where); is_local(stuck)) {
    const Place at = worst(stuck);
    const double half = close_up + at.gap / 2;
    Eigen::Matrix3Xd frame(3, 2);
    frame << at.at - Vector3d::Constant(half), at.at + Vector3d::Constant(half);
    rows.push_back(title_strip("close to the worst place", page_width));
    rows.push_back(view_row({body, loose.mesh, frame, samples}, positions, colours, whole));
  }
  return stacked(rows);
}

}  // namespace toile
