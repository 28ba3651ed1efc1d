#include "edit/length/slide.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "edit/length/on_cloth.h"

namespace toile {
namespace {

constexpr double most_wanted_gap = 2e-3;  // m

// The distance at which the source lies on the body, so that a vertex that newly touches does not stand out from its
// neighbours.
double wanted_gap(const ContactRegion& contact) {
  double sum = 0;
  int count = 0;
  for (const double gap : contact.gap) {
    if (gap >= most_wanted_gap) continue;
    sum += std::max(0.0, gap);
    ++count;
  }
  return count > 0 ? sum / count : most_wanted_gap;
}

class BodyTerms {
 public:
  BodyTerms(const EditInput& input, const std::vector<Handle>& handles, const std::vector<RelativePlace>& places,
            const ContactRegion& contact, const std::vector<SourceTriangle>& triangles, const SlideOptions& options)
      : input_(input),
        places_(places),
        contact_(contact),
        axes_(limb_axes(input.body.form)),
        weights_(style_weights(input.body.form.height)),
        wanted_gap_(wanted_gap(contact)),
        areas_(vertex_areas(triangles, input.drape.cols())),
        handle_of_(static_cast<std::size_t>(input.drape.cols()), nullptr),
        release_(Eigen::VectorXd::Zero(input.drape.cols())),
        pushes_(static_cast<std::size_t>(input.drape.cols()), 0) {
    for (const Handle& handle : handles)
      for (const int v : handle.moving) handle_of_[static_cast<std::size_t>(v)] = &handle;
    for (Eigen::Index v = 0; v < input.drape.cols(); ++v) {
      const Handle* handle = handle_of_[static_cast<std::size_t>(v)];
      if (!handle || !contact.tight[static_cast<std::size_t>(v)]) continue;
      release_(v) = smoothstep(std::abs(handle->level - handle->axis.dot(input.drape.col(v))), 0, options.release);
    }
    for (const Handle& handle : handles)
      for (const int v : handle.loop) release_(v) = 0;
    for (const VertexLoop& loop : options.stays)
      for (const int v : loop)
        if (const Handle* handle = handle_of_[static_cast<std::size_t>(v)])
          proportion_.push_back(proportion_term(v, handle->axis, handle->axis.dot(input.drape.col(v)), areas_(v), weights_));
  }

  const std::vector<SoftTerm>& proportion() const { return proportion_; }

  // E_fit with the skin that is now under each vertex; let go where the garment has slid out of the zone it was tight in.
  std::vector<SoftTerm> fit(const Eigen::Matrix3Xd& x) const {
    std::vector<SoftTerm> terms;
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
      if (!(release_(v) > 0)) continue;
      const Handle& handle = *handle_of_[static_cast<std::size_t>(v)];
      const RelativePlace& source = places_[static_cast<std::size_t>(v)];
      const double keep = handle.tight_edge
                              ? 1 - smoothstep(handle.axis.dot(x.col(v)), *handle.tight_edge - 0.02, *handle.tight_edge + 0.02)
                              : 1;
      if (!(keep > 0) || !source.through_skin) continue;
      const RelativePlace now =
          relative_place(input_.body, axes_[static_cast<std::size_t>(source.limb)], source.limb, x.col(v));
      if (!now.through_skin) continue;
      terms.push_back(
          fit_term(static_cast<int>(v), {now.on_skin, now.outward}, source.offset, release_(v) * keep, areas_(v), weights_));
    }
    return terms;
  }

  double least_gap(int v) const { return std::min(wanted_gap_, contact_.gap(v)); }

