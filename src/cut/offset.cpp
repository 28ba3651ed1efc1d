#include "cut/offset.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile {
namespace {

using Eigen::Vector2d;

OutlinePoint moved(OutlinePoint point, const Vector2d& to) {
  point.at = to;
  return point;
}

OutlinePoint corner_at(const Vector2d& at) { return {.at = at, .turn = true, .grade_rule = {}}; }

// Where the lines beside a bend, at widths a and b, are cut off at `far` from the bend, square to `tip`.
std::pair<Vector2d, Vector2d> bevel(const Vector2d& corner, const Vector2d& in, double a, const Vector2d& out, double b,
                                    const Vector2d& tip, double far) {
  const Vector2d foot_in = a * turned_right(in);
  const Vector2d foot_out = b * turned_right(out);
  const double s = (far - foot_in.dot(tip)) / in.dot(tip);
  const double t = (far - foot_out.dot(tip)) / out.dot(tip);
  return {corner + foot_in + s * in, corner + foot_out + t * out};
}

// Unit direction in which the mitre of a convex bend points.
Vector2d tip_direction(const Vector2d& in, double a, const Vector2d& out, double b) {
  const double sine = cross(in, out);
  if (std::abs(sine) < 1e-9) return in;
  const Vector2d tip = a * turned_right(in) + (b - a * in.dot(out)) / sine * in;
  return tip.norm() > 0 ? Vector2d(tip.normalized()) : in;
}

void add_bend(OffsetEdge& edge, std::size_t i, const Vector2d& in, const Vector2d& out, const AllowanceRules& rules) {
  const OutlinePoint& bend = edge.sew[i];
  const double w = edge.width;
  const Vector2d across = turned_right(in) + turned_right(out);
  const double cosine = in.dot(out);
  const bool convex = cross(in, out) > 0 || (cosine < 0 && std::abs(cross(in, out)) < 1e-12);
  const double tip = 1 + cosine > 1e-12 ? w * std::sqrt(2 / (1 + cosine)) : std::numeric_limits<double>::infinity();
  Polygon patch{bend.at, bend.at + w * turned_right(in)};
  if (convex && tip > rules.mitre_limit * w) {
    const auto [a, b] = bevel(bend.at, in, w, out, w, tip_direction(in, w, out, w), rules.mitre_limit * w);
    edge.cut.push_back(moved(bend, a));
    edge.cut.push_back(moved(bend, b));
    patch.insert(patch.end(), {a, b});
  } else {
    const double scale = 1 + cosine > 1e-12 ? w / (1 + cosine) : 0;
    edge.cut.push_back(moved(bend, bend.at + scale * across));
    patch.push_back(edge.cut.back().at);
  }
  patch.push_back(bend.at + w * turned_right(out));
  if (convex && w > 0) edge.patches.push_back(std::move(patch));
}

// The corner when one allowance is so much wider that its strip would be cut short by the other's line: a step at the corner.
Joint step(const OffsetEdge& in, const OffsetEdge& out, const Vector2d& corner, double turn) {
  Joint joint;
  const double cosine = in.last.dot(out.first);
  const Vector2d foot_in = in.cut.back().at;
  const Vector2d foot_out = out.cut.front().at;
  joint.in_end = static_cast<double>(in.cut.size()) - 1;
  if (turn >= 0) {
    joint.points = {corner_at(foot_in), corner_at(foot_out)};
    joint.patches.push_back({corner, foot_in, foot_out});
    return joint;
  }
  const bool wider_out = out.width * cosine > in.width;
  const Line wall = wider_out ? Line{corner_at(corner), corner_at(foot_out)} : Line{corner_at(foot_in), corner_at(corner)};
  const auto met = wider_out ? meet(in.cut, in.last, wall, turned_right(out.first), corner, 0)
                             : meet(wall, -turned_right(in.last), out.cut, out.first, corner, 0);
  joint.meets = met.has_value() || (wider_out ? in.width : out.width) == 0;
  if (wider_out) {
    joint.points = {corner_at(met ? met->at : corner), corner_at(foot_out)};
    if (met) joint.in_end = met->in_end;
  } else {
    joint.points = {corner_at(foot_in), corner_at(met ? met->at : corner)};
    if (met) joint.out_begin = met->out_begin;
  }
  return joint;
}

std::optional<Joint> hem_joint(const OffsetEdge& in, const OffsetEdge& out, const Vector2d& corner, double reach) {
  const bool hem_out = out.hem;
  const OffsetEdge& hem = hem_out ? out : in;
  Line side = hem_out ? in.cut : out.cut;
  Line hem_line = hem.cut;
  if (!hem_out) {
    std::reverse(side.begin(), side.end());
    std::reverse(hem_line.begin(), hem_line.end());
  }
  const Vector2d side_direction = hem_out ? in.last : Vector2d(-out.first);
  const Vector2d along = hem_out ? out.first : Vector2d(-in.last);
  const Vector2d inside = -turned_right(hem_out ? out.first : in.last);
  auto found = mirror_at_hem(side, side_direction, hem_line, corner, along, inside, reach);
  if (!found) return std::nullopt;
  const double side_last = static_cast<double>(side.size()) - 1;
  const double hem_last = static_cast<double>(hem_line.size()) - 1;
  const Vector2d foot_side = side.back().at;
  Polygon patch{corner};
  if (found->side_end > side_last) patch.push_back(foot_side);
  for (const OutlinePoint& point : found->points) patch.push_back(point.at);
  if (found->hem_begin < 0) patch.push_back(hem_line.front().at);
  Joint joint;
  joint.patches.push_back(std::move(patch));
  const bool hem_cut_short = found->hem_begin > 0 && found->hem_begin < 1;
  const Vector2d end = found->points.back().at;
  if (!hem_out) std::reverse(found->points.begin(), found->points.end());
  joint.points = std::move(found->points);
  joint.in_end = hem_out ? found->side_end : hem_last - found->hem_begin;
  joint.out_begin = hem_out ? found->hem_begin : side_last - found->side_end;
  if (hem_cut_short) (hem_out ? joint.out_trimmed : joint.in_trimmed) = end;
  return joint;
}

}  // namespace

