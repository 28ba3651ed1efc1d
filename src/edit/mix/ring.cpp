#include "edit/mix/ring.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "edit/mix/hanging.h"
#include "edit/mix/limb_curve.h"
#include "garment/units.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

constexpr double turn = 2 * std::numbers::pi;

double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto next = std::upper_bound(x.begin() + 1, x.end() - 1, at) - x.begin();
  const auto i = static_cast<std::size_t>(next);
  const double t = x[i] > x[i - 1] ? (at - x[i - 1]) / (x[i] - x[i - 1]) : 0;
  return y[i - 1] + t * (y[i] - y[i - 1]);
}

// The nearest growing sequence (pool adjacent violators), with a little of the even one so that it grows everywhere.
std::vector<double> growing(const std::vector<double>& values) {
  constexpr double even = 0.02;
  std::vector<std::pair<double, int>> pools;
  for (const double value : values) {
    pools.emplace_back(value, 1);
    while (pools.size() > 1 && pools[pools.size() - 2].first > pools.back().first) {
      const auto [mean, count] = pools.back();
      pools.pop_back();
      auto& [before, number] = pools.back();
      before = (before * number + mean * count) / (number + count);
      number += count;
    }
  }
  std::vector<double> result;
  for (const auto& [mean, count] : pools) result.insert(result.end(), static_cast<std::size_t>(count), mean);
  const double first = result.front(), last = first + turn;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = (1 - even) * std::min(result[i], last) +
                even * (first + turn * static_cast<double>(i) / static_cast<double>(result.size() - 1));
  return result;
}

double wrapped(double value, double length) {
  value = std::fmod(value, length);
  return value < 0 ? value + length : value;
}

double apart(double a, double b, double length) {
  const double d = wrapped(a - b, length);
  return std::min(d, length - d);
}

}  // namespace

double Ring::angle_at(double at) const { return interpolated(along, angle, wrapped(at, length())); }

double Ring::at_angle(double value) const {
  return wrapped(interpolated(angle, along, angle.front() + wrapped(value - angle.front(), turn)), length());
}

Ring make_ring(const EditInput& input, const Part& part, std::size_t loop, int limb, const std::string& place) {
  constexpr double step = 5e-3, closed = 30e-3;  // m
  const auto axes = trunk_and_limbs(input.body.form);
  Ring ring;
  ring.spans = part.rings[loop];
  std::vector<Eigen::Vector3d> points;
  std::vector<double> along;
  double gap = 0;
  const auto sample = [&] {
    points.clear();
    along.clear();
    ring.starts.assign(1, 0);
    gap = 0;
    for (const EdgeSpan& span : ring.spans) {
      const Piece& piece = *find_piece(part.pattern, span.piece);
      const auto index = static_cast<std::size_t>(&piece - part.pattern.pieces.data());
      const auto panel = static_cast<std::size_t>(part.panels[index][static_cast<std::size_t>(span.copy - 1)]);
      const HangingPanel hanging(input.garment.panels[panel], input.garment.welded[panel], input.drape);
      const auto edge = positions(*find_edge(piece, span.edge));
      const double length = span_length(part.pattern, span);
      const int parts = std::max(2, static_cast<int>(std::ceil(length / step)));
      for (int i = 0; i <= parts; ++i) {
        Eigen::Vector2d at = point_at<2>(edge, span.begin + (span.end - span.begin) * i / parts);
        if (input.garment.panels[panel].mirrored) at.x() = -at.x();
        const Eigen::Vector3d here = hanging.at(at);
        if (i == 0 && !points.empty()) gap = std::max(gap, (points.back() - here).norm());
        points.push_back(here);
        along.push_back(ring.starts.back() + length * i / parts);
      }
      ring.starts.push_back(ring.starts.back() + length);
    }
  };
  sample();
  if (!points.empty()) gap = std::max(gap, (points.back() - points.front()).norm());
  if (points.empty() || gap > closed)
    throw BadInput({"edit.open-loop", Severity::error, place,
                    points.empty() ? "nothing of the garment is open along that loop on the side that is kept"
                                   : "what is open along that loop is not one closed line: a gap of " + in_mm(gap, 0),
                    "choose a loop that is sewn or closed all the way round"});
  std::vector<double> angle;
  const auto measure = [&] {
    angle.clear();
    for (const Eigen::Vector3d& point : points) {
      double value = limb_place(input.body, axes[static_cast<std::size_t>(limb)], limb, point).angle;
      if (!angle.empty()) value += turn * std::round((angle.back() - value) / turn);
      angle.push_back(value);
    }
  };
  measure();
  const double around = angle.back() - angle.front();
  if (std::abs(std::abs(around) - turn) > turn / 2)
    throw BadInput({"edit.not-round-limb", Severity::error, place, "that loop does not go once round a limb of the body",
                    "choose a loop round the trunk, an arm or a leg"});
  if (around < 0) {
    std::reverse(ring.spans.begin(), ring.spans.end());
    for (EdgeSpan& span : ring.spans) std::swap(span.begin, span.end);
    sample();
    measure();
  }
  ring.along = along;
  angle.back() = angle.front() + turn;
  ring.angle = growing(angle);
  return ring;
}

