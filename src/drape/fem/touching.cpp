#include "drape/fem/touching.h"

#include "drape/fem/model.h"
#include "parallel/threads.h"

namespace toile::fem {
namespace {

constexpr int chunks = 16;

}  // namespace

std::span<const int> corners_of(const ContactSpot& spot) {
  return {spot.vertex.data(), static_cast<std::size_t>(spot.corners)};
}

Eigen::Vector3d place_of(const ContactSpot& spot, const Eigen::Matrix3Xd& x) {
  const auto& v = spot.vertex;
  if (spot.corners == 1) return x.col(v[0]);
  if (spot.corners == 2) return (x.col(v[0]) + x.col(v[1])) / 2;
  return (x.col(v[0]) + x.col(v[1]) + x.col(v[2])) / 3;
}

std::vector<Touch> touching(const Model& model, const Eigen::Matrix3Xd& x) {
  std::vector<std::vector<Touch>> found(chunks);
  in_ranges(chunks, static_cast<int>(model.contact_spots.size()), [&](int chunk, int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const ContactSpot& spot = model.contact_spots[static_cast<std::size_t>(i)];
      const Eigen::Vector3d at = place_of(spot, x);
      const double distance = model.body->distance.distance(at);
      if (distance < model.contact.reach) found[static_cast<std::size_t>(chunk)].push_back({&spot, at, {.distance = distance}});
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
    for (const int v : corners_of(*touch.spot))
      forces(v) += normal_force(model.contact, touch.spot->area, touch.body.distance) / touch.spot->corners;
  return forces;
}

}  // namespace toile::fem
