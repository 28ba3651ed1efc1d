#include "body/triangle_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace toile {
namespace {

using Vec = Eigen::Vector3d;
using Box = Eigen::AlignedBox3d;

struct Corners {
  Vec a, b, c;
};

struct Ball {
  Vec centre;
  double radius;
};

// Voronoi regions of the triangle, after Ericson, Real-Time Collision Detection, 5.1.5.
Vec nearest_on_triangle(const Corners& t, const Vec& p) {
  const Vec ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return t.a;
  const Vec bp = p - t.b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return t.b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return d1 > d3 ? Vec(t.a + d1 / (d1 - d3) * ab) : t.a;
  const Vec cp = p - t.c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return t.c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return d2 > d6 ? Vec(t.a + d2 / (d2 - d6) * ac) : t.a;
  const double va = d3 * d6 - d5 * d4, along = d4 - d3, back = d5 - d6;
  if (va <= 0 && along >= 0 && back >= 0) return along + back > 0 ? Vec(t.b + along / (along + back) * (t.c - t.b)) : t.b;
  const double sum = va + vb + vc;
  return t.a + vb / sum * ab + vc / sum * ac;
}

// Moeller and Trumbore 1997, both sides, border included.
std::optional<double> crossing(const Corners& t, const Vec& from, const Vec& step) {
  const Vec ab = t.b - t.a, ac = t.c - t.a, across = step.cross(ac);
  const double det = ab.dot(across);
  if (det == 0) return std::nullopt;
  const Vec to = from - t.a;
  const double u = to.dot(across) / det;
  if (!(u >= 0 && u <= 1)) return std::nullopt;
  const Vec up = to.cross(ab);
  const double v = step.dot(up) / det;
  if (!(v >= 0 && u + v <= 1)) return std::nullopt;
  return ac.dot(up) / det;
}

// Does from + t * step, 0 <= t <= most, meet the box? `inverse` is 1 / step by component, possibly infinite.
bool meets(const Box& box, const Vec& from, const Vec& inverse, double most) {
  double enter = 0, leave = most;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = (box.min()[axis] - from[axis]) * inverse[axis], high = (box.max()[axis] - from[axis]) * inverse[axis];
    if (std::isnan(low) || std::isnan(high)) continue;  // parallel to this slab and on its face
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  }
  return enter <= leave * (1 + 1e-14);
}

// Without branches, which the processor would guess wrong.
double squared_distance(const Box& box, const Vec& p) {
  const auto off = [&](int axis) { return std::max(std::max(box.min()[axis] - p[axis], p[axis] - box.max()[axis]), 0.0); };
  const double x = off(0), y = off(1), z = off(2);
  return x * x + y * y + z * z;
}

constexpr int leaf_size = 4;

}  // namespace

struct TriangleTree::Nodes {
  struct Node {
    Box box;
    int begin = 0, end = 0;  // triangles in `order`
    int right = 0;           // second child; the first follows its parent; 0 for a leaf
  };
  std::vector<Corners> corners;  // in tree order
  std::vector<Ball> balls;       // in tree order, each holds its triangle
  std::vector<int> order;        // tree order to triangle
  std::vector<int> place;        // triangle to tree order
  std::vector<Node> nodes;

