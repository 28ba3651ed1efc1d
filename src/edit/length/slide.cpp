#include "edit/length/slide.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "edit/body_terms.h"
#include "edit/length/on_cloth.h"
#include "edit/styled.h"

namespace toile {
namespace {

constexpr double clear_of_body = 1e-3;  // m

BodyTerms body_terms(const EditInput& input, const std::vector<Handle>& handles, const std::vector<RelativePlace>& places,
                     const ContactRegion& contact, const std::vector<SourceTriangle>& triangles, const SlideOptions& options) {
  const Eigen::Index count = input.drape.cols();
  const Eigen::VectorXd areas = vertex_areas(triangles, count);
  const StyleWeights weights = style_weights(input.body.form.height);
  std::vector<const Handle*> handle_of(static_cast<std::size_t>(count), nullptr);
  for (const Handle& handle : handles)
    for (const int v : handle.moving) handle_of[static_cast<std::size_t>(v)] = &handle;
  BodyWishes wishes;
  wishes.release = Eigen::VectorXd::Zero(count);
  wishes.offset = Eigen::VectorXd::Zero(count);
  wishes.least = contact.gap.cwiseMin(contact_distance(contact.gap));
  for (Eigen::Index v = 0; v < count; ++v) {
    const auto at = static_cast<std::size_t>(v);
    const Handle* handle = handle_of[at];
    wishes.moves.push_back(handle != nullptr);
    wishes.limb.push_back(places[at].limb);
    wishes.offset(v) = places[at].offset;
    if (handle && contact.tight[at] && places[at].through_skin)
      wishes.release(v) = smoothstep(std::abs(handle->level - handle->axis.dot(input.drape.col(v))), 0, options.release);
  }
  for (const Handle& handle : handles)
    for (const int v : handle.loop) wishes.release(v) = 0;
  for (const VertexLoop& loop : options.stays)
    for (const int v : loop)
      if (const Handle* handle = handle_of[static_cast<std::size_t>(v)])
        wishes.proportion.push_back(proportion_term(v, handle->axis, handle->axis.dot(input.drape.col(v)), areas(v), weights));
  // Fit is let go where the garment has slid out of the zone it was tight in.
  wishes.keep = [handle_of](int v, const Eigen::Vector3d& at) {
    const Handle& handle = *handle_of[static_cast<std::size_t>(v)];
    if (!handle.tight_edge) return 1.0;
    return 1 - smoothstep(handle.axis.dot(at), *handle.tight_edge - 0.02, *handle.tight_edge + 0.02);
  };
  return {input.body, areas, std::move(wishes)};
}

// Everything between anchor and loop scaled along the axis, everything beyond the loop shifted.
Eigen::Matrix3Xd scaled_along(const EditInput& input, const std::vector<Handle>& handles, double by) {
  Eigen::Matrix3Xd guess = input.drape;
  for (const Handle& handle : handles) {
    const double length = handle.level - handle.anchor_level;
    for (const int v : handle.moving) {
      const double share = std::clamp((handle.axis.dot(input.drape.col(v)) - handle.anchor_level) / length, 0.0, 1.0);
      guess.col(v) = input.drape.col(v) + by * share * handle.axis;
    }
  }
  return guess;
}

HardConstraints all_but_moving(const EditInput& input, const std::vector<Handle>& handles) {
  std::vector<bool> moves(static_cast<std::size_t>(input.drape.cols()), false);
  for (const Handle& handle : handles)
    for (const int v : handle.moving) moves[static_cast<std::size_t>(v)] = true;
  HardConstraints hard;
  for (Eigen::Index v = 0; v < input.drape.cols(); ++v)
    if (!moves[static_cast<std::size_t>(v)]) hard.hold(static_cast<int>(v), input.drape.col(v));
  return hard;
}

// The place nearest to `at` that is clear of the body.
Eigen::Vector3d outside(const Body& body, Eigen::Vector3d at) {
  for (int round = 0; round < 4; ++round) {
    const DistanceSample sample = body.distance.sample(at);
    const double steepness = sample.gradient.squaredNorm();
    if (sample.distance >= clear_of_body || steepness < 1e-6) break;
    at += (clear_of_body - sample.distance) / steepness * sample.gradient;
  }
  return at;
}

// Takes a loop that came to lie in the body out of it, and what is near it along the loop with it, less and less: where one
// place gives way the cloth beside it does.
void take_out(const Body& body, const VertexLoop& loop, Eigen::Matrix3Xd& positions) {
  constexpr double beside = 0.06;  // m along the loop
  const std::size_t n = loop.size();
  std::vector<double> along(n + 1, 0);
  std::vector<Eigen::Vector3d> push(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d at = positions.col(loop[i]);
    push[i] = outside(body, at) - at;
    along[i + 1] = along[i] + (positions.col(loop[(i + 1) % n]) - at).norm();
  }
  for (std::size_t i = 0; i < n; ++i) {
    Eigen::Vector3d most = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < n; ++k) {
      const double way = std::abs(along[i] - along[k]);
      const Eigen::Vector3d share = (1 - smoothstep(std::min(way, along[n] - way), 0, beside)) * push[k];
      if (share.squaredNorm() > most.squaredNorm()) most = share;
    }
    const Eigen::Vector3d at = positions.col(loop[i]);
    positions.col(loop[i]) = outside(body, at + most);
  }
}

// `on_cloth`: where the garment has slid to on its own cloth, if it shall.
Slide slide_once(const EditInput& input, const std::vector<Handle>& handles, const SlideOptions& options, double in_plane_pull,
                 const std::optional<Eigen::Matrix3Xd>& on_cloth, EditMemory& memory) {
  const ContactRegion& contact = source_contact(input, memory);
  const std::vector<SourceTriangle>& triangles = source_shape(input, memory);
  BodyTerms terms = body_terms(input, handles, source_places(input, memory), contact, triangles, options);
  StyleOptions style;
  style.in_plane_pull = in_plane_pull;
  HardConstraints hard = all_but_moving(input, handles);
  StyleSolution slid;
  // What a triangle's orientation is held against: its own in the source, or, where the garment has slid on itself, the
  // source's where it now lies.
  std::vector<SourceTriangle> reference = triangles;
  Eigen::Matrix3Xd shape = input.drape;
  if (on_cloth) {
    slid.positions = slid.initial = shape = *on_cloth;
    reference = source_triangles(shape, input.garment.triangles);
    for (const Handle& handle : handles) take_out(input.body, handle.loop, slid.positions);
  } else {
    for (const Handle& handle : handles)
      for (const int v : handle.loop) hard.hold_along(v, handle.axis, handle.axis.dot(input.drape.col(v)) + options.by);
    slid = solve_style(scaled_along(input, handles, options.by), triangles, hard, terms.all(), style, &memory.style());
  }
  for (const Handle& handle : handles)
    for (const int v : handle.loop) hard.hold(v, slid.positions.col(v));
  const StyleSolution frozen = solve_style(slid.positions, reference, hard, terms.all(), style, &memory.style());

  Slide slide;
  slide.positions = frozen.positions;
  slide.settled = frozen.settled;
  slide.in_plane_pull = in_plane_pull;
  const auto energy = [&](const Eigen::Matrix3Xd& x) {
    return StyleTerms{tilt_energy(reference, x), soft_energy(terms.proportion(), x), soft_energy(terms.fit(x), x)};
  };
  slide.before = energy(slid.initial);
  slide.after = energy(slide.positions);
  slide.deviation = normal_deviation(reference, shape, slide.positions);
  const NormalDeviation from_source = normal_deviation(triangles, input.drape, slide.positions);
  slide.deviation.least_stretch = from_source.least_stretch;
  slide.deviation.most_stretch = from_source.most_stretch;
  for (const Handle& handle : handles)
    for (const int v : handle.moving)
      slide.deepest =
          std::max(slide.deepest, std::min(0.0, contact.gap(v)) - input.body.distance.distance(slide.positions.col(v)));
  return slide;
}

}  // namespace

Slide slide_and_freeze(const EditInput& input, const std::vector<Handle>& handles, const SlideOptions& options,
                       EditMemory& memory) {
  auto on_cloth = slid_on_cloth(input, handles, options.by);
  if (on_cloth && !normal_deviation(source_shape(input, memory), input.drape, *on_cloth).flipped.empty()) on_cloth.reset();
  Slide best;
  for (bool again = true; again; on_cloth.reset()) {
    again = on_cloth.has_value();
    for (const double in_plane_pull : pulls) {
      Slide slide = slide_once(input, handles, options, in_plane_pull, on_cloth, memory);
      const bool whole = slide.deviation.flipped.empty();
      const bool enough = (on_cloth ? whole : is_even(slide.deviation)) && (slide.settled || in_plane_pull >= 0.1);
      if (best.positions.size() == 0 || enough || is_better(slide.deviation, best.deviation)) best = std::move(slide);
      if (enough) return best;
    }
  }
  return best;
}

}  // namespace toile
