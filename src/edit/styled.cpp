#include "edit/styled.h"

#include <algorithm>
#include <utility>

#include "style/mend_turned.h"

namespace toile {
namespace {

constexpr double most_uneven = 2;  // times as long, or as short

double unevenness(const NormalDeviation& deviation) {
  return std::max(deviation.most_stretch, 1 / std::max(1e-3, deviation.least_stretch));
}

// Where to go on from: a solution and the terms it ended with.
struct Followed {
  StyleReference style;
  BodyTerms terms;
};

void judge(Styled& shape, const Body& body, const std::vector<SourceTriangle>& reference, const Eigen::Matrix3Xd& source,
           const Eigen::VectorXd& gap) {
  shape.deviation = normal_deviation(reference, source, shape.positions);
  shape.deepest = 0;
  for (Eigen::Index v = 0; v < source.cols(); ++v)
    if (shape.positions.col(v) != source.col(v))
      shape.deepest = std::max(shape.deepest, std::min(0.0, gap(v)) - body.distance.distance(shape.positions.col(v)));
}

}  // namespace

bool is_even(const NormalDeviation& deviation) { return deviation.flipped.empty() && unevenness(deviation) < most_uneven; }

Styled styled(const Body& body, const BodyTerms& terms, const std::vector<SourceTriangle>& reference,
              const Eigen::Matrix3Xd& source, const Eigen::VectorXd& gap, const Eigen::Matrix3Xd& initial,
              const StyleSolution& solution) {
  Styled result;
  result.positions = solution.positions;
  result.settled = solution.settled;
  const auto energy = [&](const Eigen::Matrix3Xd& x) {
    return StyleTerms{tilt_energy(reference, x), soft_energy(terms.proportion(), x), soft_energy(terms.fit(x), x)};
  };
  result.before = energy(initial);
  result.after = energy(result.positions);
  judge(result, body, reference, source, gap);
  return result;
}

void mend(Styled& shape, const Body& body, const std::vector<SourceTriangle>& reference, const Eigen::Matrix3Xd& source,
          const Eigen::VectorXd& gap, const HardConstraints& hard) {
  if (shape.deviation.flipped.empty()) return;
  shape.positions = mend_turned(reference, source, shape.positions, hard);
  judge(shape, body, reference, source, gap);
}

bool is_better(const NormalDeviation& one, const NormalDeviation& other) {
  if (one.flipped.empty() != other.flipped.empty()) return one.flipped.empty();
  return unevenness(one) < unevenness(other);
}

Styled with_weakest_pull(const std::function<Styled(const StyleOptions&)>& solve, double least) {
  Styled best;
  for (const double pull : pulls) {
    if (pull < least) continue;
    StyleOptions options;
    options.in_plane_pull = pull;
    Styled result = solve(options);
    const bool enough = is_even(result.deviation) && (result.settled || pull >= 0.1);
    if (best.positions.size() == 0 || enough || is_better(result.deviation, best.deviation)) best = std::move(result);
    if (enough) break;
  }
  return best;
}

Styled restyled(const Restyling& restyling, EditMemory& memory, const std::string& name) {
  const auto judged = [&](const BodyTerms& terms, const StyleSolution& solution) {
    return styled(restyling.body, terms, restyling.triangles, restyling.source, restyling.gap, solution.initial, solution);
  };
  if (const Followed* before = memory.known<Followed>(name)) {
    BodyTerms terms = restyling.terms;
    terms.go_on_from(before->terms);
    const Styled followed = judged(
        terms, follow_style(before->style, restyling.guess, restyling.triangles, restyling.hard, terms.all(), &memory.style()));
    if (followed.deviation.flipped.empty()) return followed;
  }
  struct Attempt {
    StyleOptions options;
    StyleSolution solution;
    BodyTerms terms;
  };
  std::vector<Attempt> attempts;
  Styled best = with_weakest_pull([&](const StyleOptions& options) {
    BodyTerms terms = restyling.terms;
    StyleSolution solution =
        solve_style(restyling.guess, restyling.triangles, restyling.hard, terms.all(), options, &memory.style());
    const Styled result = judged(terms, solution);
    attempts.push_back({options, std::move(solution), std::move(terms)});
    return result;
  });
  if (!best.deviation.flipped.empty()) {
    mend(best, restyling.body, restyling.triangles, restyling.source, restyling.gap, restyling.hard);
    return best;
  }
  if (!memory.lasts()) return best;
  memory.once(name, [&] {
    const auto chosen = std::find_if(attempts.begin(), attempts.end(),
                                     [&](const Attempt& attempt) { return attempt.solution.positions == best.positions; });
    Followed followed{{}, chosen->terms};
    followed.terms.keep_to_skin_at(best.positions);
    BodyTerms terms = followed.terms;
    followed.style =
        style_reference(chosen->solution, restyling.triangles, restyling.hard, terms.all(), chosen->options, &memory.style());
    return followed;
  });
  return best;
}

}  // namespace toile
