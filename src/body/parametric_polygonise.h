#pragma once
// The surface of a form as triangles.

#include <Eigen/Core>

#include "body/parametric_form.h"

namespace toile {

struct Surface {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi triangles;
};

// Closed and oriented outwards. `edge_length` in m.
Surface polygonise(const BodyForm& form, const Figure& figure, double edge_length);

}  // namespace toile
