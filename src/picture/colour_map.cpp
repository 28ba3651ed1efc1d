#include "picture/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/colour_space.h"

namespace toile {
namespace {

// OKLab: lightness falls in equal steps; hue goes from cream over orange and red to violet.
constexpr std::array<OkLab, 6> stops = {
    {{.95, .000, .035}, {.83, .045, .120}, {.71, .120, .110}, {.59, .170, .050}, {.47, .155, -.050}, {.35, .080, -.120}}};

// Both ways from nearly white, to red over orange and to blue over sky: told apart without red and green, too.
constexpr std::array<OkLab, 4> above = {{{.96, .000, .006}, {.81, .070, .070}, {.62, .160, .095}, {.42, .135, .060}}};
constexpr std::array<OkLab, 4> below = {{{.96, .000, .006}, {.81, -.035, -.065}, {.62, -.035, -.125}, {.42, -.010, -.145}}};

template <std::size_t count>
Colour between(const std::array<OkLab, count>& stops_at, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * (count - 1);
  const auto i = std::min(static_cast<std::size_t>(place), count - 2);
  const double s = place - static_cast<double>(i);
  const OkLab &a = stops_at[i], &b = stops_at[i + 1];
  return to_srgb({a.lightness + s * (b.lightness - a.lightness), a.a + s * (b.a - a.a), a.b + s * (b.b - a.b)});
}

constexpr Colour no_value{.5, .5, .5};

}  // namespace

Colour colour_map(double t) { return std::isnan(t) ? no_value : between(stops, t); }

Colour signed_colour_map(double t) { return std::isnan(t) ? no_value : t < 0 ? between(below, -t) : between(above, t); }

double round_top(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (value <= step * decade * (1 + 1e-9)) return step * decade;
  return 10 * decade;
}

std::vector<double> ticks(double top) {
  const double decade = std::pow(10, std::floor(std::log10(top)));
  double step = decade / 10;
  for (const double part : {0.2, 0.5, 1.0, 2.0})
    if (part * decade <= top / 4 * (1 + 1e-9)) step = part * decade;
  std::vector<double> values;
  for (int i = 0; i * step <= top * (1 + 1e-9); ++i) values.push_back(i * step);
  return values;
}

}  // namespace toile
