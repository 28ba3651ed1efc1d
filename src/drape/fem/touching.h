#pragma once
// Where a cloth touches the body: the distance field is asked once for all that depends on it.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "body/distance_field.h"

namespace toile::fem {

struct Model;

// A vertex (both entries the same) or the midpoint of an edge within reach of the body.
struct Touch {
  std::array<int, 2> vertex{};
  double area = 0;  // m^2 that it stands for
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  DistanceSample body;  // until sample_touching only the distance
};

// Vertices, then edges, both ascending.
std::vector<Touch> touching(const Model& model, const Eigen::Matrix3Xd& x);
void sample_touching(const Model& model, std::vector<Touch>& touches);
std::vector<Touch> touching_sampled(const Model& model, const Eigen::Matrix3Xd& x);

// N, by vertex: of itself, and half of that of its edges.
Eigen::VectorXd normal_forces(const Model& model, const std::vector<Touch>& touches);

}  // namespace toile::fem
