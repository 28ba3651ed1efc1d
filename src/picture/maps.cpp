#include "picture/maps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "picture/page.h"

namespace toile {
namespace {

Colour colour_of(double value, const MapScale& scale) {
  return scale.low < 0 ? signed_colour_map(value / scale.high) : colour_map(value / scale.high);
}

// The scale's ends are not the map's: what lies beyond them is said.
std::string extent_words(const GarmentMap& map, double step) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double value : map.values)
    if (std::isfinite(value)) least = std::min(least, value), most = std::max(most, value);
  if (least > most) return "no values";
  return "here from " + figure_words(least / map.unit_size, step) + " to " + figure_words(most / map.unit_size, step) + " " +
         map.unit;
}

}  // namespace

MapScale map_scale(const std::vector<GarmentMap>& maps) {
  if (maps.empty()) throw std::invalid_argument("map_scale: no map");
  std::vector<double> sizes;
  MapScale scale;
  double least = 0, most = std::numeric_limits<double>::infinity();
  const double unit = maps.front().unit_size;
  for (const GarmentMap& map : maps) {
    if (map.unit_size != unit) throw std::invalid_argument("map_scale: maps of different units");
    least = std::max(least, map.least_top);
    most = std::min(most, map.most_top);
    if (map.is_signed) scale.low = -1;
    for (const double value : map.values)
      if (std::isfinite(value)) sizes.push_back(std::abs(value));
  }
  double covered = 0;
  if (!sizes.empty()) {
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), at, sizes.end());
    covered = *at;
  }
  scale.high = round_top(std::max(least, std::min(covered, most)) / unit) * unit;
  scale.low *= scale.high;
  return scale;
}

ColouredMap coloured(GarmentMap map, const MapScale& scale) {
  if (!(scale.high > 0)) throw std::invalid_argument("coloured: the scale ends at 0");
  ColouredMap made{std::move(map), scale, {}};
  made.colours.resize(3, made.map.values.size());
  for (Eigen::Index i = 0; i < made.map.values.size(); ++i) {
    const Colour colour = colour_of(made.map.values(i), scale);
    made.colours.col(i) << colour.red, colour.green, colour.blue;
  }
  return made;
}

Image map_picture(const Showing& showing, const Eigen::Matrix3Xd& positions, const ColouredMap& map, const std::string& title,
                  int width) {
  const GarmentMesh& garment = showing.garment;
  const Eigen::Index count = map.map.of == MapOf::triangle ? garment.triangles.cols() : garment.vertex_count;
  if (map.map.values.size() != count || map.colours.cols() != count)
    throw std::invalid_argument("map_picture: '" + map.map.name + "' is of another garment");
  if (width < 480) throw std::invalid_argument("map_picture: narrower than its legend");
  std::vector<Colour> colours;
  for (Eigen::Index i = 0; i < count; ++i) colours.push_back({map.colours(0, i), map.colours(1, i), map.colours(2, i)});
  const double unit = map.map.unit_size, high = map.scale.high / unit;
  const ColourLegend legend{{.top = high, .low = map.scale.low / unit, .unit = map.map.unit, .title = map.map.title},
                            [&](double value) { return colour_of(value * unit, map.scale); },
                            extent_words(map.map, ticks(high)[1] / 10)};
  return stacked(
      {title_strip(title, width), view_row(showing, positions, colours, {{0, 1, 2}, width / 3}), scale_strip(legend, width)});
}

}  // namespace toile
