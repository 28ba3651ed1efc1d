#include "collide/without_crossing.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "collide/near_pairs.h"
#include "collide/truncation.h"

namespace toile {
namespace {

constexpr double longest_reach = 12e-3;  // m, of the search for cloth that is near to cloth
constexpr double reach_share =
    0.65;                         // of the mean edge, at most: farther, every triangle is near to its neighbours' neighbours
constexpr double margin = 24e-3;  // m, moved before the search begins afresh
constexpr double longest_move = 5e-3;  // m at a time
constexpr double apart = 1e-3;         // m, kept between two layers of cloth
constexpr int sweeps = 4;
constexpr int most_moves = 200;
constexpr double arrived = 2e-5;  // m

// Keeps the sides of the pairs `apart` along the normal they have now; what is not to go anywhere gives no way.
void part(const std::vector<NearPair>& pairs, const std::vector<char>& goes, Eigen::Matrix3Xd& x) {
  for (const NearPair& pair : pairs) {
    Eigen::Vector4d side = pair.weight;
    side.tail(4 - pair.first) *= -1;
    double lack = apart;
    for (int i = 0; i < 4; ++i) lack -= side(i) * pair.normal.dot(x.col(pair.vertex[static_cast<std::size_t>(i)]));
    for (int i = 0; i < 4; ++i)
      if (!goes[static_cast<std::size_t>(pair.vertex[static_cast<std::size_t>(i)])]) side(i) = 0;
    if (lack <= 0 || side.squaredNorm() < 1e-12) continue;
    for (int i = 0; i < 4; ++i)
      x.col(pair.vertex[static_cast<std::size_t>(i)]) += std::min(lack / side.squaredNorm(), apart) * side(i) * pair.normal;
  }
}

}  // namespace

Eigen::Matrix3Xd without_crossing(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, const Eigen::Matrix3Xi& triangles) {
  CollisionMesh mesh = collision_mesh(triangles, static_cast<int>(from.cols()));
  if (mesh.edges.cols() == 0) return to;
  const double edge = (from(Eigen::all, mesh.edges.row(0)) - from(Eigen::all, mesh.edges.row(1))).colwise().norm().mean();
  NearPairSearch search(std::move(mesh), std::min(longest_reach, reach_share * edge), margin);
  std::vector<char> goes;
  for (Eigen::Index v = 0; v < from.cols(); ++v) goes.push_back(from.col(v) != to.col(v));
  Eigen::Matrix3Xd x = from;
  for (int move = 0; move < most_moves; ++move) {
    const Eigen::Matrix3Xd before = x;
    const Truncation near(x, search);
    Eigen::Matrix3Xd goal = to;
    for (Eigen::Index v = 0; v < x.cols(); ++v)
      if (const double far = (to.col(v) - x.col(v)).norm(); far > longest_move)
        goal.col(v) = x.col(v) + longest_move / far * (to.col(v) - x.col(v));
    for (int sweep = 0; sweep < sweeps; ++sweep) part(near.pairs(), goes, goal);
    near.advance(x, goal);
    if ((to - x).colwise().norm().maxCoeff() < arrived || (x - before).colwise().norm().maxCoeff() < arrived) break;
  }
  return x;
}

}  // namespace toile
