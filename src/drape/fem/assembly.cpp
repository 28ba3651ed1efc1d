#include "drape/fem/assembly.h"

#include <Eigen/Dense>
#include <algorithm>

#include "parallel/threads.h"

namespace toile::fem {
namespace {

// Adds the lower blocks of `local`, whose rows are those of `vertex`, at their places.
template <std::size_t corners, std::size_t blocks, class Local>
void add_local(const std::array<int, corners>& vertex, const std::array<int, blocks>& place, const Local& local,
               std::vector<double>& values) {
  std::size_t b = 0;
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = 0; j <= i; ++j, ++b) {
      Eigen::Map<Eigen::Matrix3d> into(&values[static_cast<std::size_t>(place[b])]);
      const auto block = local.template block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j));
      if (vertex[i] >= vertex[j])
        into += block;
      else
        into += block.transpose();
    }
}

template <std::size_t blocks, std::size_t corners>
std::array<int, blocks> places(const BlockMatrix& matrix, const std::array<int, corners>& vertex) {
  std::array<int, blocks> place{};
  std::size_t b = 0;
  for (std::size_t i = 0; i < corners; ++i)
    for (std::size_t j = 0; j <= i; ++j) place[b++] = matrix.place(vertex[i], vertex[j]);
  return place;
}

// The share of one half of the triangles, springs and hinges.
void add_cloth(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, Curvature curvature,
               const HessianAssembly& assembly, std::size_t half, std::vector<double>& values) {
  const auto part = [&](std::size_t count) { return std::pair{half * count / 2, (half + 1) * count / 2}; };
  const auto [first_triangle, last_triangle] = part(model.triangles.size());
  for (std::size_t t = first_triangle; t < last_triangle; ++t) {
    const MembraneElement& element = model.triangles[t];
    Vector9 ignored = Vector9::Zero();
    Matrix9 local = Matrix9::Zero();
    membrane_derivatives(element, model.law, corners_of(element, x), curvature, ignored, &local);
    add_local(element.vertex, assembly.triangle_place[t], local, values);
  }
  const auto [first_spring, last_spring] = part(model.springs.size());
  for (std::size_t s = first_spring; s < last_spring; ++s) {
    const mass_spring::Spring& spring = model.springs[s];
    double pull = frozen.pull.empty() ? mass_spring::pull_of(model.spring_law, spring, x) : frozen.pull[s];
    if (curvature == Curvature::clamped) pull = std::max(pull, 0.0);
    const Eigen::Matrix3d block = mass_spring::spring_stiffness(model.spring_law, spring, x, pull);
    Eigen::Matrix<double, 6, 6> local;
    local << block, -block, -block, block;
    add_local(std::array<int, 2>{spring.a, spring.b}, assembly.spring_place[s], local, values);
  }
  const auto [first_hinge, last_hinge] = part(model.hinges.size());
  for (std::size_t h = first_hinge; h < last_hinge; ++h) {
    if (model.bend_frictions[h].moment <= 0) continue;
    Vector12 ignored = Vector12::Zero();
    Matrix12 local = Matrix12::Zero();
    bend_friction_derivatives(model.bend_frictions[h], frozen.bent[h], model.hinges[h], x, curvature, ignored, &local);
    add_local(model.hinges[h].vertex, assembly.hinge_place[h], local, values);
  }
}

}  // namespace

std::unique_ptr<HessianAssembly> make_assembly(const Model& model, std::vector<std::pair<int, int>> coupled) {
  std::vector<std::pair<int, int>> pairs = std::move(coupled);
  for (const ContactSpot& spot : model.contact_spots)
    if (spot.corners == 2) pairs.emplace_back(spot.vertex[0], spot.vertex[1]);
  for (const Hinge& h : model.hinges)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) pairs.emplace_back(h.vertex[i], h.vertex[j]);
  std::unique_ptr<HessianAssembly> assembly(
      new HessianAssembly{BlockMatrix(static_cast<int>(model.mass.size()), std::move(pairs)), {}, {}, {}, {}, 1, {}});
  for (const MembraneElement& e : model.triangles) assembly->triangle_place.push_back(places<6>(assembly->matrix, e.vertex));
  for (const mass_spring::Spring& s : model.springs)
    assembly->spring_place.push_back(places<3>(assembly->matrix, std::array<int, 2>{s.a, s.b}));
  for (const Hinge& h : model.hinges) {
    assembly->hinge_place.push_back(places<10>(assembly->matrix, h.vertex));
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        assembly->matrix.add(h.vertex[i], h.vertex[j], h.stiffness * h.weight[i] * h.weight[j] * Eigen::Matrix3d::Identity());
  }
  assembly->constant = assembly->matrix.values();
  assembly->second.resize(assembly->constant.size());
  return assembly;
}

void assemble(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, const std::vector<Touch>& touches,
              Curvature curvature, HessianAssembly& assembly) {
  BlockMatrix& matrix = assembly.matrix;
  std::vector<double>& values = matrix.values();
  in_ranges(2, 2, [&](int half, int, int) {
    if (half == 0)
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = assembly.bending_share * assembly.constant[i];
    else
      std::fill(assembly.second.begin(), assembly.second.end(), 0.0);
    add_cloth(model, frozen, x, curvature, assembly, static_cast<std::size_t>(half), half == 0 ? values : assembly.second);
  });
  in_ranges(2, static_cast<int>(values.size()), [&](int, int begin, int end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) values[i] += assembly.second[i];
  });
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const FrictionState& friction = frozen.vertex[static_cast<std::size_t>(v)];
    if (friction.force > 0)
      matrix.add(static_cast<int>(v), static_cast<int>(v), friction_hessian(model.contact, friction, x.col(v)));
  }
  for (const Touch& touch : touches) {
    const DistanceSample& body = touch.body;
    const double area = touch.spot->area;
    Eigen::Matrix3d block = normal_stiffness(model.contact, area, body.distance) * body.gradient * body.gradient.transpose();
    if (curvature == Curvature::full) block -= normal_force(model.contact, area, body.distance) * body.hessian;
    const std::span<const int> corners = corners_of(*touch.spot);
    block /= touch.spot->corners * touch.spot->corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) matrix.add(corners[i], corners[j], block);
  }
  add_self_contact(frozen.self, x, matrix);
}

void assemble(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, Curvature curvature,
              HessianAssembly& assembly) {
  assemble(model, frozen, x, touching_sampled(model, x), curvature, assembly);
}

}  // namespace toile::fem
