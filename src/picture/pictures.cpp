#include "picture/pictures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

#include "garment/units.h"
#include "picture/canvas.h"
#include "picture/render.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Colour cloth{.42, .62, .80}, skin{.83, .80, .77}, seam_colour{.13, .16, .22}, grey{.35, .35, .35};
constexpr int page_width = 1200;
constexpr double slimmer = 2e-3;  // m, the body is drawn inside itself, so that cloth lying on it is not dotted with skin

struct Side {
  const char* name;
  Vector3d towards_viewer;
};
const std::array<Side, 3> sides = {Side{"front", Vector3d::UnitZ()}, Side{"side (wearer's left)", Vector3d::UnitX()},
                                   Side{"back", -Vector3d::UnitZ()}};

ShownMesh shown(const Mannequin& body) {
  ShownMesh mesh{body.positions, body.triangles, {skin}, 1};
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, body.positions.cols());
  for (Eigen::Index t = 0; t < body.triangles.cols(); ++t) {
    const Vector3d a = body.positions.col(body.triangles(0, t));
    const Vector3d ab = Vector3d(body.positions.col(body.triangles(1, t))) - a;
    const Vector3d ac = Vector3d(body.positions.col(body.triangles(2, t))) - a;
    for (int k = 0; k < 3; ++k) normals.col(body.triangles(k, t)) += ab.cross(ac);
  }
  for (Eigen::Index v = 0; v < normals.cols(); ++v)
    if (normals.col(v).norm() > 0) mesh.positions.col(v) -= slimmer * normals.col(v).normalized();
  return mesh;
}

std::vector<ShownLine> seam_lines(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions) {
  std::vector<ShownLine> lines;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    ShownLine line{{}, seam_colour, 1.3};
    for (const BoundaryVertex& vertex : garment.panels[p].boundary)
      line.points.emplace_back(positions.col(garment.welded[p][vertex.vertex]));
    if (!line.points.empty()) line.points.push_back(line.points.front());
    lines.push_back(std::move(line));
  }
  return lines;
}

// The corners of the upright square prism about `points`: it looks as large from every side.
Eigen::Matrix3Xd prism(const Eigen::Matrix3Xd& points) {
  const Vector3d low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
  const Vector3d middle = (low + high) / 2;
  const double half = std::max(high.x() - low.x(), high.z() - low.z()) / 2;
  Eigen::Matrix3Xd corners(3, 8);
  for (int i = 0; i < 8; ++i)
    corners.col(i) << middle.x() + (i & 1 ? half : -half), (i & 2 ? high : low).y(), middle.z() + (i & 4 ? half : -half);
  return corners;
}

struct Row {
  std::vector<std::size_t> sides;
  int width;  // of one view, pixels
};

Image title_strip(const std::string& title, int width) {
  Canvas canvas(blank_image(width, 46));
  double size = 20;
  while (size > 9 && canvas.width_of(title, size, true) > width - 20) size -= 0.5;
  canvas.words(title, {width / 2.0, 31}, size, {.1, .1, .1}, Align::centre, true);
  return canvas.image();
}

Image views(const Showing& showing, const Eigen::Matrix3Xd& positions, const std::vector<Colour>& colours, const Row& row) {
  if (positions.cols() != showing.garment.vertex_count) throw std::invalid_argument("picture: one position per garment vertex");
  const Scene3D scene{.meshes = {shown(showing.body), {positions, showing.garment.triangles, colours, 0.55}},
                      .lines = seam_lines(showing.garment, positions),
                      .background = {1, 1, 1}};
  View view;
  view.samples = showing.samples;
  view.frame = prism(showing.frame.cols() > 0 ? showing.frame : positions);
  const Vector3d size = view.frame.rowwise().maxCoeff() - view.frame.rowwise().minCoeff();
  view.width = row.width;
  view.height = std::clamp(static_cast<int>(1.12 * row.width * size.y() / std::max(size.x(), 1e-6)), row.width, 2 * row.width);
  std::vector<Image> images;
  for (const std::size_t i : row.sides) {
    view.towards_viewer = sides[i].towards_viewer;
    Canvas name(blank_image(row.width, 30));
    name.words(sides[i].name, {row.width / 2.0, 20}, 14, grey, Align::centre);
    images.push_back(stacked({render(scene, view), name.image()}));
  }
  return side_by_side(images);
}

std::vector<Colour> distance_colours(const Eigen::VectorXd& distance, double top) {
  std::vector<Colour> colours;
  for (const double d : distance) colours.push_back(colour_map(d / top));
  return colours;
}

std::string tick_words(double value, double step) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", step < 0.0999 ? 2 : step < 0.999 ? 1 : 0, value);
  return text;
}

Image scale_strip(const ColourScale& scale, int width) {
  Canvas canvas(blank_image(width, 84));
  const double left = width / 4.0, right = width * 3 / 4.0;
  canvas.words(scale.title + ", " + scale.unit, {width / 2.0, 20}, 15, {.1, .1, .1}, Align::centre);
  const int steps = static_cast<int>(right - left);
  for (int i = 0; i < steps; ++i)
    canvas.fill({{left + i, 30}, {left + i + 1, 30}, {left + i + 1, 48}, {left + i, 48}}, colour_map((i + 0.5) / steps));
  canvas.line({{left, 30}, {right, 30}, {right, 48}, {left, 48}}, grey, 1, true);
  const std::vector<double> values = ticks(scale.top);
  for (const double value : values) {
    const double x = left + (right - left) * value / scale.top;
    canvas.line({{x, 48}, {x, 54}}, grey, 1);
    canvas.words(tick_words(value, values[1]), {x, 70}, 14, {.1, .1, .1}, Align::centre);
  }
  canvas.words("or more", {right + 22, 70}, 14, grey);
  return canvas.image();
}

void check(const DistanceMap& map, const Showing& showing, double top) {
  if (map.distance.size() != showing.garment.vertex_count || !(top > 0))
    throw std::invalid_argument("picture: one distance per garment vertex and a scale above 0");
}

Image distance_scale(double top) { return scale_strip({top * mm_per_m, "mm", "distance to the target"}, page_width); }

}  // namespace

Image drape_picture(const Showing& showing, const Eigen::Matrix3Xd& positions, const std::string& title) {
  return stacked({title_strip(title, page_width), views(showing, positions, {cloth}, {{0, 1, 2}, page_width / 3})});
}

Image distance_picture(const Showing& showing, const DistanceMap& map, double top) {
  check(map, showing, top);
  return stacked({title_strip(map.title, page_width),
                  views(showing, map.positions, distance_colours(map.distance, top), {{0, 1, 2}, page_width / 3}),
                  distance_scale(top)});
}

Image compared_picture(const Showing& showing, const DistanceMap& left, const DistanceMap& right, double top) {
  std::vector<Image> columns;
  for (const DistanceMap* map : {&left, &right}) {
    check(*map, showing, top);
    columns.push_back(
        stacked({title_strip(map->title, page_width / 2),
                 views(showing, map->positions, distance_colours(map->distance, top), {{0, 2}, page_width / 4})}));
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
