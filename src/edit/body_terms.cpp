#include "edit/body_terms.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "parallel/threads.h"

namespace toile {
namespace {

constexpr double most_wanted_gap = 2e-3;  // m
constexpr double skin_slack = 1e-3;       // m, that skin under a vertex may slide farther than twice the vertex

// The terms of every vertex in order, found by several threads: `term_of` gives none or one.
template <class TermOf>
std::vector<SoftTerm> terms_of(Eigen::Index count, const TermOf& term_of) {
  constexpr int chunks = 8;
  std::vector<std::vector<SoftTerm>> parts(chunks);
  in_ranges(chunks, static_cast<int>(count), [&](int chunk, int begin, int end) {
    for (int v = begin; v < end; ++v)
      if (const std::optional<SoftTerm> term = term_of(v)) parts[static_cast<std::size_t>(chunk)].push_back(*term);
  });
  std::vector<SoftTerm> terms;
  for (const std::vector<SoftTerm>& part : parts) terms.insert(terms.end(), part.begin(), part.end());
  return terms;
}

}  // namespace

double contact_distance(const Eigen::VectorXd& gaps) {
  double sum = 0;
  int count = 0;
  for (const double gap : gaps) {
    if (gap >= most_wanted_gap) continue;
    sum += std::max(0.0, gap);
    ++count;
  }
  return count > 0 ? sum / count : most_wanted_gap;
}

BodyTerms::BodyTerms(const Body& body, const Eigen::VectorXd& areas, BodyWishes wishes)
    : body_(body),
      axes_(limb_axes(body.form)),
      weights_(style_weights(body.form.height)),
      areas_(areas),
      wishes_(std::move(wishes)),
      pushes_(wishes_.moves.size(), 0) {}

BodyTerms::SkinUnder BodyTerms::skin_under(Eigen::Index v, const Eigen::Vector3d& at) const {
  const auto i = static_cast<std::size_t>(v);
  if (!kept_skin_.empty() && !kept_skin_[i].any) return {};
  const int limb = wishes_.limb[i];
  const RelativePlace now = relative_place(body_, axes_[static_cast<std::size_t>(limb)], limb, at);
  SkinUnder under{now.through_skin, {now.on_skin, now.outward}, at};
  if (kept_skin_.empty()) return under;
  const SkinUnder& kept = kept_skin_[i];
  const double most = 2 * (at - kept.vertex).norm() + skin_slack;
  return under.any && (under.skin.at - kept.skin.at).norm() <= most ? under : kept;
}

void BodyTerms::keep_to_skin_at(const Eigen::Matrix3Xd& x) {
  kept_skin_.clear();
  std::vector<SkinUnder> found(static_cast<std::size_t>(x.cols()));
  in_ranges(8, static_cast<int>(x.cols()), [&](int, int begin, int end) {
    for (int v = begin; v < end; ++v)
      if (wishes_.release(v) > 0) found[static_cast<std::size_t>(v)] = skin_under(v, x.col(v));
  });
  kept_skin_ = std::move(found);
}

void BodyTerms::go_on_from(const BodyTerms& other) {
  kept_skin_ = other.kept_skin_;
  pushes_ = other.pushes_;
}

std::vector<SoftTerm> BodyTerms::fit(const Eigen::Matrix3Xd& x) const {
  return terms_of(x.cols(), [&](int v) -> std::optional<SoftTerm> {
    if (!(wishes_.release(v) > 0)) return std::nullopt;
    const double keep = wishes_.keep ? wishes_.keep(v, x.col(v)) : 1;
    if (!(keep > 0)) return std::nullopt;
    const SkinUnder now = skin_under(v, x.col(v));
    if (!now.any) return std::nullopt;
    return fit_term(v, now.skin, wishes_.offset(v), wishes_.release(v) * keep, areas_(v), weights_);
  });
}

std::vector<SoftTerm> BodyTerms::contact(const Eigen::Matrix3Xd& x) {
  return terms_of(x.cols(), [&](int i) -> std::optional<SoftTerm> {
    const auto v = static_cast<std::size_t>(i);
    if (!wishes_.moves[v]) return std::nullopt;
    const double least = wishes_.least(i);
    const DistanceSample sample = body_.distance.sample(x.col(i));
    if (sample.distance > least + (pushes_[v] > 0 ? 2e-4 : -1e-5)) return std::nullopt;
    if (sample.distance < least - 1e-4) ++pushes_[v];
    const double slope = std::max(1e-6, sample.gradient.norm());
    const Eigen::Vector3d outward = sample.gradient / slope;
    SoftTerm term = contact_term(i, {x.col(i) - outward * sample.distance / slope, outward}, least, areas_(i), weights_);
    term.weight *= std::pow(3.0, std::min(5, std::max(0, pushes_[v] - 1)));
    return term;
  });
}

SoftTermsAt BodyTerms::all() {
  return [this](const Eigen::Matrix3Xd& x, int round) {
    std::vector<SoftTerm> terms = wishes_.proportion;
    const auto append = [&](const std::vector<SoftTerm>& more) { terms.insert(terms.end(), more.begin(), more.end()); };
    append(fit(x));
    if (round > 0) append(contact(x));
    return terms;
  };
}

}  // namespace toile
