#include "picture/pictures.h"

#include <algorithm>
#include <stdexcept>

#include "garment/units.h"
#include "picture/page.h"

namespace toile {
namespace {

constexpr Colour cloth{.42, .62, .80};

std::vector<Colour> distance_colours(const Eigen::VectorXd& distance, double top) {
  std::vector<Colour> colours;
  for (const double d : distance) colours.push_back(colour_map(d / top));
  return colours;
}

void check(const DistanceMap& map, const Showing& showing, double top) {
  if (map.distance.size() != showing.garment.vertex_count || !(top > 0))
    throw std::invalid_argument("picture: one distance per garment vertex and a scale above 0");
}

Image distance_scale(double top) {
  const double top_mm = top * mm_per_m;
  return scale_strip({{.top = top_mm, .unit = "mm", .title = "distance to the target"},
                      [top_mm](double mm) { return colour_map(mm / top_mm); },
                      {}},
                     page_width);
}

}  // namespace

Image drape_picture(const Showing& showing, const Eigen::Matrix3Xd& positions, const std::string& title) {
  return stacked({title_strip(title, page_width), view_row(showing, positions, {cloth}, {{0, 1, 2}, page_width / 3})});
}

Image distance_picture(const Showing& showing, const DistanceMap& map, double top) {
  check(map, showing, top);
  return stacked({title_strip(map.title, page_width),
                  view_row(showing, map.positions, distance_colours(map.distance, top), {{0, 1, 2}, page_width / 3}),
                  distance_scale(top)});
}

Image compared_picture(const Showing& showing, const DistanceMap& left, const DistanceMap& right, double top) {
  std::vector<Image> columns;
  for (const DistanceMap* map : {&left, &right}) {
    check(*map, showing, top);
    columns.push_back(
        stacked({title_strip(map->title, page_width / 2),
                 view_row(showing, map->positions, distance_colours(map->distance, top), {{0, 2}, page_width / 4})}));
  }
  return stacked({side_by_side(columns), distance_scale(top)});
}

double scale_top(const std::vector<Eigen::VectorXd>& distances) {
  std::vector<double> all;
  for (const Eigen::VectorXd& some : distances) all.insert(all.end(), some.begin(), some.end());
  if (all.empty()) return 1e-3;
  const auto most = all.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), most, all.end());
  return std::max(1e-3, round_top(*most));
}

}  // namespace toile
