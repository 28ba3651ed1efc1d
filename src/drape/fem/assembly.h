#pragma once
// The Hessian of the energy of model.h.

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "drape/fem/model.h"
#include "sparse/block_matrix.h"

namespace toile::fem {

// Pattern of the Hessian, where its parts go, and its constant (bending) part.
struct HessianAssembly {
  BlockMatrix matrix;
  std::vector<double> constant;
  std::vector<std::array<int, 6>> triangle_place;  // BlockMatrix::place of corner pairs (i, j <= i)
  std::vector<std::array<int, 3>> spring_place;
  std::vector<std::array<int, 10>> hinge_place;
  double bending_share = 1;    // times as much of the constant part is taken
  std::vector<double> second;  // half of the sum, so that two threads can add
};
// `coupled`: further vertex pairs that may share a block.
std::unique_ptr<HessianAssembly> make_assembly(const Model& model, std::vector<std::pair<int, int>> coupled = {});

// Fills assembly.matrix with the Hessian at x (no factorisation). Throws std::invalid_argument when the cloth touches itself
// where the pattern has no block. `touches`: sampled at x.
void assemble(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, const std::vector<Touch>& touches,
              Curvature curvature, HessianAssembly& assembly);
void assemble(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, Curvature curvature,
              HessianAssembly& assembly);

}  // namespace toile::fem
