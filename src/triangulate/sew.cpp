#include <algorithm>
#include <map>
#include <utility>

#include "garment/welds.h"
#include "triangulate/seam_places.h"
#include "triangulate/stitching.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

// A side that runs along its panel's outline must meet one that runs against it, or the right side of one panel continues as
// the wrong side of the other.
void check_not_twisted(const Pattern& pattern) {
  for (const Seam& seam : pattern.seams) {
    const auto along = [&](const EdgeSpan& span) {
      return (span.begin < span.end) != is_mirrored(*find_piece(pattern, span.piece), span.copy);
    };
    if (seam.right_to_wrong || along(seam.a) != along(seam.b)) continue;
    refuse_seam("seam.twisted", seam, "both sides run the same way round their pieces, which sews a right side to a wrong side",
                "Exchange begin and end of one of them, or mark the seam as right to wrong");
  }
}

// Three different corners to a triangle, and no more than two triangles at an edge, but where edges of more panels are sewn to
// each other.
void check_edges(const Pattern& pattern, const GarmentMesh& garment, const std::vector<int>& seam_at, const MatedSides& mates,
                 const std::vector<int>& first) {
  const auto refuse = [&](int a, int b, const std::string& text) {
    const int seam = std::max(seam_at[static_cast<std::size_t>(a)], seam_at[static_cast<std::size_t>(b)]);
    refuse_seam("seam.not-manifold", pattern.seams[static_cast<std::size_t>(std::max(seam, 0))], text,
                "Sew each edge only to those that it meets there, and no edge to its own neighbour unless they form a dart");
  };
  std::map<std::pair<int, int>, std::size_t> triangles_at;
  bool layered = false;
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      const int a = garment.triangles(corner, t), b = garment.triangles((corner + 1) % 3, t);
      if (a == b) refuse(a, b, "it sews two corners of one triangle together");
      layered |= ++triangles_at[std::minmax(a, b)] > 2;
    }
  if (!layered) return;
  std::map<std::pair<int, int>, std::vector<WeldedSide>> sides_at;
  for (const BoundarySegment& s : boundary_segments(garment)) {
    const auto p = static_cast<std::size_t>(s.panel);
    sides_at[std::minmax(garment.welded[p](s.from), garment.welded[p](s.to))].push_back(
        {first[p] + s.from, first[p] + s.to, s.panel, s.edge});
  }
  for (const auto& [ends, count] : triangles_at)
    if (const auto& sides = sides_at[ends]; count > 2 && (sides.size() != count || !sewn_together(sides, mates)))
      refuse(ends.first, ends.second, "with the other seams it joins more than two layers along one line");
}

}  // namespace

GarmentMesh sew(const Pattern& pattern, std::vector<PanelMesh> panels) {
  GarmentMesh garment;
  garment.panels = std::move(panels);
  std::vector<int> first{0};
  for (const PanelMesh& panel : garment.panels) first.push_back(first.back() + static_cast<int>(panel.rest.cols()));
  const std::vector<Mating> runs = matings(pattern, panel_loops(garment.panels));
  check_not_twisted(pattern);
  const std::vector<int> root = welded_to(runs, first, first.back());

  std::vector<int> number(root.size(), -1);
  for (std::size_t i = 0; i < root.size(); ++i)
    number[i] = root[i] == static_cast<int>(i) ? garment.vertex_count++ : number[static_cast<std::size_t>(root[i])];
  std::vector<Eigen::Matrix3Xi> parts;
  Eigen::Index count = 0;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    Eigen::VectorXi welded(panel.rest.cols());
    for (Eigen::Index v = 0; v < welded.size(); ++v) welded(v) = number[static_cast<std::size_t>(first[p] + v)];
    parts.push_back(panel.triangles.unaryExpr([&](int v) { return welded(v); }));
    garment.welded.push_back(std::move(welded));
    count += panel.triangles.cols();
  }
  garment.triangles.resize(3, count);
  count = 0;
  for (const Eigen::Matrix3Xi& part : parts) {
    garment.triangles.middleCols(count, part.cols()) = part;
    count += part.cols();
  }

  std::vector<int> seam_at(static_cast<std::size_t>(garment.vertex_count), -1);
  for (const Mating& run : runs)
    for (const int v : run.a)
      seam_at[static_cast<std::size_t>(garment.welded[static_cast<std::size_t>(run.panel_a)](v))] = run.seam;
  check_edges(pattern, garment, seam_at, mated_sides(runs, first), first);
  check(garment);
  return garment;
}

}  // namespace toile