  void build(int begin, int end, const std::vector<Vec>& centre, const std::vector<Box>& boxes) {
    const std::size_t self = nodes.size();
    nodes.push_back({});
    Box box, spread;
    for (int i = begin; i < end; ++i) {
      const auto t = static_cast<std::size_t>(order[static_cast<std::size_t>(i)]);
      box.extend(boxes[t]);
      spread.extend(centre[t]);
    }
    nodes[self].box = box;
    nodes[self].begin = begin;
    nodes[self].end = end;
    if (end - begin <= leaf_size) return;
    int axis = 0;
    spread.sizes().maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end, [&](int a, int b) {
      const double left = centre[static_cast<std::size_t>(a)][axis], right = centre[static_cast<std::size_t>(b)][axis];
      return left != right ? left < right : a < b;
    });
    build(begin, middle, centre, boxes);
    nodes[self].right = static_cast<int>(nodes.size());
    build(middle, end, centre, boxes);
  }

  template <class Visit>
  void along(const Vec& from, const Vec& step, double most, const Visit& visit) const {
    const Vec inverse = step.cwiseInverse();
    std::array<int, 64> stack;
    std::size_t height = 0;
    stack[height++] = 0;
    while (height > 0) {
      const int index = stack[--height];
      const Node& node = nodes[static_cast<std::size_t>(index)];
      if (!meets(node.box, from, inverse, most)) continue;
      if (node.right == 0) {
        for (int i = node.begin; i < node.end; ++i)
          if (const auto t = crossing(corners[static_cast<std::size_t>(i)], from, step); t && *t >= 0 && *t <= most)
            visit(order[static_cast<std::size_t>(i)], *t);
      } else {
        stack[height++] = node.right;
        stack[height++] = index + 1;
      }
    }
  }
};

TriangleTree::TriangleTree(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  if (triangles.cols() == 0) throw std::invalid_argument("TriangleTree: no triangles");
  if (triangles.minCoeff() < 0 || triangles.maxCoeff() >= positions.cols())
    throw std::invalid_argument("TriangleTree: a triangle names a vertex that is not there");
  if (!positions.allFinite()) throw std::invalid_argument("TriangleTree: positions are not finite");
  auto nodes = std::make_shared<Nodes>();
  const auto count = static_cast<std::size_t>(triangles.cols());
  std::vector<Vec> centre(count);
  std::vector<Box> boxes(count);
  nodes->order.resize(count);
  for (std::size_t t = 0; t < count; ++t) {
    const Eigen::Vector3i corner = triangles.col(static_cast<Eigen::Index>(t));
    for (int i = 0; i < 3; ++i) boxes[t].extend(Vec(positions.col(corner[i])));
    centre[t] = boxes[t].center();
    nodes->order[t] = static_cast<int>(t);
  }
  nodes->nodes.reserve(count);
  nodes->build(0, static_cast<int>(count), centre, boxes);
  nodes->corners.resize(count);
  nodes->balls.resize(count);
  nodes->place.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const int t = nodes->order[i];
    const Eigen::Vector3i corner = triangles.col(t);
    const Corners& c = nodes->corners[i] = {positions.col(corner[0]), positions.col(corner[1]), positions.col(corner[2])};
    const Vec middle = centre[static_cast<std::size_t>(t)];
    const double radius =
        std::sqrt(std::max({(c.a - middle).squaredNorm(), (c.b - middle).squaredNorm(), (c.c - middle).squaredNorm()}));
    nodes->balls[i] = {middle, radius * (1 + 1e-12)};
    nodes->place[static_cast<std::size_t>(t)] = static_cast<int>(i);
  }
  nodes_ = std::move(nodes);
}

