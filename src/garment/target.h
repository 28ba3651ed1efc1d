#pragma once
// What the user wants the draped garment to look like: x^g of the paper.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "garment/mesh.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

struct Body;

struct StyleTerms {
  double shape = 0, proportion = 0, fit = 0;
  bool operator==(const StyleTerms&) const = default;
};

struct Target {
  GarmentMesh garment;         // the source garment, or the one the edit made of it: topology and rest shape
  Eigen::Matrix3Xd source;     // the source drape, one column per garment vertex
  Eigen::Matrix3Xd positions;  // the target, same vertices
  std::vector<int> held;       // handle vertices: fixed by the edit
  std::vector<int> anchor;     // anchor loop vertices
  StyleTerms before, after;    // style energy by term, at the initial guess and at the end
  double normal_deviation_mean = 0, normal_deviation_max = 0;  // radians, target against source
  std::shared_ptr<const Body> body;                            // what the target is worn on, when that is not the source's body
  std::shared_ptr<const Pattern> pattern;                      // of `garment`, when the edit made another one
  Report report;                                               // what the edit did and warns of
};

}  // namespace toile
