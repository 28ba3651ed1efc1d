#include "picture/plot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "picture/canvas.h"
#include "picture/page.h"

namespace toile {
namespace {

constexpr double left = 90, right = 320, top = 60, bottom = 60;  // pixels round the field
constexpr int height = 560;

// Told apart by colour-blind readers too (Okabe and Ito 2008), again with a thinner line beyond eight.
constexpr Colour palette[] = {{0, .45, .70},   {.84, .37, 0}, {0, .62, .45},   {.80, .47, .65},
                              {.34, .71, .91}, {.90, .62, 0}, {.35, .35, .35}, {.94, .89, .26}};

// Steps of 1, 2 or 5 times a power of ten, about `count` of them.
double round_step(double range, int count) {
  const double rough = range / count, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10 * power;
}

}  // namespace

Image line_plot(const LinePlot& plot) {
  std::size_t longest = 0;
  double least = 0, most = 0;
  bool any = false;
  for (const Series& series : plot.series)
    for (const double value : series.values) {
      if (!std::isfinite(value)) throw std::invalid_argument("plot: '" + series.name + "' has a figure that is not finite");
      least = any ? std::min(least, value) : value;
      most = any ? std::max(most, value) : value;
      any = true;
      longest = std::max(longest, series.values.size());
    }
  if (!any) throw std::invalid_argument("plot: nothing to show");
  const double step = round_step(std::max(most - least, 1e-9 + 1e-3 * std::abs(most)), 6);
  const double low = std::floor(least / step) * step, high = std::max(std::ceil(most / step) * step, low + step);
  const double last = std::max<double>(1, static_cast<double>(longest) - 1);
  const auto at = [&](double across, double up) {
    return Eigen::Vector2d(left + across / last * (page_width - left - right),
                           height - bottom - (up - low) / (high - low) * (height - top - bottom));
  };

  Canvas canvas(blank_image(page_width, height));
  const Colour grey{.8, .8, .8};
  canvas.words(plot.title, {left, 32}, 18, {.1, .1, .1}, Align::left, true);
  canvas.words(plot.up, {left, 52}, 13);
  for (double up = low; up <= high + step / 2; up += step) {
    canvas.line({at(0, up), at(last, up)}, grey, 1);
    canvas.words(figure_words(up, step), at(0, up) + Eigen::Vector2d(-8, 5), 13, {.1, .1, .1}, Align::right);
  }
  for (int across = 0; across <= static_cast<int>(last); ++across)
    canvas.words(std::to_string(across), at(across, low) + Eigen::Vector2d(0, 20), 13, {.1, .1, .1}, Align::centre);
  canvas.words(plot.across, at(last / 2, low) + Eigen::Vector2d(0, 44), 13, {.1, .1, .1}, Align::centre);
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    const Series& series = plot.series[s];
    const Colour& colour = palette[s % std::size(palette)];
    const double width = s < std::size(palette) ? 2.5 : 1.2;
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i < series.values.size(); ++i) points.push_back(at(static_cast<double>(i), series.values[i]));
    if (points.size() > 1) canvas.line(points, colour, width);
    for (const Eigen::Vector2d& point : points) {
      const double r = width + 1.5;
      canvas.fill({point + Eigen::Vector2d(-r, -r), point + Eigen::Vector2d(r, -r), point + Eigen::Vector2d(r, r),
                   point + Eigen::Vector2d(-r, r)},
                  colour);
    }
    const double y = top + 10 + 22 * static_cast<double>(s);
    canvas.line({{page_width - right + 20, y}, {page_width - right + 50, y}}, colour, width);
    canvas.words(series.name, {page_width - right + 58, y + 5}, 13);
  }
  return canvas.image();
}

}  // namespace toile
