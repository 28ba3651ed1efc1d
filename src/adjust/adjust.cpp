#include "adjust/adjust.h"

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

#include "adjust/triangle_update.h"
#include "adjust/welded_seams.h"
#include "geometry/embed.h"
#include "geometry/triangle_shape.h"

namespace toile {
namespace {

using Clock = std::chrono::steady_clock;
using Shapes = std::vector<Eigen::Matrix2d>;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

Shapes draped_shapes(const GarmentMesh& garment, const Eigen::Matrix3Xd& at) {
  Shapes shapes;
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t)
    shapes.push_back(triangle_shape(Eigen::Vector3d(at.col(garment.triangles(0, t))), at.col(garment.triangles(1, t)),
                                    at.col(garment.triangles(2, t))));
  return shapes;
}

Embedder embedder_for(const GarmentMesh& garment, std::vector<MatingEdges> mating) {
  std::vector<FlatMesh> panels;
  for (const PanelMesh& panel : garment.panels) panels.push_back({panel.rest.cols(), panel.triangles});
  return Embedder(std::move(panels), std::move(mating), rest_triangles(garment));
}

struct Guess {
  RestShape rest;
  double distortion = 0;  // of the embedding
  int inverted = 0;
};

Guess lay_flat(const Embedder& embedder, const Shapes& shapes, const RestShape& start) {
  Embedding flat = embedder.embed(shapes, start);
  return {std::move(flat.panels), flat.mean_distortion, flat.inverted};
}

// Triangles of `from` moved by `gain` of Eq. 7 towards the goal; nearer steps when the whole one would fold the panels.
Guess next_guess(const Embedder& embedder, const GarmentMesh& garment, const RestShape& from, const Eigen::Matrix3Xd& drape,
                 const Shapes& goal, double gain) {
  const Shapes rest = rest_triangles(with_rest(garment, from));
  const Shapes draped = draped_shapes(garment, drape);
  for (int attempt = 0;; ++attempt, gain /= 2) {
    Shapes next;
    for (std::size_t t = 0; t < goal.size(); ++t) next.push_back(updated_rest(rest[t], draped[t], goal[t], gain));
    Guess guess = lay_flat(embedder, next, from);
    if (guess.inverted == 0 || attempt == 3) return guess;
  }
}

Guess uncompressed_guess(const Embedder& embedder, const Target& target, const Shapes& goal, const std::vector<bool>& eased) {
  const Shapes rest = rest_triangles(target.garment);
  const Shapes source = draped_shapes(target.garment, target.source);
  const std::vector<int> offsets = triangle_offsets(target.garment);
  Shapes start = goal;
  for (std::size_t p = 0; p < eased.size(); ++p)
    for (int t = offsets[p]; eased[p] && t < offsets[p + 1]; ++t) {
      const auto i = static_cast<std::size_t>(t);
      start[i] = without_compression(goal[i], rest[i], source[i]);
    }
  return lay_flat(embedder, start, rest_shape(target.garment));
}

// Whether the drape shows what its rest shape does, rather than where it was started.
bool came_to_rest(const Drape& drape, double tolerance) { return drape.settled || drape.residual <= 5 * tolerance; }

// Steps taken so far, with what each was cut and how it hangs.
class Adjuster {
 public:
  Adjuster(const Target& target, const Simulate& simulate, const MakeCuttable& make_cuttable, const AdjustOptions& options)
      : target_(target), simulate_(simulate), make_cuttable_(make_cuttable), options_(options) {
    const auto height = target.positions.row(1);
    if (height.size() > 0) slip_limit_ = options.slip_limit * (height.maxCoeff() - height.minCoeff());
  }

  // Drapes and measures one more step. `since`: when work on it began.
  void try_out(RestShape rest, double distortion, Clock::time_point since);
  AdjustStop iterate(const Embedder& embedder, const Shapes& goal, std::optional<Guess> first);
  Adjustment result(AdjustStop stop, Clock::time_point since) &&;

 private:
  struct Tried {
    RestShape rest;
    Drape drape;
    bool at_rest = false;
  };
  bool is_nearer(std::size_t k, std::size_t than) const {
    return tried_[k].at_rest != tried_[than].at_rest ? tried_[k].at_rest : steps_[k].hausdorff < steps_[than].hausdorff;
  }
  bool slipped(std::size_t k) const { return steps_[k].slipped > slip_limit_; }
  RestShape cuttable(const RestShape& rest) const { return make_cuttable_ ? make_cuttable_(rest) : rest; }

