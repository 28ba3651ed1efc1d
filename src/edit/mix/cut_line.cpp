#include "edit/mix/cut_line.h"

#include <algorithm>
#include <cmath>

#include "edit/level_loops.h"

namespace toile {

std::vector<CutLine> cut_lines(const Eigen::Matrix3Xi& triangles, const Eigen::VectorXd& field) {
  constexpr double least = 1e-6;  // share of an edge, so that no two crossings are one point
  const LevelMesh mesh = level_mesh(triangles);
  const auto crossed = [&](std::size_t e) {
    return (field(mesh.edges[e].vertex[0]) >= 0) != (field(mesh.edges[e].vertex[1]) >= 0);
  };
  const auto crossing = [&](std::size_t e, int triangle) {
    auto [a, b] = mesh.edges[e].vertex;
    if (field(a) >= 0) std::swap(a, b);
    return Crossing{a, b, std::clamp(field(a) / (field(a) - field(b)), least, 1 - least), triangle};
  };
  std::vector<CutLine> closed;
  std::vector<bool> done(mesh.edges.size(), false);
  for (std::size_t start = 0; start < mesh.edges.size(); ++start) {
    if (done[start] || !crossed(start)) continue;
    CutLine line;
    std::size_t edge = start;
    int triangle = mesh.edges[start].triangle[0];
    bool back = false;
    while (triangle >= 0 && !back) {
      done[edge] = true;
      line.push_back(crossing(edge, triangle));
      std::size_t next = edge;
      for (int corner = 0; corner < 3; ++corner) {
        const auto e = static_cast<std::size_t>(mesh.edge_of(corner, triangle));
        if (e != edge && crossed(e)) next = e;
      }
      back = next == start;
      if (!back && done[next]) break;
      edge = next;
      triangle = mesh.edges[edge].triangle[mesh.edges[edge].triangle[0] == triangle ? 1 : 0];
    }
    if (back && line.size() >= 3) closed.push_back(std::move(line));
  }
  return closed;
}

std::vector<Eigen::Vector3d> points_of(const CutLine& line, const Eigen::Matrix3Xd& positions) {
  std::vector<Eigen::Vector3d> points;
  for (const Crossing& c : line) points.push_back((1 - c.at) * positions.col(c.before) + c.at * positions.col(c.beyond));
  return points;
}

std::vector<Eigen::Vector3d> points_of(const VertexLoop& loop, const Eigen::Matrix3Xd& positions) {
  std::vector<Eigen::Vector3d> points;
  for (const int v : loop) points.push_back(positions.col(v));
  return points;
}

std::vector<Eigen::Vector3d> points_of(const CutLoop& loop, const Eigen::Matrix3Xd& positions) {
  return loop.seam.empty() ? points_of(loop.line, positions) : points_of(loop.seam, positions);
}

}  // namespace toile
