#pragma once
// Where a cloth touches the body: the distance field is asked once for all that depends on it.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "body/distance_field.h"

namespace toile::fem {

struct Model;
struct ContactSpot;

// A spot within reach of the body.
struct Touch {
  const ContactSpot* spot = nullptr;  // the model's
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  DistanceSample body;  // until sample_touching only the distance
};

std::span<const int> corners_of(const ContactSpot& spot);
Eigen::Vector3d place_of(const ContactSpot& spot, const Eigen::Matrix3Xd& x);

// In the order of the model's spots.
std::vector<Touch> touching(const Model& model, const Eigen::Matrix3Xd& x);
void sample_touching(const Model& model, std::vector<Touch>& touches);
std::vector<Touch> touching_sampled(const Model& model, const Eigen::Matrix3Xd& x);

// N, by vertex: of itself, and its share of that of its edges and triangles.
Eigen::VectorXd normal_forces(const Model& model, const std::vector<Touch>& touches);

}  // namespace toile::fem