  const Target& target_;
  const Simulate& simulate_;
  const MakeCuttable& make_cuttable_;
  const AdjustOptions& options_;
  double slip_limit_ = 0;
  std::vector<AdjustStep> steps_;
  std::vector<Tried> tried_;
  std::size_t nearest_ = 0;  // of all steps: where the next one starts
  std::size_t best_ = 0;     // of those that can be cut, once there is one
};

void Adjuster::try_out(RestShape rest, double distortion, Clock::time_point since) {
  Drape drape = simulate_(with_rest(target_.garment, rest), target_.positions, options_.tolerance);
  AdjustStep step = measure(target_, rest, drape);
  step.embedding_distortion = distortion;
  step.seconds = seconds_since(since);
  const bool at_rest = came_to_rest(drape, options_.tolerance);
  steps_.push_back(step);
  tried_.push_back({std::move(rest), std::move(drape), at_rest});
  const std::size_t k = steps_.size() - 1;
  if (k > 0 && is_nearer(k, nearest_)) nearest_ = k;
  if (k > 0 && (best_ == 0 || is_nearer(k, best_))) best_ = k;
  if (options_.progress) options_.progress(step);
}

AdjustStop Adjuster::iterate(const Embedder& embedder, const Shapes& goal, std::optional<Guess> first) {
  double gain = 1;
  int failures = 0;
  AdjustStop stop = AdjustStop::step_limit;
  for (int taken = 0; taken < options_.most_steps && stop == AdjustStop::step_limit; ++taken) {
    const auto since = Clock::now();
    const bool independent = first.has_value();  // of the drapes so far
    const std::size_t from = nearest_;
    const Guess guess =
        first ? *std::exchange(first, std::nullopt)
              : next_guess(embedder, target_.garment, tried_[from].rest, tried_[from].drape.positions, goal, gain);
    try_out(cuttable(guess.rest), guess.distortion, since);
    const std::size_t k = steps_.size() - 1;
    const bool improved = nearest_ == k;
    if (tried_[best_].at_rest && steps_[best_].hausdorff <= options_.agreed_hausdorff) return AdjustStop::agreed;
    if (independent && !improved) continue;  // from the flattening then
    gain *= options_.damping;
    if (slipped(k))
      stop = slipped(best_) ? AdjustStop::slipped : AdjustStop::stalled;
    else if (improved && (tried_[k].at_rest != tried_[from].at_rest ||
                          steps_[k].hausdorff < options_.stalled_ratio * steps_[from].hausdorff ||
                          steps_[k].mean < options_.stalled_ratio * steps_[from].mean))
      failures = 0;
    else if (improved || ++failures == 2)
      stop = AdjustStop::stalled;
    else
      gain /= 2;
  }
  if (nearest_ == 0) {
    const auto since = Clock::now();
    try_out(cuttable(tried_[0].rest), steps_[0].embedding_distortion, since);
  }
  return slipped(best_) ? AdjustStop::slipped : stop;
}

Adjustment Adjuster::result(AdjustStop stop, Clock::time_point since) && {
  Adjustment result;
  result.flattened = tried_[0].rest;
  result.flattened_drape = tried_[0].drape;
  result.rest = std::move(tried_[best_].rest);
  result.drape = std::move(tried_[best_].drape);
  result.steps = std::move(steps_);
  result.best = static_cast<int>(best_);
  result.stop = stop;
  result.seconds = seconds_since(since);
  return result;
}

void check_sizes(const Target& target) {
  check(target.garment);
  if (target.positions.cols() != target.garment.vertex_count || !target.positions.allFinite())
    throw std::invalid_argument("adjust: the target needs one finite position per garment vertex");
  if (target.source.cols() != 0 && (target.source.cols() != target.garment.vertex_count || !target.source.allFinite()))
    throw std::invalid_argument("adjust: the source drape needs one finite position per garment vertex");
}

}  // namespace

Adjustment adjust(const Target& target, const Simulate& simulate, const MakeCuttable& make_cuttable,
                  const AdjustOptions& options) {
  const auto since = Clock::now();
  check_sizes(target);
  const GarmentMesh& garment = target.garment;
  const Shapes goal = draped_shapes(garment, target.positions);
  const std::vector<MatingEdges> mating = mating_edges(garment);
  const Embedder embedder = embedder_for(garment, mating);
  const RestShape source_rest = rest_shape(garment);

  // The target is welded, so plain flattening makes mating edges equally long, whatever their ratio should be.
  std::vector<MatingEdges> level = mating;
  for (MatingEdges& pair : level) pair.ratio = 1;
  Guess flattened = lay_flat(embedder_for(garment, std::move(level)), goal, source_rest);

  std::optional<Guess> first;
  double distortion = flattened.distortion;
  if (target.source.cols() > 0) {
    Guess from_source = next_guess(embedder, garment, source_rest, target.source, goal, 1);
    distortion = std::min(distortion, from_source.distortion);
    const std::vector<bool> eased = eased_panels(garment);
    if (options.start_from_source)
      first = std::move(from_source);
    else if (options.undo_compression && std::find(eased.begin(), eased.end(), true) != eased.end())
      first = uncompressed_guess(embedder, target, goal, eased);
  }

  Adjuster adjuster(target, simulate, make_cuttable, options);
  adjuster.try_out(std::move(flattened.rest), flattened.distortion, since);
  const AdjustStop stop =
      distortion > options.developable_limit ? AdjustStop::not_developable : adjuster.iterate(embedder, goal, std::move(first));
  return std::move(adjuster).result(stop, since);
}

}  // namespace toile