NearestPoint TriangleTree::nearest(const Vec& query, double within, int guess) const {
  if (!nodes_) throw std::invalid_argument("TriangleTree::nearest: the tree is empty");
  const Nodes& tree = *nodes_;
  NearestPoint best;
  double bound = within * within;
  double reach = within;  // sqrt(bound)
  const auto try_triangle = [&](int i) {
    const Ball& ball = tree.balls[static_cast<std::size_t>(i)];
    const double near = reach + ball.radius;
    if ((ball.centre - query).squaredNorm() > near * near) return;
    const Vec at = nearest_on_triangle(tree.corners[static_cast<std::size_t>(i)], query);
    const double squared = (at - query).squaredNorm();
    if (squared < bound || (best.triangle < 0 && squared <= bound)) {
      bound = squared;
      reach = std::sqrt(squared);
      best = {tree.order[static_cast<std::size_t>(i)], at, 0};
    }
  };
  if (guess >= 0) try_triangle(tree.place[static_cast<std::size_t>(guess)]);

  std::array<std::pair<double, int>, 64> stack;
  std::size_t height = 0;
  stack[height++] = {squared_distance(tree.nodes[0].box, query), 0};
  while (height > 0) {
    const auto [distance, index] = stack[--height];
    if (distance > bound) continue;
    const Nodes::Node& node = tree.nodes[static_cast<std::size_t>(index)];
    if (node.right == 0) {
      for (int i = node.begin; i < node.end; ++i) try_triangle(i);
      continue;
    }
    std::pair<double, int> left{squared_distance(tree.nodes[static_cast<std::size_t>(index) + 1].box, query), index + 1};
    std::pair<double, int> right{squared_distance(tree.nodes[static_cast<std::size_t>(node.right)].box, query), node.right};
    if (left.first > right.first) std::swap(left, right);
    if (right.first <= bound) stack[height++] = right;
    if (left.first <= bound) stack[height++] = left;
  }
  if (best.triangle >= 0) best.distance = std::sqrt(bound);
  return best;
}

TriangleTree::Neighbourhood TriangleTree::around(const Vec& centre, double distance, double reach) const {
  if (!nodes_) throw std::invalid_argument("TriangleTree::around: the tree is empty");
  Neighbourhood found;
  found.nodes_ = nodes_;
  found.centre_ = centre;
  // The triangle nearest to a point p has distance(p) <= distance + |p - centre|, hence lies within that + |p - centre| of
  // centre.
  const double most = (distance + 2 * reach) * (1 + 1e-9) + 1e-12;
  std::array<int, 64> stack;
  std::size_t height = 0;
  stack[height++] = 0;
  while (height > 0) {
    const int index = stack[--height];
    const Nodes::Node& node = nodes_->nodes[static_cast<std::size_t>(index)];
    if (squared_distance(node.box, centre) > most * most) continue;
    if (node.right != 0) {
      stack[height++] = node.right;
      stack[height++] = index + 1;
      continue;
    }
    for (int i = node.begin; i < node.end; ++i) {
      const Ball& ball = nodes_->balls[static_cast<std::size_t>(i)];
      if (const double from = (ball.centre - centre).norm() - ball.radius; from <= most) found.candidates_.push_back({from, i});
    }
  }
  std::sort(found.candidates_.begin(), found.candidates_.end(), [](const auto& a, const auto& b) {
    return a.from_centre != b.from_centre ? a.from_centre < b.from_centre : a.place < b.place;
  });
  return found;
}

double TriangleTree::Neighbourhood::distance(const Vec& query) const {
  const double off = (query - centre_).norm() * (1 + 1e-9) + 1e-12;
  double bound = std::numeric_limits<double>::infinity(), reach = bound;
  for (const Candidate& candidate : candidates_) {
    if (candidate.from_centre - off > reach) break;
    const auto place = static_cast<std::size_t>(candidate.place);
    const Ball& ball = nodes_->balls[place];
    const double near = reach + ball.radius;
    if ((ball.centre - query).squaredNorm() > near * near) continue;
    if (const double squared = (nearest_on_triangle(nodes_->corners[place], query) - query).squaredNorm(); squared < bound) {
      bound = squared;
      reach = std::sqrt(squared);
    }
  }
  return reach;
}

std::vector<double> TriangleTree::crossings(const Vec& from, const Vec& step, double most) const {
  if (!nodes_) throw std::invalid_argument("TriangleTree::crossings: the tree is empty");
  std::vector<double> found;
  nodes_->along(from, step, most, [&](int, double t) { found.push_back(t); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<int> TriangleTree::pierced(const Vec& from, const Vec& to) const {
  if (!nodes_) throw std::invalid_argument("TriangleTree::pierced: the tree is empty");
  std::vector<int> found;
  nodes_->along(from, to - from, 1, [&](int triangle, double) { found.push_back(triangle); });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace toile
