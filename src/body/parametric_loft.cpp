#include "body/parametric_loft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace toile {
namespace {

constexpr int samples = 600;

// Fritsch and Carlson's monotone slopes in Butland's weighted harmonic form, one-sided at the ends.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> chord(n - 1), slope(n);
  for (std::size_t i = 0; i + 1 < n; ++i) chord[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  if (n == 2) return {chord[0], chord[0]};
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (chord[i - 1] * chord[i] <= 0) continue;
    const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
    const double w0 = 2 * after + before, w1 = after + 2 * before;
    slope[i] = (w0 + w1) / (w0 / chord[i - 1] + w1 / chord[i]);
  }
  const auto end_slope = [](double h0, double h1, double c0, double c1) {
    const double s = ((2 * h0 + h1) * c0 - h0 * c1) / (h0 + h1);
    if (s * c0 <= 0) return 0.0;
    return c0 * c1 <= 0 && std::abs(s) > 3 * std::abs(c0) ? 3 * c0 : s;
  };
  slope[0] = end_slope(x[1] - x[0], x[2] - x[1], chord[0], chord[1]);
  slope[n - 1] = end_slope(x[n - 1] - x[n - 2], x[n - 2] - x[n - 3], chord[n - 2], chord[n - 3]);
  return slope;
}

double hermite(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& slope, double at) {
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  const auto i = static_cast<std::size_t>(above - x.begin()) - 1;
  const double h = x[i + 1] - x[i], t = (at - x[i]) / h, r = 1 - t;
  return (1 + 2 * t) * r * r * y[i] + t * r * r * h * slope[i] + t * t * (3 - 2 * t) * y[i + 1] - t * t * r * h * slope[i + 1];
}

}  // namespace

double section_girth(const Section& s) {
  constexpr int steps = 256;  // per quarter
  double sum = 0;
  for (const auto& [reach, exponent] : {std::pair{s.front, s.front_exponent}, std::pair{s.back, s.back_exponent}}) {
    double x0 = s.half_width, z0 = 0;
    for (int i = 1; i <= steps; ++i) {
      const double t = std::numbers::pi / 2 * i / steps;
      const double x1 = i == steps ? 0 : s.half_width * std::pow(std::cos(t), 2 / exponent);
      const double z1 = reach * std::pow(std::sin(t), 2 / exponent);
      sum += 2 * std::hypot(x1 - x0, z1 - z0);
      x0 = x1, z0 = z1;
    }
  }
  return sum;
}

Section scaled(const Section& section, double factor) {
  Section result = section;
  result.half_width *= factor, result.front *= factor, result.back *= factor;
  result.centre_v += (1 - factor) * (section.front - section.back) / 2;
  return result;
}

Loft::Loft(const LoftFrame& frame, const std::vector<LoftKnot>& knots, double first_cap, double last_cap, double softness,
           double clear)
    : frame_(frame), first_cap_(first_cap), last_cap_(last_cap) {
  if (knots.size() < 2) throw std::invalid_argument("a loft needs at least two knots");
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (!(knots[i].at > knots[i - 1].at)) throw std::invalid_argument("loft knots must ascend");
  begin_ = knots.front().at, end_ = knots.back().at;
  step_ = (end_ - begin_) / (samples - 1);
  rows_.resize(samples);
  std::vector<double> x, y(knots.size());
  for (const LoftKnot& knot : knots) x.push_back(knot.at);
  for (int channel = 0; channel < channels; ++channel) {
    for (std::size_t i = 0; i < knots.size(); ++i) {
      const Section& s = knots[i].section;
      y[i] = std::array{s.centre_u, s.centre_v, s.half_width, s.front, s.back, s.front_exponent, s.back_exponent}
          [static_cast<std::size_t>(channel)];
    }
    const std::vector<double> slope = monotone_slopes(x, y);
    for (int i = 0; i < samples; ++i)
      rows_[static_cast<std::size_t>(i)](channel) = hermite(x, y, slope, std::min(begin_ + i * step_, end_));
  }
  const auto keep_clear = [&] {
    if (clear >= 0)
      for (Row& r : rows_) r(0) = std::max(r(0), r(2) + clear);
  };
  keep_clear();
  if (softness > 0) soften(softness);
  keep_clear();
}

