#include <algorithm>
#include <optional>

#include "cut/offset.h"

namespace toile {
namespace {

using Eigen::Vector2d;

struct OnHemLine {
  Vector2d at;
  double side_end = 0;
};

// Where `side`, lengthened, last goes through the hem line from the inside; `height` measures inwards from that line.
template <class Height>
std::optional<OnHemLine> last_through(const Line& side, const Vector2d& beyond, const Height& height) {
  const std::size_t n = side.size();
  for (std::size_t k = n; k-- > 0;) {
    const Vector2d& a = side[k].at;
    const Vector2d& b = k + 1 < n ? side[k + 1].at : beyond;
    const double above = height(a);
    const double below = height(b);
    if (above < -1e-12 || below >= 0) continue;
    const double t = above <= 0 ? 0 : above / (above - below);
    return OnHemLine{a + t * (b - a), static_cast<double>(k) + t};
  }
  return std::nullopt;
}

}  // namespace

std::optional<HemCorner> mirror_at_hem(const Line& side, const Vector2d& side_direction, const Line& hem,
                                       const Vector2d& corner, const Vector2d& along, const Vector2d& inside, double reach) {
  const auto height = [&](const Vector2d& p) { return inside.dot(p - corner); };
  const auto reflected = [&](const Vector2d& p) -> Vector2d { return p - 2 * height(p) * inside; };
  const auto turning = last_through(side, side.back().at + reach * side_direction, height);
  if (!turning || (turning->at - corner).norm() > reach) return std::nullopt;

  Line path{{.at = turning->at, .turn = true, .grade_rule = {}}};
  for (std::size_t k = std::min(side.size() - 1, static_cast<std::size_t>(turning->side_end) + 1); k-- > 0;) {
    OutlinePoint point = side[k];
    point.at = reflected(point.at);
    point.grade_rule.reset();
    if ((point.at - path.back().at).norm() < 1e-9) continue;
    path.push_back(point);
  }
  for (std::size_t i = 1; i < path.size(); ++i)
    for (std::size_t j = 0; j < hem.size(); ++j) {
      const Vector2d d = hem[j].at;
      const Vector2d c = j > 0 ? hem[j - 1].at : Vector2d(d - reach * along);
      const auto crossed = crossing(path[i - 1].at, path[i].at, c, d);
      if (!crossed) continue;
      const Vector2d end = c + crossed->second * (d - c);
      if ((end - corner).norm() > reach) return std::nullopt;
      HemCorner found;
      found.points.assign(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(i));
      found.points.push_back({.at = end, .turn = true, .grade_rule = {}});
      found.side_end = turning->side_end;
      found.hem_begin = static_cast<double>(j) - 1 + crossed->second;
      return found;
    }
  return std::nullopt;
}

}  // namespace toile
