#include "picture/page.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "picture/canvas.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Colour skin{.83, .80, .77}, seam_colour{.13, .16, .22}, grey{.35, .35, .35};
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

}  // namespace

std::string figure_words(double value, double step) {
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, std::abs(value));
  const bool zero = std::string(text).find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? "\u2212" : "") + std::string(text);
}

Image title_strip(const std::string& title, int width) {
  Canvas canvas(blank_image(width, 46));
  double size = 20;
  while (size > 9 && canvas.width_of(title, size, true) > width - 20) size -= 0.5;
  canvas.words(title, {width / 2.0, 31}, size, {.1, .1, .1}, Align::centre, true);
  return canvas.image();
}

Image view_row(const Showing& showing, const Eigen::Matrix3Xd& positions, const std::vector<Colour>& colours,
               const ViewRow& row) {
  if (positions.cols() != showing.garment.vertex_count) throw std::invalid_argument("picture: one position per garment vertex");
  Scene3D scene{.meshes = {shown(showing.body), {positions, showing.garment.triangles, colours, 0.55}},
                .lines = seam_lines(showing.garment, positions),
                .background = {1, 1, 1}};
  scene.lines.insert(scene.lines.end(), row.marks.begin(), row.marks.end());
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

Image scale_strip(const ColourLegend& legend, int width) {
  Canvas canvas(blank_image(width, legend.note.empty() ? 84 : 104));
  const double low = legend.scale.low, high = legend.scale.top;
  const double left = width / 4.0, right = width * 3 / 4.0;
  canvas.words(legend.scale.title + ", " + legend.scale.unit, {width / 2.0, 20}, 15, {.1, .1, .1}, Align::centre);
  const int steps = static_cast<int>(right - left);
  for (int i = 0; i < steps; ++i)
    canvas.fill({{left + i, 30}, {left + i + 1, 30}, {left + i + 1, 48}, {left + i, 48}},
                legend.colour(low + (high - low) * (i + 0.5) / steps));
  canvas.line({{left, 30}, {right, 30}, {right, 48}, {left, 48}}, grey, 1, true);
  const std::vector<double> above = ticks(high);
  std::vector<double> values;
  if (low < 0)
    for (auto value = above.rbegin(); *value > 0; ++value) values.push_back(-*value);
  values.insert(values.end(), above.begin(), above.end());
  double widest = 0;
  for (const double value : values) widest = std::max(widest, canvas.width_of(figure_words(value, above[1]), 14));
  // Where numbers would run into each other, every second one, counted from 0.
  const std::size_t zero = values.size() - above.size();
  const bool dense = widest + 8 > (right - left) * above[1] / (high - low);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = left + (right - left) * (values[i] - low) / (high - low);
    canvas.line({{x, 48}, {x, 54}}, grey, 1);
    if (dense && (i + zero) % 2) continue;
    canvas.words(figure_words(values[i], above[1]), {x, 70}, 14, {.1, .1, .1}, Align::centre);
  }
  canvas.words("or more", {right + 22, 70}, 14, grey);
  if (low < 0) canvas.words("or less", {left - 22, 70}, 14, grey, Align::right);
  canvas.words(legend.note, {width / 2.0, 94}, 13, grey, Align::centre);
  return canvas.image();
}

}  // namespace toile
