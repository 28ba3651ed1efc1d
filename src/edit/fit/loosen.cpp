#include "edit/fit/loosen.h"

#include <Eigen/Dense>
#include <algorithm>
#include <set>
#include <utility>

#include "edit/fit/offset.h"
#include "edit/reach.h"

namespace toile {
namespace {

// Evens out a field over the mesh; jumps where neighbours are measured from different bones go.
void smooth(const VertexNeighbours& neighbours, int times, Eigen::MatrixXd& field) {
  for (int round = 0; round < times; ++round) {
    Eigen::MatrixXd next = field;
    for (Eigen::Index v = 0; v < field.cols(); ++v) {
      const auto& around = neighbours[static_cast<std::size_t>(v)];
      if (around.empty()) continue;
      Eigen::VectorXd mean = Eigen::VectorXd::Zero(field.rows());
      for (const int w : around) mean += field.col(w) / static_cast<double>(around.size());
      next.col(v) = (field.col(v) + mean) / 2;
    }
    field = std::move(next);
  }
}

// The largest part of the garment between the loops that stay.
std::vector<int> part_that_moves(const VertexNeighbours& neighbours, const std::set<int>& blocked) {
  std::vector<bool> seen(neighbours.size(), false);
  std::vector<int> moving;
  if (blocked.empty()) {
    for (std::size_t v = 0; v < neighbours.size(); ++v) moving.push_back(static_cast<int>(v));
    return moving;
  }
  for (std::size_t v = 0; v < neighbours.size(); ++v) {
    if (seen[v] || blocked.count(static_cast<int>(v))) continue;
    std::vector<int> part = reached(neighbours, {static_cast<int>(v)}, blocked);
    for (const int w : part) seen[static_cast<std::size_t>(w)] = true;
    if (part.size() > moving.size()) moving = std::move(part);
  }
  return moving;
}

}  // namespace

Loosened loosen(const EditInput& input, double by, double release, const std::vector<VertexLoop>& stays, EditMemory& memory,
                const std::string& name) {
  const std::vector<RelativePlace>& places = source_places(input, memory);
  const ContactRegion& contact = source_contact(input, memory);
  const Eigen::Index count = input.drape.cols();
  const std::vector<SourceTriangle>& triangles = source_shape(input, memory);
  const Eigen::VectorXd areas = vertex_areas(triangles, count);
  const StyleWeights weights = style_weights(input.body.form.height);
  const VertexNeighbours& neighbours = garment_neighbours(input, memory);
  std::set<int> blocked;
  for (const VertexLoop& loop : stays) blocked.insert(loop.begin(), loop.end());
  const std::vector<int> moving = part_that_moves(neighbours, blocked);

  BodyWishes wishes;
  wishes.moves.assign(static_cast<std::size_t>(count), false);
  for (const int v : moving) wishes.moves[static_cast<std::size_t>(v)] = true;
  wishes.release = wishes.offset = Eigen::VectorXd::Zero(count);
  wishes.least = contact.gap.cwiseMin(contact_distance(contact.gap));
  Loosened result;
  result.moving = moving;
  const Eigen::VectorXd way = way_along_cloth(input, memory, {blocked.begin(), blocked.end()});
  Eigen::MatrixXd asked(1, count);
  for (Eigen::Index v = 0; v < count; ++v) {
    const auto at = static_cast<std::size_t>(v);
    wishes.limb.push_back(places[at].limb);
    asked(0, v) = 0;
    if (!wishes.moves[at]) continue;
    const DistanceSample skin = input.body.distance.sample(input.drape.col(v));
    const double up = contact.tight[at] ? skin.gradient.y() / std::max(1e-6, skin.gradient.norm()) : 0;
    asked(0, v) = by * (1 - smoothstep(up, 0.3, 0.7)) * smoothstep(way(v), 0, release);
    if (by < 0) asked(0, v) = -std::min(-asked(0, v), std::max(0.0, contact.gap(v) - wishes.least(v)));
  }
  smooth(neighbours, 5, asked);

  Eigen::MatrixXd push(3, count);
  for (Eigen::Index v = 0; v < count; ++v) push.col(v) = places[static_cast<std::size_t>(v)].outward * asked(0, v);
  smooth(neighbours, 10, push);
  Eigen::Matrix3Xd guess = input.drape;
  for (const int v : moving) {
    guess.col(v) += push.col(v);
    const RelativePlace& place = places[static_cast<std::size_t>(v)];
    const double still = smoothstep(push.col(v).norm(), 0, 0.5 * std::abs(by));  // bones disagree where it is small
    wishes.proportion.push_back(
        {v, place.outward, place.outward.dot(input.drape.col(v)) + asked(0, v),
         weights.fit * (asked(0, v) == 0 ? 1 : std::max(0.05, still)) * areas(v) / (weights.length * weights.length)});
  }
  for (const VertexLoop& edge : garment_boundary(input, memory))
    for (const int v : edge) {
      const RelativePlace& place = places[static_cast<std::size_t>(v)];
      if (wishes.moves[static_cast<std::size_t>(v)])
        wishes.proportion.push_back(proportion_term(v, place.axis, place.axis.dot(input.drape.col(v)), areas(v), weights));
    }
  HardConstraints hard;
  for (Eigen::Index v = 0; v < count; ++v)
    if (!wishes.moves[static_cast<std::size_t>(v)]) hard.hold(static_cast<int>(v), input.drape.col(v));
  result.asked = asked.row(0).transpose();
  result.styled = restyled({input.body, input.drape, triangles, contact.gap, std::move(guess), std::move(hard),
                            BodyTerms(input.body, areas, std::move(wishes))},
                           memory, name);
  return result;
}

}  // namespace toile
