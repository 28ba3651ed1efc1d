#include "triangulate/triangulate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "garment/report.h"
#include "garment/units.h"
#include "geometry/topology.h"
#include "triangulate/fill.h"
#include "triangulate/outline.h"
#include "triangulate/sampling.h"
#include "triangulate/stitching.h"

namespace toile {
namespace {

constexpr double most_triangles = 2e6;

Eigen::Matrix3Xi columns(const std::vector<std::array<int, 3>>& triangles) {
  Eigen::Matrix3Xi result(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    result.col(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  return result;
}

PanelMesh panel_of(const Piece& piece, int index, int copy, const std::vector<OutlineSample>& outline, const Filling& filling) {
  PanelMesh panel;
  panel.piece = index;
  panel.copy = copy;
  panel.mirrored = is_mirrored(piece, copy);
  panel.name = copies(piece) == 1 ? piece.name : piece.name + ":" + std::to_string(copy);
  panel.rest.resize(2, static_cast<Eigen::Index>(filling.points.size()));
  for (std::size_t v = 0; v < filling.points.size(); ++v) panel.rest.col(static_cast<Eigen::Index>(v)) = filling.points[v];
  panel.triangles = columns(filling.triangles);
  for (std::size_t v = 0; v < outline.size(); ++v)
    panel.boundary.push_back({static_cast<int>(v), outline[v].edge, outline[v].at});
  if (piece.grainline && piece.grainline->to != piece.grainline->from)
    panel.warp = (piece.grainline->to - piece.grainline->from).normalized();
  if (panel.mirrored) {
    panel.rest.row(0) *= -1;
    panel.triangles.row(1).swap(panel.triangles.row(2));
    std::reverse(panel.boundary.begin(), panel.boundary.end());
    panel.warp.x() *= -1;
  }
  return panel;
}

// A length in the wrong unit, of the pattern or of the mesh, would otherwise fill the memory first.
void check_number_of_triangles(const Pattern& pattern, double edge_length) {
  double area = 0;
  for (const Piece& piece : pattern.pieces) area += signed_area(piece);
  const double expected = area / (std::sqrt(3) / 4 * edge_length * edge_length);
  if (expected > most_triangles)
    throw BadInput({"mesh.edge-length-too-short", Severity::error, "edge length " + in_mm(edge_length, 3),
                    "the pieces cover " + std::to_string(std::lround(area)) + " square metres and would need " +
                        std::to_string(std::lround(expected / 1e6)) + " million triangles",
                    "Choose a longer one, or read the pattern with the right unit", Fault::bad_input});
}

// Puts a point in the middle of the edge a-b between two triangles.
void split_edge(Filling& filling, int a, int b) {
  const int middle = static_cast<int>(filling.points.size());
  filling.points.push_back((filling.points[static_cast<std::size_t>(a)] + filling.points[static_cast<std::size_t>(b)]) / 2);
  const std::size_t count = filling.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    auto& triangle = filling.triangles[t];
    const auto at_a = std::find(triangle.begin(), triangle.end(), a), at_b = std::find(triangle.begin(), triangle.end(), b);
    if (at_a == triangle.end() || at_b == triangle.end()) continue;
    auto half = triangle;
    half[static_cast<std::size_t>(at_a - triangle.begin())] = middle;
    *at_b = middle;
    filling.triangles.push_back(half);
  }
}

// An edge inside a panel whose two ends are on the outline can come to lie on another such edge, or on a seam, once its ends
// are sewn: four triangles at one edge. Such edges get a vertex of their own.
void split_chords_that_sewing_joins(const Pattern& pattern, const std::vector<std::vector<OutlineSample>>& outlines,
                                    std::vector<Filling>& fillings) {
  struct Chord {
    std::size_t piece;
    int a, b;
  };
  struct Meeting {
    bool outline = false;
    std::vector<Chord> chords;
  };
  std::vector<std::vector<MeshEdge>> edges;
  for (const Filling& filling : fillings) edges.push_back(mesh_edges(columns(filling.triangles)));

  std::vector<PanelLoop> panels;
  std::vector<int> first;
  int total = 0;
  for (std::size_t p = 0; p < outlines.size(); ++p)
    for (int copy = 1; copy <= copies(pattern.pieces[p]); ++copy) {
      PanelLoop panel{static_cast<int>(p), copy, {}};
      for (std::size_t v = 0; v < outlines[p].size(); ++v)
        panel.vertices.push_back({static_cast<int>(v), outlines[p][v].edge, outlines[p][v].at});
      first.push_back(total);
      total += static_cast<int>(outlines[p].size());
      panels.push_back(std::move(panel));
    }
  const std::vector<int> root = welded_to(matings(pattern, panels), first, total);

  std::map<std::pair<int, int>, Meeting> meetings;
  for (std::size_t q = 0; q < panels.size(); ++q) {
    const auto p = static_cast<std::size_t>(panels[q].piece);
    for (const MeshEdge& edge : edges[p]) {
      if (edge.vertex[1] >= static_cast<int>(outlines[p].size())) continue;
      const int a = root[static_cast<std::size_t>(first[q] + edge.vertex[0])],
                b = root[static_cast<std::size_t>(first[q] + edge.vertex[1])];
      Meeting& meeting = meetings[{std::min(a, b), std::max(a, b)}];
      if (edge.triangle[1] < 0)
        meeting.outline = true;
      else
        meeting.chords.push_back({p, edge.vertex[0], edge.vertex[1]});
    }
  }
  std::set<std::tuple<std::size_t, int, int>> split;
  for (const auto& [ends, meeting] : meetings)
    if (ends.first == ends.second || meeting.chords.size() + (meeting.outline ? 1 : 0) > 1)
      for (const Chord& chord : meeting.chords)
        if (split.emplace(chord.piece, chord.a, chord.b).second) split_edge(fillings[chord.piece], chord.a, chord.b);
}

}  // namespace

std::vector<PanelMesh> triangulate(const Pattern& pattern, const TriangulateOptions& options) {
  if (!(options.edge_length > 0) || !std::isfinite(options.edge_length))
    throw std::invalid_argument("triangulate: edge_length must be positive");
  check_outlines(pattern);
  check_number_of_triangles(pattern, options.edge_length);
  const std::vector<std::vector<OutlineSample>> outlines = sample_outlines(pattern, options.edge_length);
  std::vector<Filling> fillings;
  for (const std::vector<OutlineSample>& outline : outlines) {
    std::vector<Eigen::Vector2d> loop;
    for (const OutlineSample& sample : outline) loop.push_back(sample.position);
    fillings.push_back(fill(loop, options.edge_length, options.smallest_angle));
  }
  split_chords_that_sewing_joins(pattern, outlines, fillings);

  std::vector<PanelMesh> panels;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    for (int copy = 1; copy <= copies(pattern.pieces[p]); ++copy)
      panels.push_back(panel_of(pattern.pieces[p], static_cast<int>(p), copy, outlines[p], fillings[p]));
  return panels;
}

}  // namespace toile
