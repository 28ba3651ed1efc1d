#include "style/mend_turned.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "style/normal_deviation.h"
#include "style/style_solve.h"

namespace toile {
namespace {

constexpr double most_turned = 0.02;  // of the triangles: beyond that it is the edit that is wrong
constexpr double pull = 0.1;
constexpr std::array<int, 4> rings{1, 2, 4, 8};

// By vertex: within `count` edges of a triangle of the list.
std::vector<bool> round(const std::vector<SourceTriangle>& triangles, Eigen::Index vertices, const std::vector<int>& list,
                        int count) {
  std::vector<bool> near(static_cast<std::size_t>(vertices), false);
  for (const int t : list)
    for (const int v : triangles[static_cast<std::size_t>(t)].corners) near[static_cast<std::size_t>(v)] = true;
  for (int ring = 0; ring < count; ++ring) {
    const std::vector<bool> before = near;
    for (const SourceTriangle& triangle : triangles)
      if (std::any_of(triangle.corners.begin(), triangle.corners.end(),
                      [&](int v) { return before[static_cast<std::size_t>(v)]; }))
        for (const int v : triangle.corners) near[static_cast<std::size_t>(v)] = true;
  }
  return near;
}

// The vertices marked `moves` solved for, all others held.
Eigen::Matrix3Xd laid_anew(const std::vector<SourceTriangle>& triangles, const Eigen::Matrix3Xd& source,
                           const Eigen::Matrix3Xd& x, const std::vector<bool>& moves) {
  std::vector<int> number(moves.size(), -1), vertex;
  std::vector<SourceTriangle> part;
  HardConstraints held;
  for (SourceTriangle triangle : triangles) {
    if (std::none_of(triangle.corners.begin(), triangle.corners.end(),
                     [&](int v) { return moves[static_cast<std::size_t>(v)]; }))
      continue;
    for (int& v : triangle.corners) {
      int& own = number[static_cast<std::size_t>(v)];
      if (own < 0) {
        own = static_cast<int>(vertex.size());
        vertex.push_back(v);
        if (!moves[static_cast<std::size_t>(v)]) held.hold(own, x.col(v));
      }
      v = own;
    }
    part.push_back(triangle);
  }
  StyleOptions options;
  options.in_plane_pull = pull;
  const StyleSolution solution = solve_style(Eigen::Matrix3Xd(source(Eigen::all, vertex)), part, held, {}, options);
  Eigen::Matrix3Xd laid = x;
  for (std::size_t i = 0; i < vertex.size(); ++i)
    if (moves[static_cast<std::size_t>(vertex[i])]) laid.col(vertex[i]) = solution.positions.col(static_cast<Eigen::Index>(i));
  return laid;
}

}  // namespace

Eigen::Matrix3Xd mend_turned(const std::vector<SourceTriangle>& triangles, const Eigen::Matrix3Xd& source,
                             const Eigen::Matrix3Xd& x, const HardConstraints& hard) {
  Eigen::Matrix3Xd best = x;
  std::vector<int> turned = normal_deviation(triangles, source, best).flipped;
  if (static_cast<double>(turned.size()) > most_turned * static_cast<double>(triangles.size())) return best;
  for (std::size_t i = 0; i < rings.size() && !turned.empty(); ++i) {
    std::vector<bool> moves = round(triangles, x.cols(), turned, rings[i]);
    for (const auto& [v, freedom] : hard.vertices) moves[static_cast<std::size_t>(v)] = false;
    try {
      Eigen::Matrix3Xd laid = laid_anew(triangles, source, best, moves);
      std::vector<int> left = normal_deviation(triangles, source, laid).flipped;
      if (left.size() >= turned.size()) continue;
      best = std::move(laid);
      turned = std::move(left);
    } catch (const std::invalid_argument&) {  // the patch is all of a part that nothing holds
      break;
    }
  }
  return best;
}

}  // namespace toile
