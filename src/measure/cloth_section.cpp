#include "measure/cloth_section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace toile {
namespace {

struct Cut {
  std::array<Eigen::Vector3d, 2> piece;
  double at_rest = 0;  // m
  int node = 0;        // number of one of the mesh edges it ends on
};

int root(std::vector<int>& parent, int node) {
  while (parent[static_cast<std::size_t>(node)] != node) node = parent[static_cast<std::size_t>(node)];
  return node;
}

}  // namespace

std::vector<ClothSection> cloth_sections(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions,
                                         const Eigen::Vector3d& at, const Eigen::Vector3d& normal) {
  const Eigen::VectorXd height = (positions.colwise() - at).transpose() * normal.normalized();
  // Of the mesh edges that are cut, by ends and how many triangles before face the same way there: where several pieces are
  // sewn into one seam, a section goes on from the first on one side to the first on the other.
  std::map<std::array<int, 3>, int> number;
  std::map<std::pair<int, int>, int> before;  // by directed mesh edge
  std::vector<int> parent;
  std::vector<Cut> cuts;
  Eigen::Index t = 0;
  for (const PanelMesh& panel : garment.panels)
    for (Eigen::Index i = 0; i < panel.triangles.cols(); ++i, ++t) {
      Cut cut;
      std::array<Eigen::Vector2d, 2> flat;
      std::array<int, 2> nodes{};
      std::size_t found = 0;
      for (int k = 0; k < 3; ++k) {
        int from = k, to = (k + 1) % 3;
        if ((height(garment.triangles(from, t)) >= 0) == (height(garment.triangles(to, t)) >= 0)) continue;
        if (garment.triangles(from, t) > garment.triangles(to, t)) std::swap(from, to);  // the same point from both sides
        const int a = garment.triangles(from, t), b = garment.triangles(to, t);
        const int same_way = before[{garment.triangles(k, t), garment.triangles((k + 1) % 3, t)}]++;
        const double share = height(a) / (height(a) - height(b));
        cut.piece[found] = positions.col(a) + share * (positions.col(b) - positions.col(a));
        const Eigen::Vector2d start = panel.rest.col(panel.triangles(from, i)), end = panel.rest.col(panel.triangles(to, i));
        flat[found] = start + share * (end - start);
        const auto [place, added] = number.try_emplace({a, b, same_way}, static_cast<int>(parent.size()));
        if (added) parent.push_back(place->second);
        nodes[found++] = place->second;
      }
      if (found != 2) continue;
      cut.at_rest = (flat[1] - flat[0]).norm();
      cut.node = nodes[0];
      cuts.push_back(cut);
      parent[static_cast<std::size_t>(root(parent, nodes[1]))] = root(parent, nodes[0]);
    }
  std::map<int, std::size_t> part;
  std::vector<ClothSection> sections;
  for (const Cut& cut : cuts) {
    const auto [place, added] = part.try_emplace(root(parent, cut.node), sections.size());
    if (added) sections.emplace_back();
    sections[place->second].pieces.push_back(cut.piece);
    sections[place->second].at_rest += cut.at_rest;
  }
  return sections;
}

bool goes_round(const ClothSection& section, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal) {
  constexpr double turn = 2 * std::numbers::pi, gap = 1e-9;
  const Eigen::Vector3d first = normal.unitOrthogonal(), second = normal.normalized().cross(first);
  std::vector<std::pair<double, double>> seen;  // angles
  for (const auto& [from, to] : section.pieces) {
    const auto angle = [&](const Eigen::Vector3d& p) { return std::atan2((p - centre).dot(second), (p - centre).dot(first)); };
    double low = angle(from), high = angle(to);
    if (low > high) std::swap(low, high);
    if (high - low <= turn / 2) {
      seen.emplace_back(low, high);
    } else {  // across the direction opposite to `first`
      seen.emplace_back(-turn / 2, low);
      seen.emplace_back(high, turn / 2);
    }
  }
  std::sort(seen.begin(), seen.end());
  double reached = -turn / 2;
  for (const auto& [low, high] : seen) {
    if (low > reached + gap) return false;
    reached = std::max(reached, high);
  }
  return reached >= turn / 2 - gap;
}

}  // namespace toile
