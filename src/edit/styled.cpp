#include "edit/styled.h"

#include <algorithm>
#include <utility>

namespace toile {

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
  result.deviation = normal_deviation(reference, source, result.positions);
  for (Eigen::Index v = 0; v < source.cols(); ++v)
    if (result.positions.col(v) != source.col(v))
      result.deepest = std::max(result.deepest, std::min(0.0, gap(v)) - body.distance.distance(result.positions.col(v)));
  return result;
}

Styled with_weakest_pull(const std::function<Styled(const StyleOptions&)>& solve) {
  Styled best;
  for (const double pull : {0.02, 0.1, 0.3}) {
    StyleOptions options;
    options.in_plane_pull = pull;
    Styled result = solve(options);
    const bool whole = result.deviation.flipped.empty();
    const bool enough = whole && (result.settled || pull >= 0.1);
    if (whole || best.positions.size() == 0) best = std::move(result);
    if (enough) break;
  }
  return best;
}

}  // namespace toile
