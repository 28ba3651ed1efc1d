#include "picture/render.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "geometry/normals.h"
#include "picture/camera.h"
#include "picture/colour_space.h"

namespace toile {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double line_lift = 0.002;  // of the distance to the viewer

struct Sample {
  float depth = -std::numeric_limits<float>::infinity();
  int mesh = -1;  // -1: background; meshes, then lines
  int triangle = 0;
  float b = 0, c = 0;  // weights of the second and third corner
};

void check(const ShownMesh& mesh) {
  const auto vertices = mesh.positions.cols();
  const auto count = static_cast<Eigen::Index>(mesh.colours.size());
  if (!mesh.positions.allFinite()) throw std::invalid_argument("render: positions must be finite");
  if (mesh.triangles.cols() > 0 && (mesh.triangles.minCoeff() < 0 || mesh.triangles.maxCoeff() >= vertices))
    throw std::invalid_argument("render: a triangle names an unknown vertex");
  if (count != 1 && count != mesh.triangles.cols() && count != vertices)
    throw std::invalid_argument("render: one colour, one per triangle or one per vertex");
}

Eigen::Matrix3Xd everything(const Scene3D& scene) {
  Eigen::Index count = 0;
  for (const ShownMesh& mesh : scene.meshes) count += mesh.positions.cols();
  Eigen::Matrix3Xd all(3, count);
  count = 0;
  for (const ShownMesh& mesh : scene.meshes) {
    all.middleCols(count, mesh.positions.cols()) = mesh.positions;
    count += mesh.positions.cols();
  }
  return all;
}

// Linear light to a byte of sRGB.
class Encoding {
 public:
  Encoding() {
    for (int i = 0; i <= steps; ++i)
      table_[static_cast<std::size_t>(i)] =
          static_cast<std::uint8_t>(std::lround(255 * to_encoded(static_cast<double>(i) / steps)));
  }
  std::uint8_t operator()(float linear) const {
    return table_[static_cast<std::size_t>(std::clamp(linear, 0.0F, 1.0F) * steps + 0.5F)];
  }

 private:
  static constexpr int steps = 16384;
  std::array<std::uint8_t, steps + 1> table_{};
};

class Raster {
 public:
  Raster(const View& view, const Eigen::Matrix3Xd& frame)
      : samples_(view.samples),
        width_(view.width * view.samples),
        height_(view.height * view.samples),
        camera_(view, frame),
        buffer_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

  void draw(const ShownMesh& mesh, int number) {
    Eigen::Matrix3Xd seen(3, mesh.positions.cols());
    for (Eigen::Index v = 0; v < seen.cols(); ++v) seen.col(v) = on_samples(mesh.positions.col(v));
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
      draw_triangle(seen.col(mesh.triangles(0, t)), seen.col(mesh.triangles(1, t)), seen.col(mesh.triangles(2, t)), number,
                    static_cast<int>(t));
  }

  void draw(const ShownLine& line, int number) {
    for (std::size_t i = 1; i < line.points.size(); ++i)
      draw_segment(on_samples(line.points[i - 1]), on_samples(line.points[i]), line.width * samples_ / 2, number);
  }

  const Camera& camera() const { return camera_; }
  const Sample& at(int x, int y) const {
    return buffer_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }

 private:
  Vector3d on_samples(const Vector3d& point) const {
    const Vector3d p = camera_.project(point);
    return {p.x() * samples_, p.y() * samples_, p.z()};
  }

  Sample& sample(int x, int y) {
    return buffer_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }

  // First and last sample row or column whose centre lies in [low, high].
  static std::pair<int, int> range(double low, double high, int size) {
    return {static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(size))),
            static_cast<int>(std::clamp(std::floor(high - 0.5), -1.0, size - 1.0))};
  }

  void draw_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, int mesh, int triangle) {
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
    if (!std::isfinite(area + a.z() + b.z() + c.z()) || area == 0) return;
    const auto [x0, x1] = range(std::min({a.x(), b.x(), c.x()}), std::max({a.x(), b.x(), c.x()}), width_);
    const auto [y0, y1] = range(std::min({a.y(), b.y(), c.y()}), std::max({a.y(), b.y(), c.y()}), height_);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double px = x + 0.5 - a.x(), py = y + 0.5 - a.y();
        const double wb = (px * (c.y() - a.y()) - (c.x() - a.x()) * py) / area;
        const double wc = ((b.x() - a.x()) * py - px * (b.y() - a.y())) / area;
        if (wb < 0 || wc < 0 || wb + wc > 1) continue;
        const auto depth = static_cast<float>(a.z() + wb * (b.z() - a.z()) + wc * (c.z() - a.z()));
        Sample& s = sample(x, y);
        if (depth > s.depth) s = {depth, mesh, triangle, static_cast<float>(wb), static_cast<float>(wc)};
      }
  }

  void draw_segment(const Vector3d& a, const Vector3d& b, double half_width, int number) {
    if (!std::isfinite(a.z() + b.z())) return;
    const auto [x0, x1] = range(std::min(a.x(), b.x()) - half_width, std::max(a.x(), b.x()) + half_width, width_);
    const auto [y0, y1] = range(std::min(a.y(), b.y()) - half_width, std::max(a.y(), b.y()) + half_width, height_);
    const Eigen::Vector2d along = (b - a).head<2>();
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const Eigen::Vector2d p(x + 0.5 - a.x(), y + 0.5 - a.y());
        const double t = along.squaredNorm() > 0 ? std::clamp(p.dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
        if ((p - t * along).norm() > half_width) continue;
        const double depth = a.z() + t * (b.z() - a.z());
        const auto lifted = static_cast<float>(depth + line_lift * std::abs(depth));
        Sample& s = sample(x, y);
        if (lifted > s.depth) s = {lifted, number, 0, 0, 0};
      }
  }

  int samples_, width_, height_;
  Camera camera_;
  std::vector<Sample> buffer_;
};

