#pragma once
// One limb for every garment vertex, so that neighbours and rings agree.

#include <Eigen/Core>
#include <vector>

#include "body/relative.h"

namespace toile {

constexpr double limb_disagreement = .02;  // m

// `cost`: limb by vertex, m (relative.h). Starts from the cheapest limb, lets neighbours persuade each other (iterated
// conditional modes of a Potts model: a neighbourhood that disagrees costs `limb_disagreement`), then gives every ring of the
// garment below the armpits the limb that it surrounds, and every ring round an arm that arm.
std::vector<int> coherent_limbs(const Mannequin& form, const std::vector<LimbAxis>& axes, const Eigen::MatrixXd& cost,
                                const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles);

}  // namespace toile