OffsetEdge offset_edge(Line sew, double width, const AllowanceRules& rules) {
  OffsetEdge edge;
  edge.width = width;
  edge.sew = std::move(sew);
  std::vector<Vector2d> directions;
  for (std::size_t i = 1; i < edge.sew.size(); ++i) directions.push_back((edge.sew[i].at - edge.sew[i - 1].at).normalized());
  edge.first = directions.front();
  edge.last = directions.back();
  edge.cut.push_back(moved(edge.sew.front(), edge.sew.front().at + width * turned_right(edge.first)));
  for (std::size_t i = 1; i + 1 < edge.sew.size(); ++i) add_bend(edge, i, directions[i - 1], directions[i], rules);
  edge.cut.push_back(moved(edge.sew.back(), edge.sew.back().at + width * turned_right(edge.last)));
  return edge;
}

Joint join(const OffsetEdge& in, const OffsetEdge& out, const AllowanceRules& rules) {
  const OutlinePoint& end = in.sew.back();
  const OutlinePoint& start = out.sew.front();
  const Vector2d corner = end.at;
  const double wider = std::max(in.width, out.width);
  const double sine = cross(in.last, out.first);
  const double cosine = in.last.dot(out.first);
  const double turn = std::abs(sine) < 1e-12 && cosine < 0 ? 1 : sine;
  const double far = rules.mitre_limit * wider;
  const Vector2d foot_in = in.cut.back().at;
  const Vector2d foot_out = out.cut.front().at;

  Joint joint;
  joint.in_end = static_cast<double>(in.cut.size()) - 1;
  if ((foot_in - foot_out).norm() < 1e-7) {
    OutlinePoint single = end;
    single.at = (foot_in + foot_out) / 2;
    single.turn = end.turn || start.turn;
    joint.points = {single};
    return joint;
  }
  if (in.hem != out.hem && (in.hem ? in.width : out.width) > 0 && turn > 0.1 && rules.hem_corner == Corner::mirrored)
    if (auto mirrored = hem_joint(in, out, corner, far)) return *std::move(mirrored);

  const bool on_fold = in.width == 0 || out.width == 0;
  const bool uneven = out.width * cosine > in.width + 1e-9 || in.width * cosine > out.width + 1e-9;
  if (uneven && (turn < 0 || !on_fold)) return step(in, out, corner, turn);

  const auto met = meet(in.cut, in.last, out.cut, out.first, corner, turn > 0 ? 2 * far : 0);
  const double tip = met ? (met->at - corner).norm() : std::numeric_limits<double>::infinity();
  const bool blunt = rules.corner == Corner::bevel && turn > 0 && !on_fold && tip > wider + 1e-9;
  if (met && !blunt && (turn < 0 || tip <= far)) {
    OutlinePoint single = end;
    single.at = met->at;
    single.turn = end.turn || start.turn;
    joint.points = {single};
    joint.in_end = met->in_end;
    joint.out_begin = met->out_begin;
    if (turn > 0) joint.patches.push_back({corner, foot_in, met->at, foot_out});
    if (turn > 0 && met->out_begin > 0 && met->out_begin < 1) joint.out_trimmed = met->at;
    const double last = static_cast<double>(in.cut.size()) - 1;
    if (turn > 0 && met->in_end > last - 1 && met->in_end < last) joint.in_trimmed = met->at;
    return joint;
  }
  if (turn > 0) {
    if (on_fold && cosine > 0) return step(in, out, corner, turn);
    const auto [a, b] = bevel(corner, in.last, in.width, out.first, out.width,
                              tip_direction(in.last, in.width, out.first, out.width), blunt ? wider : far);
    joint.points = {corner_at(a), corner_at(b)};
    joint.patches.push_back({corner, foot_in, a, b, foot_out});
    joint.in_end += 1;
    joint.out_begin -= 1;
    return joint;
  }
  joint.points = {corner_at(foot_in), corner_at(corner), corner_at(foot_out)};
  joint.meets = false;
  return joint;
}

std::optional<Meeting> meet(const Line& in, const Vector2d& in_direction, const Line& out, const Vector2d& out_direction,
                            const Vector2d& corner, double reach) {
  const std::size_t n = in.size();
  std::optional<Meeting> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d a = in[i].at;
    const Vector2d b = i + 1 < n ? in[i + 1].at : Vector2d(a + reach * in_direction);
    for (std::size_t j = 0; j < out.size(); ++j) {
      const Vector2d d = out[j].at;
      const Vector2d c = j > 0 ? out[j - 1].at : Vector2d(d - reach * out_direction);
      const auto crossed = crossing(a, b, c, d);
      if (!crossed) continue;
      const Vector2d at = a + crossed->first * (b - a);
      if ((at - corner).norm() >= nearest) continue;
      nearest = (at - corner).norm();
      best = Meeting{at, static_cast<double>(i) + crossed->first, static_cast<double>(j) - 1 + crossed->second};
    }
  }
  return best;
}

}  // namespace toile
