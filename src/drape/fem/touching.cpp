#include "drape/fem/touching.h"

#include "drape/fem/model.h"
#include "parallel/threads.h"

namespace toile::fem {
namespace {

constexpr int chunks = 16;

}  // namespace

// Edges bridge where the body is round, and sag deeper than faces: contact is kept at their midpoints as well as at the
// vertices (weights 3/4 and 1/4).
std::vector<Touch> touching(const Model& model, const Eigen::Matrix3Xd& x) {
  std::vector<std::vector<Touch>> found(2 * chunks);
  const auto visit = [&](const std::array<int, 2>& vertex, double area, std::vector<Touch>& list) {
    const Eigen::Vector3d at = (x.col(vertex[0]) + x.col(vertex[1])) / 2;
    const double distance = model.body->distance.distance(at);
    if (distance < model.contact.reach) list.push_back({vertex, area, at, {.distance = distance}});
  };
  in_ranges(chunks, static_cast<int>(x.cols()), [&](int chunk, int begin, int end) {
    for (int v = begin; v < end; ++v) visit({v, v}, model.contact_area(v), found[static_cast<std::size_t>(chunk)]);
  });
  in_ranges(chunks, static_cast<int>(model.contact_edges.size()), [&](int chunk, int begin, int end) {
    for (int e = begin; e < end; ++e) {
      const ContactEdge& edge = model.contact_edges[static_cast<std::size_t>(e)];
      visit(edge.vertex, edge.area, found[static_cast<std::size_t>(chunks + chunk)]);
    }
  });
  std::vector<Touch> touches;
  for (const auto& list : found) touches.insert(touches.end(), list.begin(), list.end());
  return touches;
}

void sample_touching(const Model& model, std::vector<Touch>& touches) {
  in_ranges(chunks, static_cast<int>(touches.size()), [&](int, int begin, int end) {
    for (int i = begin; i < end; ++i) {
      Touch& touch = touches[static_cast<std::size_t>(i)];
      touch.body = model.body->distance.sample(touch.at);
    }
  });
}

std::vector<Touch> touching_sampled(const Model& model, const Eigen::Matrix3Xd& x) {
  std::vector<Touch> touches = touching(model, x);
  sample_touching(model, touches);
  return touches;
}

Eigen::VectorXd normal_forces(const Model& model, const std::vector<Touch>& touches) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(model.mass.size());
  for (const Touch& touch : touches)
    for (const int v : touch.vertex) forces(v) += normal_force(model.contact, touch.area, touch.body.distance) / 2;
  return forces;
}

}  // namespace toile::fem
