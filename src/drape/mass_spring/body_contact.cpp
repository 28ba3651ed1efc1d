#include "drape/mass_spring/body_contact.h"

#include <Eigen/Dense>
#include <algorithm>

namespace toile::mass_spring {
namespace {

constexpr double margin = 1.5e-3;       // m beyond the contact's reach within which samples are followed
constexpr double followed = 0.25e-3;    // m over which the field is taken from its derivatives
constexpr double trusted_share = 0.5;   // of a distance farther off, where the field is only interpolated
constexpr double ahead = 0.2e-3;        // m, how much deeper the push is expected to be in the next step
constexpr double floor = -1e-3;         // m, deeper the push alone does not get
constexpr double deepest_push = 10e-3;  // m, longest move out of the body in one step

Eigen::Vector3d place(const ContactSample& sample, const Eigen::Matrix3Xd& x) {
  return (x.col(sample.vertex[0]) + x.col(sample.vertex[1])) / 2;
}

}  // namespace

BodyContact::BodyContact(const Cloth& cloth) : cloth_(cloth), far_until_(cloth.samples.size(), 0.0) {}

void BodyContact::look_round(const Eigen::Matrix3Xd& x) {
  std::vector<Near> near;
  const double band = cloth_.body->distance.band();
  auto known = near_.begin();
  for (std::size_t i = 0; i < cloth_.samples.size(); ++i) {
    while (known != near_.end() && static_cast<std::size_t>(known->sample) < i) ++known;
    if (travel_ < far_until_[i]) continue;
    const Eigen::Vector3d at = place(cloth_.samples[i], x);
    const double distance = std::min(cloth_.body->distance.distance(at), band);
    if (distance > cloth_.contact.reach + 2 * margin) {
      far_until_[i] = travel_ + std::max(margin, trusted_share * (distance - cloth_.contact.reach - margin));
      continue;
    }
    if (known != near_.end() && static_cast<std::size_t>(known->sample) == i)
      near.push_back(*known);
    else
      near.push_back({static_cast<int>(i), at, cloth_.body->distance.sample(at)});
  }
  near_ = std::move(near);
  looked_until_ = travel_ + margin;
}

void BodyContact::update(double longest_move, Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& push, Eigen::VectorXd& stiffness) {
  travel_ += longest_move;
  if (travel_ >= looked_until_ || near_.empty()) look_round(x);
  push.setZero(3, x.cols());
  stiffness.setZero(x.cols());
  double moved_out = 0;
  for (Near& near : near_) {
    const ContactSample& sample = cloth_.samples[static_cast<std::size_t>(near.sample)];
    const bool is_vertex = sample.vertex[0] == sample.vertex[1];
    Eigen::Vector3d at = place(sample, x);
    Eigen::Vector3d step = at - near.at;
    if (step.squaredNorm() > followed * followed) {
      near.at = at;
      near.field = cloth_.body->distance.sample(at);
      step.setZero();
    }
    const Eigen::Vector3d bend = near.field.hessian * step;
    double distance = near.field.distance + near.field.gradient.dot(step) + bend.dot(step) / 2;
    if (distance >= cloth_.contact.reach) continue;
    const Eigen::Vector3d gradient = near.field.gradient + bend;
    const double steepness = gradient.squaredNorm();
    if (distance < floor && steepness > 1e-6) {
      const double out = std::min((floor - distance) / std::sqrt(steepness), deepest_push);
      const Eigen::Vector3d move = out / std::sqrt(steepness) * gradient;
      for (std::size_t i = 0; i < (is_vertex ? 1u : 2u); ++i) x.col(sample.vertex[i]) += move;
      moved_out = std::max(moved_out, out);
      distance = std::min(floor, distance + out * std::sqrt(steepness));
    }
    const Eigen::Vector3d force = fem::normal_force(cloth_.contact, sample.area, distance) * gradient;
    const double stiff = fem::normal_stiffness(cloth_.contact, sample.area, distance - ahead);
    if (is_vertex) {
      push.col(sample.vertex[0]) += force;
      stiffness(sample.vertex[0]) += stiff;
    } else {
      for (const int v : sample.vertex) {
        push.col(v) += force / 2;
        stiffness(v) += stiff / 2;
      }
    }
  }
  travel_ += moved_out;
}

}  // namespace toile::mass_spring
