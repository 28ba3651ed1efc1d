#include "edit/fit/offset.h"

#include <Eigen/Dense>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <utility>

#include "edit/reach.h"

namespace toile {
namespace {

constexpr double inner_proportion = 0.02;  // of what free edges are asked: so that cloth does not creep along its own surface

BodyTerms body_terms(const EditInput& input, const std::vector<FitLoop>& fits, double release, EditMemory& memory) {
  const std::vector<RelativePlace>& places = source_places(input, memory);
  const ContactRegion& contact = source_contact(input, memory);
  const Eigen::VectorXd areas = vertex_areas(source_shape(input, memory), input.drape.cols());
  const Eigen::Index count = input.drape.cols();
  const StyleWeights weights = style_weights(input.body.form.height);
  BodyWishes wishes;
  wishes.moves.assign(static_cast<std::size_t>(count), false);
  std::set<int> held;
  std::vector<int> pulled;
  for (const FitLoop& fit : fits) {
    for (const int v : fit.moving) wishes.moves[static_cast<std::size_t>(v)] = true;
    held.insert(fit.loop.begin(), fit.loop.end());
    for (std::size_t i = 0; i < fit.loop.size(); ++i)
      if (fit.share(static_cast<Eigen::Index>(i)) > 0) pulled.push_back(fit.loop[i]);
  }
  wishes.least = contact.gap.cwiseMin(contact_distance(contact.gap));
  wishes.release = Eigen::VectorXd::Zero(count);
  wishes.offset = Eigen::VectorXd::Zero(count);
  const Eigen::VectorXd way = way_along_cloth(input, memory, pulled);
  for (Eigen::Index v = 0; v < count; ++v) {
    const auto at = static_cast<std::size_t>(v);
    wishes.limb.push_back(places[at].limb);
    wishes.offset(v) = places[at].offset;
    if (wishes.moves[at] && contact.tight[at] && places[at].through_skin && !held.count(static_cast<int>(v)))
      wishes.release(v) = smoothstep(way(v), 0, release);
  }
  std::vector<bool> on_edge(static_cast<std::size_t>(count), false);
  for (const VertexLoop& edge : garment_boundary(input, memory))
    for (const int v : edge) on_edge[static_cast<std::size_t>(v)] = true;
  for (Eigen::Index v = 0; v < count; ++v) {
    const auto at = static_cast<std::size_t>(v);
    if (!wishes.moves[at] || held.count(static_cast<int>(v))) continue;
    const double share = on_edge[at] ? 1 : inner_proportion;
    wishes.proportion.push_back(proportion_term(static_cast<int>(v), places[at].axis, places[at].axis.dot(input.drape.col(v)),
                                                share * areas(v), weights));
  }
  return {input.body, areas, std::move(wishes)};
}

HardConstraints held_at(const EditInput& input, const std::vector<FitLoop>& fits, const std::vector<Eigen::VectorXd>& offsets) {
  std::vector<bool> moves(static_cast<std::size_t>(input.drape.cols()), false);
  for (const FitLoop& fit : fits)
    for (const int v : fit.moving) moves[static_cast<std::size_t>(v)] = true;
  HardConstraints hard;
  for (Eigen::Index v = 0; v < input.drape.cols(); ++v)
    if (!moves[static_cast<std::size_t>(v)]) hard.hold(static_cast<int>(v), input.drape.col(v));
  for (std::size_t f = 0; f < fits.size(); ++f) {
    const Eigen::Matrix3Xd goal = fits[f].moved(input.drape, offsets[f]);
    for (Eigen::Index i = 0; i < goal.cols(); ++i) hard.hold(fits[f].loop[static_cast<std::size_t>(i)], goal.col(i));
  }
  return hard;
}

}  // namespace

Eigen::VectorXd way_along_cloth(const EditInput& input, EditMemory& memory, const std::vector<int>& from) {
  Eigen::VectorXd way = Eigen::VectorXd::Constant(input.drape.cols(), std::numeric_limits<double>::infinity());
  const VertexNeighbours& neighbours = garment_neighbours(input, memory);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const int v : from) {
    way(v) = 0;
    queue.emplace(0, v);
  }
  while (!queue.empty()) {
    const auto [so_far, v] = queue.top();
    queue.pop();
    if (so_far > way(v)) continue;
    for (const int next : neighbours[static_cast<std::size_t>(v)]) {
      const double there = so_far + (input.drape.col(v) - input.drape.col(next)).norm();
      if (there >= way(next)) continue;
      way(next) = there;
      queue.emplace(there, next);
    }
  }
  return way;
}

Styled offset_loops(const EditInput& input, const std::vector<FitLoop>& fits, const std::vector<Eigen::VectorXd>& offsets,
                    double release, EditMemory& memory, const std::string& name) {
  const BodyTerms& terms = memory.once(name + ", terms", [&] { return body_terms(input, fits, release, memory); });
  return restyled({input.body, input.drape, source_shape(input, memory), source_contact(input, memory).gap, input.drape,
                   held_at(input, fits, offsets), terms},
                  memory, name);
}

}  // namespace toile
