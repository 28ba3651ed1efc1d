#include "edit/edge_chain.h"

#include <algorithm>
#include <map>
#include <set>

#include "garment/report.h"
#include "garment/units.h"
#include "geometry/topology.h"

namespace toile {
namespace {

std::string edge_in_words(const Pattern& pattern, const GarmentMesh& garment, const PanelEdge& edge) {
  const PanelMesh& panel = garment.panels[static_cast<std::size_t>(edge.panel)];
  return panel.name + "." +
         pattern.pieces[static_cast<std::size_t>(panel.piece)].outline[static_cast<std::size_t>(edge.edge)].id;
}

}  // namespace

std::vector<PanelEdge> edges_named(const Pattern& pattern, const GarmentMesh& garment, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::string of = dot == std::string::npos ? "" : name.substr(0, dot);
  const std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
  std::vector<PanelEdge> found;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    for (std::size_t e = 0; e < piece.outline.size(); ++e) {
      const std::string& id = piece.outline[e].id;
      if (id == name || ((of == piece.name || of == panel.name) && dot != std::string::npos && id == last))
        found.push_back({static_cast<int>(p), static_cast<int>(e)});
    }
  }
  return found;
}

std::vector<int> vertices_along(const Pattern& pattern, const GarmentMesh& garment, const PanelEdge& edge) {
  const auto p = static_cast<std::size_t>(edge.panel);
  const PanelMesh& panel = garment.panels[p];
  const auto count = static_cast<int>(pattern.pieces[static_cast<std::size_t>(panel.piece)].outline.size());
  std::vector<BoundaryVertex> along;
  const BoundaryVertex* end = nullptr;
  for (const BoundaryVertex& vertex : panel.boundary) {
    if (vertex.edge == edge.edge) along.push_back(vertex);
    if (vertex.edge == (edge.edge + 1) % count && (!end || vertex.at < end->at)) end = &vertex;
  }
  std::sort(along.begin(), along.end(), [](const BoundaryVertex& a, const BoundaryVertex& b) { return a.at < b.at; });
  if (end) along.push_back(*end);
  std::vector<int> vertices;
  for (const BoundaryVertex& vertex : along) vertices.push_back(garment.welded[p](vertex.vertex));
  return vertices;
}

namespace {

constexpr double longest_slit = 0.8;  // m, up one side and down the other

// Closes chains that a slit opens: from one end along the free edge of the garment to the other.
void bridge_slits(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, std::map<int, std::set<int>>& next) {
  for (const std::vector<int>& loop : boundary_loops(garment.triangles)) {
    const std::size_t n = loop.size();
    const auto at = [&](std::size_t i) { return loop[i % n]; };
    const auto chained = [&](std::size_t i) { return next.count(at(i)) > 0; };
    for (std::size_t i = 0; i < n; ++i) {
      if (!chained(i) || next[at(i)].size() != 1 || chained(i + 1)) continue;
      double length = 0;
      std::size_t last = i + 1;
      for (length += (positions.col(at(last)) - positions.col(at(i))).norm(); !chained(last); ++last)
        length += (positions.col(at(last + 1)) - positions.col(at(last))).norm();
      if (last == i + n || next[at(last)].size() != 1 || length > longest_slit) continue;
      for (std::size_t k = i; k < last; ++k) {
        next[at(k)].insert(at(k + 1));
        next[at(k + 1)].insert(at(k));
      }
    }
  }
}

}  // namespace

std::vector<VertexLoop> closed_chains(const Pattern& pattern, const GarmentMesh& garment, const Eigen::Matrix3Xd& positions,
                                      const std::vector<PanelEdge>& edges, const std::string& place, const std::string& name) {
  std::map<int, std::set<int>> next;
  std::map<int, std::string> owner;  // an edge that touches the vertex, for messages
  for (const PanelEdge& edge : edges) {
    const std::vector<int> along = vertices_along(pattern, garment, edge);
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      if (along[i] == along[i + 1]) continue;
      next[along[i]].insert(along[i + 1]);
      next[along[i + 1]].insert(along[i]);
    }
    for (const int v : along) owner.emplace(v, edge_in_words(pattern, garment, edge));
  }
  bridge_slits(garment, positions, next);
  const auto at = [&](int v) { return "at the end of " + owner[v] + " (height " + in_mm(positions(1, v), 0) + ")"; };
  std::vector<int> ends;
  for (const auto& [vertex, others] : next) {
    if (others.size() == 1) ends.push_back(vertex);
    if (others.size() > 2)
      throw BadInput({"edit.open-chain", Severity::error, place, "the edges of '" + name + "' branch " + at(vertex),
                      "name edges that make simple closed loops"});
  }
  if (!ends.empty()) {
    std::string text = "the edges of '" + name + "' do not close: open " + at(ends[0]);
    if (ends.size() > 1)
      text += " and " + at(ends[1]) + ", " + in_mm((positions.col(ends[0]) - positions.col(ends[1])).norm(), 0) + " apart";
    throw BadInput({"edit.open-chain", Severity::error, place, text,
                    "add the edges that are missing, separated by commas, or sew the opening in the pattern"});
  }
  std::vector<VertexLoop> loops;
  std::set<int> done;
  for (const auto& [start, others] : next) {
    if (done.count(start)) continue;
    VertexLoop loop;
    int from = -1, here = start;
    while (done.insert(here).second) {
      loop.push_back(here);
      const std::set<int>& ways = next[here];
      const int onwards = *ways.begin() != from ? *ways.begin() : *ways.rbegin();
      from = here;
      here = onwards;
    }
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace toile
