#pragma once
// Loose panels drawn together along their stitches, with the body and the cloth itself in the way.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "body/body.h"
#include "garment/mesh.h"

namespace toile {

struct Tie {
  int a, b;
  double length;  // m, at rest
};

// One vertex per panel vertex, numbered panel after panel.
struct LoosePanels {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi triangles;
  std::vector<int> garment_vertex;         // by vertex
  std::vector<int> panel;                  // by vertex
  std::vector<int> first;                  // first vertex of each panel
  std::vector<Tie> edges;                  // of the triangles
  std::vector<Tie> bends;                  // corners off an inner edge
  std::vector<std::vector<int>> stitched;  // vertices that become one
  std::vector<int> layer;                  // by vertex (layers.h), sewn one after the other; empty: one layer
};

// `placed`: start positions by panel.
LoosePanels loose_panels(const GarmentMesh& garment, const std::vector<Eigen::Matrix3Xd>& placed);

struct SewOptions {
  int shrinking_steps = 150;   // of each layer, over which its stitches shorten to nothing
  int holding_steps = 60;      // with the stitches closed
  int longest_hold = 240;      // while a stitch is still closing
  int sweeps = 10;             // of the constraints per step
  double body_offset = 1e-3;   // m
  double thickness = 2e-3;     // m, kept between two layers of cloth
  double bending_share = .05;  // of a sweep
  double closed_gap = 2e-3;    // m
  bool unfold =
      false;  // panels start narrower or wider than they are cut and take their shape when the stitches are nearly closed
  std::function<void(int step, int steps)> progress = {};
};

// Position-based dynamics (Mueller et al. 2007), unit mass, no weight, no friction; every move truncated
// (collide/truncation.h), so that a start without intersections ends without. Deterministic.
void draw_together(const SewOptions& options, const Body& body, LoosePanels& cloth);

// By stitch: m, farthest apart of its vertices.
std::vector<double> stitch_gaps(const LoosePanels& cloth);

}  // namespace toile