std::vector<RingMatch> match(const Ring& a, const Ring& b, double meet) {
  const double la = a.length(), lb = b.length();
  const auto to_b = [&](double at) { return b.at_angle(a.angle_at(at)); };
  const auto to_a = [&](double at) { return a.at_angle(b.angle_at(at)); };
  struct Knot {
    double a, b;
  };
  std::vector<Knot> knots;
  const auto nearest = [&](const Ring& ring, double at) {
    double best = ring.starts[0];
    for (std::size_t i = 0; i < ring.spans.size(); ++i)
      if (apart(ring.starts[i], at, ring.length()) < apart(best, at, ring.length())) best = ring.starts[i];
    return best;
  };
  for (std::size_t i = 0; i < a.spans.size(); ++i) {
    const double own = a.starts[i], other = nearest(b, to_b(own));
    if (apart(other, to_b(own), lb) < meet && nearest(a, to_a(other)) == own) knots.push_back({own, other});
  }
  // Far from such meetings the angle round the limb decides.
  const std::vector<Knot> met = knots;
  for (int k = 0; k < 8; ++k) {
    const double at = a.at_angle(k * turn / 8);
    if (std::all_of(met.begin(), met.end(), [&](const Knot& knot) { return apart(knot.a, at, la) > 0.3 * la; }))
      knots.push_back({at, to_b(at)});
  }
  std::sort(knots.begin(), knots.end(), [](const Knot& x, const Knot& y) { return x.a < y.a; });
  // Both sides in the same order.
  std::vector<Knot> ordered;
  for (const Knot& knot : knots) {
    const double since = ordered.empty() ? 0 : wrapped(knot.b - ordered.front().b, lb);
    if (!ordered.empty() && since <= wrapped(ordered.back().b - ordered.front().b, lb)) continue;
    ordered.push_back(knot);
  }
  std::vector<double> ka, kb;  // from the first knot on
  for (const Knot& knot : ordered) {
    ka.push_back(knot.a - ordered.front().a);
    kb.push_back(wrapped(knot.b - ordered.front().b, lb));
  }
  ka.push_back(la);
  kb.push_back(lb);
  std::vector<std::pair<double, double>> stops;
  for (std::size_t i = 0; i < a.spans.size(); ++i) {
    const double at = wrapped(a.starts[i] - ordered.front().a, la);
    stops.emplace_back(at, interpolated(ka, kb, at));
  }
  for (std::size_t i = 0; i < b.spans.size(); ++i) {
    const double at = wrapped(b.starts[i] - ordered.front().b, lb);
    stops.emplace_back(interpolated(kb, ka, at), at);
  }
  std::sort(stops.begin(), stops.end());
  std::vector<std::pair<double, double>> apart_stops;
  for (const auto& stop : stops)
    if (apart_stops.empty() || stop.first - apart_stops.back().first > 1e-6 * la) apart_stops.push_back(stop);
  std::vector<RingMatch> matches;
  for (std::size_t i = 0; i < apart_stops.size(); ++i) {
    const auto [a0, b0] = apart_stops[i];
    auto [a1, b1] = apart_stops[(i + 1) % apart_stops.size()];
    if (i + 1 == apart_stops.size()) {
      a1 += la;
      b1 += lb;
    }
    if (a1 - a0 < 1e-6 * la) continue;
    matches.push_back({ordered.front().a + a0, ordered.front().a + a1, ordered.front().b + b0, ordered.front().b + b1});
  }
  return matches;
}

EdgeSpan span_of(const Ring& ring, double begin, double end) {
  const double middle = wrapped((begin + end) / 2, ring.length());
  std::size_t i = 0;
  while (i + 1 < ring.spans.size() && ring.starts[i + 1] <= middle) ++i;
  EdgeSpan span = ring.spans[i];
  const double size = ring.starts[i + 1] - ring.starts[i], shift = middle - (begin + end) / 2;
  const auto at = [&](double along) {
    double share = std::clamp((along + shift - ring.starts[i]) / size, 0.0, 1.0);
    if (share < 1e-6) share = 0;
    if (share > 1 - 1e-6) share = 1;
    return ring.spans[i].begin + share * (ring.spans[i].end - ring.spans[i].begin);
  };
  span.begin = at(begin);
  span.end = at(end);
  return span;
}

}  // namespace toile
