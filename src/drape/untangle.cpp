#include "drape/untangle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>
#include <vector>

#include "collide/intersections.h"
#include "drape/sewing.h"

namespace toile {
namespace {

constexpr int most_rings = 8;        // round the crossing triangles
constexpr int sweeps = 120;          // of the vertices of a patch
constexpr double most_share = 0.15;  // of the garment's vertices: more is not a local fault
constexpr int relaxing_steps = 30;

struct Neighbour {
  int vertex;
  double weight;
};

std::vector<std::vector<Neighbour>> neighbours_of(const LoosePanels& cloth) {
  std::vector<std::vector<Neighbour>> all(static_cast<std::size_t>(cloth.positions.cols()));
  for (const Tie& edge : cloth.edges) {
    all[static_cast<std::size_t>(edge.a)].push_back({edge.b, 1 / edge.length});
    all[static_cast<std::size_t>(edge.b)].push_back({edge.a, 1 / edge.length});
  }
  return all;
}

// The garment as one sheet: numbered by garment vertex, nothing left to stitch.
LoosePanels welded_cloth(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions) {
  std::vector<Eigen::Matrix3Xd> placed;
  for (const PanelMesh& panel : garment.panels) placed.emplace_back(3, panel.rest.cols());
  LoosePanels cloth = loose_panels(garment, placed);
  for (auto* ties : {&cloth.edges, &cloth.bends})
    for (Tie& tie : *ties) {
      tie.a = cloth.garment_vertex[static_cast<std::size_t>(tie.a)];
      tie.b = cloth.garment_vertex[static_cast<std::size_t>(tie.b)];
    }
  cloth.positions = positions;
  cloth.triangles = garment.triangles;
  cloth.garment_vertex.resize(static_cast<std::size_t>(garment.vertex_count));
  for (int v = 0; v < garment.vertex_count; ++v) cloth.garment_vertex[static_cast<std::size_t>(v)] = v;
  cloth.panel.assign(static_cast<std::size_t>(garment.vertex_count), 0);
  cloth.first = {0};
  cloth.stitched.clear();
  return cloth;
}

void push_out(const Body& body, double offset, Eigen::Ref<Eigen::Vector3d> at) {
  if (body.distance.distance(at) >= offset) return;
  const DistanceSample sample = body.distance.sample(at);
  const double steepness = sample.gradient.squaredNorm();
  if (steepness > 1e-6) at += std::min(offset - sample.distance, 0.02) / steepness * sample.gradient;
}

}  // namespace

bool untangle(const GarmentMesh& garment, const Body& body, double body_offset, const std::vector<int>& open,
              Eigen::Matrix3Xd& positions) {
  auto crossing = intersecting_triangles(positions, garment.triangles);
  if (crossing.empty() && open.empty()) return false;
  LoosePanels cloth = welded_cloth(garment, positions);
  const auto neighbours = neighbours_of(cloth);
  std::vector<char> in_patch(static_cast<std::size_t>(garment.vertex_count), 0);
  for (const int v : open) in_patch[static_cast<std::size_t>(v)] = 1;
  Eigen::Matrix3Xd& x = cloth.positions;
  for (int ring = 0; ring < most_rings && (ring == 0 || !crossing.empty()); ++ring) {
    const std::vector<char> inner = in_patch;
    for (std::size_t v = 0; v < inner.size(); ++v)
      if (inner[v])
        for (const Neighbour& next : neighbours[v]) in_patch[static_cast<std::size_t>(next.vertex)] = 1;
    for (const auto& [a, b] : crossing)
      for (const int t : {a, b})
        for (const int v : garment.triangles.col(t)) in_patch[static_cast<std::size_t>(v)] = 1;
    if (static_cast<double>(std::count(in_patch.begin(), in_patch.end(), 1)) > most_share * garment.vertex_count) return false;
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t v = 0; v < in_patch.size(); ++v) {
        if (!in_patch[v]) continue;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double weight = 0;
        for (const Neighbour& next : neighbours[v]) {
          sum += next.weight * x.col(next.vertex);
          weight += next.weight;
        }
        x.col(static_cast<Eigen::Index>(v)) = sum / weight;
        push_out(body, body_offset, x.col(static_cast<Eigen::Index>(v)));
      }
    crossing = intersecting_triangles(x, garment.triangles);
  }
  if (!crossing.empty()) return false;
  draw_together({.shrinking_steps = 1, .holding_steps = relaxing_steps, .body_offset = body_offset}, body, cloth);
  if (!intersecting_triangles(x, garment.triangles).empty()) return false;
  positions = x;
  return true;
}

}  // namespace toile
