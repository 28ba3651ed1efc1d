#pragma once
// The pattern as triangles: one PanelMesh per copy of a piece, and the garment they make when welded along their seams.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace toile {

// Where a boundary vertex of a panel lies on its piece's outline: `at` of the arc length of edge `edge` (index into
// Piece::outline), 0 <= at < 1, so a corner belongs to the edge that starts there.
struct BoundaryVertex {
  int vertex = 0;
  int edge = 0;
  double at = 0;
  bool operator==(const BoundaryVertex&) const = default;
};

// One panel: a copy of a piece, cut. Copies of one piece have the same vertices, triangles and boundary in the same order.
// A mirrored copy has rest positions reflected about the y axis and its triangles turned over, so that triangles are always
// counter-clockwise in `rest` and their outside is the fabric's right side.
struct PanelMesh {
  int piece = 0;  // index into Pattern::pieces
  int copy = 1;
  bool mirrored = false;
  std::string name;                      // "gore:3"; just "gore" when the piece is cut once
  Eigen::Matrix2Xd rest;                 // m, pattern axes; the grain (warp) is +y unless the piece's grain line says otherwise
  Eigen::Matrix3Xi triangles;            // counter-clockwise
  std::vector<BoundaryVertex> boundary;  // the whole loop in outline order (reversed outline order for mirrored copies)
  Eigen::Vector2d warp = Eigen::Vector2d::UnitY();  // unit grain direction in `rest`
  Eigen::VectorXd
      layers;  // by triangle: layers of cloth, 2 where a hem is turned up, between at its edge; empty: one everywhere
  bool operator==(const PanelMesh&) const;  // of other sizes: false
};

// Panels welded along their seams. Garment triangle i is the i-th triangle of the panels in order.
struct GarmentMesh {
  std::vector<PanelMesh> panels;
  std::vector<Eigen::VectorXi> welded;  // [panel][panel vertex] -> garment vertex
  Eigen::Matrix3Xi triangles;           // garment vertices
  int vertex_count = 0;
  bool operator==(const GarmentMesh&) const;
};

// A rest shape for every panel of a garment: what the adjustment changes (X in the paper), same order as `panels`.
using RestShape = std::vector<Eigen::Matrix2Xd>;

RestShape rest_shape(const GarmentMesh&);
GarmentMesh with_rest(GarmentMesh garment, const RestShape& rest);  // throws std::invalid_argument on a size mismatch

int triangle_count(const GarmentMesh&);
// First garment triangle of each panel, and the total at the end (size panels + 1).
std::vector<int> triangle_offsets(const GarmentMesh&);
// The 2x2 matrix [b - a, c - a] of every garment triangle's rest shape, in triangle order.
std::vector<Eigen::Matrix2d> rest_triangles(const GarmentMesh&);
// Layers of cloth of every garment triangle.
Eigen::VectorXd triangle_layers(const GarmentMesh&);
// Rest area by garment vertex (a third of each incident triangle), m^2.
Eigen::VectorXd vertex_areas(const GarmentMesh&);

// Throws std::invalid_argument naming the panel when an invariant above does not hold.
void check(const GarmentMesh&);

}  // namespace toile