// Linear-light colour of what the samples show.
class Shading {
 public:
  Shading(const Scene3D& scene, const Camera& camera) : scene_(scene), camera_(camera) {
    for (const ShownMesh& mesh : scene.meshes) {
      normals_.push_back(vertex_normals(mesh.positions, mesh.triangles));
      colours_.emplace_back();
      for (const Colour& colour : mesh.colours) colours_.back().push_back(linear(colour));
    }
    key_ = camera.axes().transpose() * Vector3d(-0.45, 0.6, 0.66).normalized();
    fill_ = camera.axes().transpose() * Vector3d(0.75, 0.15, 0.65).normalized();
    background_ = linear(scene.background);
  }

  Vector3f operator()(const Sample& sample) const {
    if (sample.mesh < 0) return background_;
    const auto number = static_cast<std::size_t>(sample.mesh);
    if (number >= scene_.meshes.size()) return linear(scene_.lines[number - scene_.meshes.size()].colour);
    return lit(scene_.meshes[number], number, sample);
  }

 private:
  static Vector3f linear(const Colour& colour) {
    return Vector3d(to_linear(colour.red), to_linear(colour.green), to_linear(colour.blue)).cast<float>();
  }

  Vector3f lit(const ShownMesh& mesh, std::size_t number, const Sample& sample) const {
    const Eigen::Vector3i corners = mesh.triangles.col(sample.triangle);
    const std::array<double, 3> weights = {1.0 - sample.b - sample.c, sample.b, sample.c};
    const std::vector<Vector3f>& colours = colours_[number];
    const bool per_triangle = colours.size() == static_cast<std::size_t>(mesh.triangles.cols());
    Vector3d normal = Vector3d::Zero(), place = Vector3d::Zero();
    Vector3f colour = Vector3f::Zero();
    for (int k = 0; k < 3; ++k) {
      const double w = weights[static_cast<std::size_t>(k)];
      normal += w * normals_[number].col(corners[k]);
      place += w * mesh.positions.col(corners[k]);
      if (!per_triangle && colours.size() > 1) colour += static_cast<float>(w) * colours[static_cast<std::size_t>(corners[k])];
    }
    if (colours.size() == 1)
      colour = colours.front();
    else if (per_triangle)
      colour = colours[static_cast<std::size_t>(sample.triangle)];

    const Vector3d flat = (mesh.positions.col(corners[1]) - mesh.positions.col(corners[0]))
                              .cross(mesh.positions.col(corners[2]) - mesh.positions.col(corners[0]));
    const bool from_behind = flat.dot(camera_.to_viewer(place)) < 0;
    normal.normalize();
    if (from_behind) normal = -normal;
    const auto half_lambert = [&](const Vector3d& light) {
      const double h = 0.5 + 0.5 * normal.dot(light);
      return h * h;
    };
    const double brightness =
        (0.22 + 0.62 * half_lambert(key_) + 0.24 * half_lambert(fill_)) * (from_behind ? mesh.inside : 1.0);
    return static_cast<float>(brightness) * colour;
  }

  const Scene3D& scene_;
  const Camera& camera_;
  std::vector<Eigen::Matrix3Xd> normals_;
  std::vector<std::vector<Vector3f>> colours_;
  Vector3d key_, fill_;
  Vector3f background_;
};

}  // namespace

Image render(const Scene3D& scene, const View& view) {
  if (view.width <= 0 || view.height <= 0 || view.samples <= 0) throw std::invalid_argument("render: size must be positive");
  for (const ShownMesh& mesh : scene.meshes) check(mesh);
  Raster raster(view, view.frame.cols() > 0 ? view.frame : everything(scene));
  int number = 0;
  for (const ShownMesh& mesh : scene.meshes) raster.draw(mesh, number++);
  for (const ShownLine& line : scene.lines) raster.draw(line, number++);

  const Shading shade(scene, raster.camera());
  const Encoding encoded;
  Image image = blank_image(view.width, view.height, scene.background);
  auto byte = image.pixels.begin();
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x, byte += 3) {
      Vector3f sum = Vector3f::Zero();
      int covered = 0;
      for (int sy = 0; sy < view.samples; ++sy)
        for (int sx = 0; sx < view.samples; ++sx) {
          const Sample& sample = raster.at(x * view.samples + sx, y * view.samples + sy);
          covered += sample.mesh >= 0;
          sum += shade(sample).cwiseMin(1.0F);
        }
      if (covered == 0) continue;
      sum /= static_cast<float>(view.samples * view.samples);
      for (int k = 0; k < 3; ++k) byte[k] = encoded(sum[k]);
    }
  return image;
}

}  // namespace toile