  std::vector<SoftTerm> contact(const Eigen::Matrix3Xd& x) {
    std::vector<SoftTerm> terms;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      const auto v = static_cast<std::size_t>(i);
      if (!handle_of_[v]) continue;
      const double least = least_gap(static_cast<int>(i));
      const DistanceSample sample = input_.body.distance.sample(x.col(i));
      if (sample.distance > least + (pushes_[v] > 0 ? 2e-4 : -1e-5)) continue;
      if (sample.distance < least - 1e-4) ++pushes_[v];
      const double slope = std::max(1e-6, sample.gradient.norm());
      const Eigen::Vector3d outward = sample.gradient / slope;
      SoftTerm term = contact_term(static_cast<int>(i), {x.col(i) - outward * sample.distance / slope, outward}, least,
                                   areas_(i), weights_);
      term.weight *= std::pow(3.0, std::min(5, std::max(0, pushes_[v] - 1)));
      terms.push_back(term);
    }
    return terms;
  }

  SoftTermsAt all() {
    return [this](const Eigen::Matrix3Xd& x, int round) {
      std::vector<SoftTerm> terms = proportion_;
      const auto append = [&](const std::vector<SoftTerm>& more) { terms.insert(terms.end(), more.begin(), more.end()); };
      append(fit(x));
      if (round > 0) append(contact(x));
      return terms;
    };
  }

 private:
  const EditInput& input_;
  const std::vector<RelativePlace>& places_;
  const ContactRegion& contact_;
  std::vector<LimbAxis> axes_;
  StyleWeights weights_;
  double wanted_gap_;
  Eigen::VectorXd areas_;
  std::vector<const Handle*> handle_of_;  // what a vertex moves with; null when it is held
  Eigen::VectorXd release_;               // rho of E_fit
  std::vector<int> pushes_;               // rounds in which the vertex was found too near the body
  std::vector<SoftTerm> proportion_;
};

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

Slide slide_once(const EditInput& input, const std::vector<Handle>& handles, const std::vector<RelativePlace>& places,
                 const ContactRegion& contact, const std::vector<SourceTriangle>& triangles, const SlideOptions& options,
                 double in_plane_pull) {
  BodyTerms terms(input, handles, places, contact, triangles, options);
  StyleOptions style;
  style.in_plane_pull = in_plane_pull;
  HardConstraints hard = all_but_moving(input, handles);
  StyleSolution slid;
  // What a triangle's orientation is held against: its own in the source, or, where the garment has slid on itself, the
  // source's where it now lies.
  std::vector<SourceTriangle> reference = triangles;
  Eigen::Matrix3Xd shape = input.drape;
  const auto on_cloth = slid_on_cloth(input, handles, options.by);
  if (on_cloth && normal_deviation(triangles, input.drape, *on_cloth).flipped.empty()) {
    slid.positions = slid.initial = shape = *on_cloth;
    reference = source_triangles(shape, input.garment.triangles);
    if (options.by > 0) {  // cloth that was added may lie in the body
      for (const Handle& handle : handles)
        for (const int v : handle.loop) hard.hold_along(v, handle.axis, handle.axis.dot(shape.col(v)));
      slid = solve_style(shape, reference, hard, terms.all(), style);
    }
  } else {
    for (const Handle& handle : handles)
      for (const int v : handle.loop) hard.hold_along(v, handle.axis, handle.axis.dot(input.drape.col(v)) + options.by);
    slid = solve_style(scaled_along(input, handles, options.by), triangles, hard, terms.all(), style);
  }
  for (const Handle& handle : handles)
    for (const int v : handle.loop) hard.hold(v, slid.positions.col(v));
  const StyleSolution frozen = solve_style(slid.positions, reference, hard, terms.all(), style);

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

Slide slide_and_freeze(const EditInput& input, const std::vector<Handle>& handles, const std::vector<RelativePlace>& places,
                       const ContactRegion& contact, const SlideOptions& options) {
  const auto triangles = source_triangles(input.drape, input.garment.triangles);
  Slide best;
  for (const double in_plane_pull : {0.02, 0.1, 0.3}) {
    Slide slide = slide_once(input, handles, places, contact, triangles, options, in_plane_pull);
    const bool better = slide.deviation.flipped.empty();
    const bool enough = better && (slide.settled || in_plane_pull >= 0.1);
    if (better || best.positions.size() == 0) best = std::move(slide);
    if (enough) break;
  }
  return best;
}

}  // namespace toile
