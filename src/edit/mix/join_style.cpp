#include "edit/mix/join_style.h"

#include <Eigen/Dense>
#include <algorithm>
#include <map>

#include "edit/contact_region.h"
#include "edit/mix/blend.h"
#include "geometry/topology.h"
#include "style/soft_terms.h"

namespace toile {
namespace {

constexpr double released =
    0.06;  // of the body's height: how near the joint the garment need not keep its distance to the body

BodyTerms body_terms(const Body& body, const SideBySide& both, const JoinedGarment& joined, const HardConstraints& held,
                     const ContactRegion& contact, const Eigen::VectorXd& areas, const std::vector<SoftTerm>& aligned) {
  constexpr double loose_fit = 0.01, loose_proportion = 0.02, staying = 5e-3;  // as in grading: so that nothing creeps
  const Eigen::Index count = both.positions.cols();
  const StyleWeights weights = style_weights(body.form.height);
  const auto places = relative_places(body, both.positions, both.triangles);
  std::vector<bool> on_edge(static_cast<std::size_t>(count), false);
  for (const VertexLoop& edge : boundary_loops(joined.garment.triangles))
    for (const int v : edge) on_edge[static_cast<std::size_t>(v)] = true;
  BodyWishes wishes;
  wishes.moves.assign(static_cast<std::size_t>(count), true);
  wishes.least = contact.gap.cwiseMin(contact_distance(contact.gap));
  wishes.release = wishes.offset = Eigen::VectorXd::Zero(count);
  for (Eigen::Index v = 0; v < count; ++v) {
    const auto at = static_cast<std::size_t>(v);
    wishes.limb.push_back(places[at].limb);
    if (held.vertices.count(static_cast<int>(v))) {
      wishes.moves[at] = false;
      continue;
    }
    double joint = 1e9;
    for (const auto& [w, freedom] : held.vertices)
      joint = std::min(joint, (both.positions.col(v) - both.positions.col(w)).norm());
    const double kept = smoothstep(joint, 0, released * body.form.height);
    wishes.offset(v) = places[at].offset;
    if (places[at].through_skin)
      wishes.release(v) = kept * (contact.tight[at] ? 1 : loose_fit * (1 - smoothstep(places[at].offset, 0.05, 0.20)));
    const double share = (contact.tight[at] || on_edge[at] ? 1 : loose_proportion) * std::max(kept, loose_proportion);
    wishes.proportion.push_back(proportion_term(static_cast<int>(v), places[at].axis,
                                                places[at].axis.dot(both.positions.col(v)), share * areas(v), weights));
    for (int i = 0; i < 3; ++i)
      wishes.proportion.push_back({static_cast<int>(v), Eigen::Vector3d::Unit(i), both.positions(i, v),
                                   staying * weights.fit * areas(v) / (weights.length * weights.length)});
  }
  for (const SoftTerm& term : aligned)
    if (wishes.moves[static_cast<std::size_t>(term.vertex)]) wishes.proportion.push_back(term);
  return {body, areas, std::move(wishes)};
}

}  // namespace

SideBySide side_by_side(const JoinedGarment& joined) {
  const GarmentMesh& garment = joined.garment;
  SideBySide both;
  std::map<int, int> twin;
  for (int v = 0; v < garment.vertex_count; ++v) both.welded.push_back(v);
  for (const int v : joined.joint) {
    twin[v] = static_cast<int>(both.welded.size());
    both.welded.push_back(v);
  }
  both.positions.resize(3, static_cast<Eigen::Index>(both.welded.size()));
  for (int v = 0; v < garment.vertex_count; ++v)
    both.positions.col(v) = joined.hanging[0].col(v).allFinite() ? joined.hanging[0].col(v) : joined.hanging[1].col(v);
  for (const auto& [v, second] : twin) both.positions.col(second) = joined.hanging[1].col(v);
  both.triangles = garment.triangles;
  const std::vector<int> offsets = triangle_offsets(garment);
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    for (int t = offsets[p]; joined.side[p] == 1 && t < offsets[p + 1]; ++t)
      for (int k = 0; k < 3; ++k)
        if (const auto found = twin.find(both.triangles(k, t)); found != twin.end()) both.triangles(k, t) = found->second;
  return both;
}

MixedShape join_style(const Body& body, const JoinedGarment& joined, const EditInput& first, const EditInput& second) {
  const SideBySide both = side_by_side(joined);
  GarmentMesh apart = joined.garment;
  apart.triangles = both.triangles;
  MixedShape mixed;
  HardConstraints held;
  const auto first_twin = static_cast<Eigen::Index>(joined.garment.vertex_count);
  for (std::size_t i = 0; i < joined.joint.size(); ++i) {
    const int v = joined.joint[i], twin = static_cast<int>(first_twin + static_cast<Eigen::Index>(i));
    const Eigen::Vector3d a = both.positions.col(v), b = both.positions.col(twin);
    held.hold(v, (a + b) / 2);
    held.hold(twin, (a + b) / 2);
    mixed.gap_max = std::max(mixed.gap_max, (a - b).norm());
    mixed.gap_mean += (a - b).norm() / static_cast<double>(joined.joint.size());
  }
  const Pattern nothing;
  const ContactRegion contact = contact_region({nothing, apart, both.positions, body});
  const std::vector<SourceTriangle> reference = source_triangles(both.positions, both.triangles);
  const Eigen::VectorXd areas = vertex_areas(reference, both.positions.cols());
  const BodyTerms terms = body_terms(body, both, joined, held, contact, areas,
                                     alignment_terms(body, joined, both.positions, both.triangles, areas, first, second));
  mixed.styled = with_weakest_pull([&](const StyleOptions& style) {
    BodyTerms again = terms;
    const StyleSolution solution = solve_style(both.positions, reference, held, again.all(), style);
    return styled(body, again, reference, both.positions, contact.gap, solution.initial, solution);
  });
  mend(mixed.styled, body, reference, both.positions, contact.gap, held);
  mixed.positions = mixed.styled.positions.leftCols(first_twin);
  mixed.source = both.positions.leftCols(first_twin);
  for (const int v : joined.joint) mixed.source.col(v) = mixed.positions.col(v);
  return mixed;
}

}  // namespace toile