void Loft::soften(double softness) {
  const double sigma = softness / step_;
  const int reach = static_cast<int>(3 * sigma);
  // Beyond the ends the rows go on point-symmetrically, so that the ends stay.
  const auto extended = [&](int i) -> Row {
    const auto at = [&](int k) -> const Row& { return rows_[static_cast<std::size_t>(std::clamp(k, 0, samples - 1))]; };
    if (i < 0) return 2 * at(0) - at(-i);
    if (i >= samples) return 2 * at(samples - 1) - at(2 * (samples - 1) - i);
    return at(i);
  };
  std::vector<Row> soft;
  for (int i = 0; i < samples; ++i) {
    Row sum = Row::Zero();
    double weights = 0;
    for (int k = -reach; k <= reach; ++k) {
      const double weight = std::exp(-.5 * k * k / (sigma * sigma));
      sum += weight * extended(i + k);
      weights += weight;
    }
    soft.emplace_back(sum / weights);
  }
  rows_ = std::move(soft);
}

Loft::Row Loft::row(double at, Row* slope) const {
  const double place = std::clamp((at - begin_) / step_, 0.0, samples - 1.0);
  const auto i = static_cast<std::size_t>(std::min(place, samples - 1.5));
  const Row change = rows_[i + 1] - rows_[i];
  if (slope) *slope = at < begin_ || at > end_ ? Row(Row::Zero()) : Row(change / step_);
  return rows_[i] + (place - static_cast<double>(i)) * change;
}

Section Loft::section(double at) const {
  const Row r = row(at, nullptr);
  return {r(0), r(1), r(2), r(3), r(4), r(5), r(6)};
}

Eigen::Vector3d Loft::centre(double at) const {
  const Section s = section(at);
  return frame_.origin + s.centre_u * frame_.u + s.centre_v * frame_.v + at * frame_.along;
}

FormSample Loft::sample(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d offset = point - frame_.origin;
  const double t = frame_.along.dot(offset);
  Row slope;
  const Row r = row(t, &slope);
  const double du = frame_.u.dot(offset) - r(0), dv = frame_.v.dot(offset) - r(1);
  const double side_u = du >= 0 ? 1 : -1, side_v = dv >= 0 ? 1 : -1;
  const int half = dv >= 0 ? 3 : 4;
  const double a = r(2), b = r(half), n = r(half + 2);
  const double u = std::abs(du) / a, v = std::abs(dv) / b;
  double gauge = 0, by_u = 0, by_v = 0;  // (u^n + v^n)^(1/n) and its derivatives
  if (const double large = std::max(u, v), small = std::min(u, v); large > 1e-9) {
    const double ratio = n == 2 ? small * small / (large * large) : std::pow(small / large, n);
    gauge = large * (n == 2 ? std::sqrt(1 + ratio) : std::pow(1 + ratio, 1 / n));
    const double share = 1 / (1 + ratio);  // of the larger one in gauge^n
    const double by_large = gauge * share / large, by_small = small > 1e-9 ? gauge * (1 - share) / small : 0;
    by_u = u >= v ? by_large : by_small, by_v = u >= v ? by_small : by_large;
  }
  by_u *= side_u / a, by_v *= side_v / b;
  double by_t = -by_u * (slope(0) + du / a * slope(2)) - by_v * (slope(1) + dv / b * slope(half));
  double cap = 0, by_cap = 0;
  if (first_cap_ > 0 && t < begin_ + first_cap_) cap = (begin_ + first_cap_ - t) / first_cap_, by_cap = -1 / first_cap_;
  if (last_cap_ > 0 && t > end_ - last_cap_) cap = (t - end_ + last_cap_) / last_cap_, by_cap = 1 / last_cap_;
  if (cap > 0) {
    const double whole = std::hypot(gauge, cap);
    by_u *= gauge / whole, by_v *= gauge / whole;
    by_t = (gauge * by_t + cap * by_cap) / whole;
    gauge = whole;
  }
  const double steepness = std::hypot(by_u, by_v, by_t);
  if (steepness < 1e-9) return {-std::min(a, b), Eigen::Vector3d::Zero()};
  return {(gauge - 1) / steepness, (by_u * frame_.u + by_v * frame_.v + by_t * frame_.along) / steepness};
}

FormSample united(const FormSample& a, const FormSample& b, double blend) {
  const double overlap = std::max(blend - std::abs(a.distance - b.distance), 0.0) / blend;
  const bool first = a.distance <= b.distance;
  const FormSample &near = first ? a : b, &far = first ? b : a;
  const double share = overlap / 2;  // of the farther one
  return {near.distance - overlap * overlap * blend / 4, (1 - share) * near.gradient + share * far.gradient};
}

FormSample intersected(const FormSample& a, const FormSample& b, double blend) {
  const FormSample both = united({-a.distance, -a.gradient}, {-b.distance, -b.gradient}, blend);
  return {-both.distance, -both.gradient};
}

}  // namespace toile
