#include "geometry/embed.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "geometry/embed_acceleration.h"
#include "geometry/embed_system.h"
#include "geometry/triangle_shape.h"

namespace toile {
namespace {

double cotangent(const Eigen::Vector2d& u, const Eigen::Vector2d& v) { return u.dot(v) / (u.x() * v.y() - u.y() * v.x()); }

}  // namespace

struct Embedder::State : EmbedSystem {};

void EmbedSystem::align(Eigen::Matrix2Xd& at, const Eigen::Matrix2Xd& start) const {
  for (std::size_t p = 0; p < panels.size(); ++p) {
    Eigen::Matrix2d map = Eigen::Matrix2d::Zero();
    Eigen::Vector2d centre = Eigen::Vector2d::Zero(), start_centre = Eigen::Vector2d::Zero();
    double area = 0;
    for (Eigen::Index t = first_triangle[p]; t < first_triangle[p + 1]; ++t) {
      map += areas(t) * triangle_at(at, t) * triangle_at(start, t).inverse();
      for (int corner = 0; corner < 3; ++corner) {
        centre += areas(t) / 3 * at.col(triangles(corner, t));
        start_centre += areas(t) / 3 * start.col(triangles(corner, t));
      }
      area += areas(t);
    }
    if (area <= 0) continue;
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-rotation_angle(map)).toRotationMatrix();
    auto panel = at.middleCols(first_vertex[p], first_vertex[p + 1] - first_vertex[p]);
    panel = ((turn * (panel.colwise() - centre / area)).colwise() + start_centre / area).eval();
  }
}

Embedder::Embedder(std::vector<FlatMesh> panels, std::vector<MatingEdges> mating, const std::vector<Eigen::Matrix2d>& reference,
                   EmbedOptions options)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.options = options;
  s.panels = std::move(panels);
  for (const FlatMesh& panel : s.panels) {
    s.first_vertex.push_back(s.first_vertex.back() + static_cast<int>(panel.vertex_count));
    s.first_triangle.push_back(s.first_triangle.back() + static_cast<int>(panel.triangles.cols()));
    if (panel.triangles.size() > 0 && (panel.triangles.minCoeff() < 0 || panel.triangles.maxCoeff() >= panel.vertex_count))
      throw std::invalid_argument("Embedder: a triangle names a vertex that does not exist");
  }
  const Eigen::Index count = s.first_triangle.back();
  if (static_cast<Eigen::Index>(reference.size()) != count)
    throw std::invalid_argument("Embedder: one reference shape per triangle is needed");
  s.triangles.resize(3, count);
  for (std::size_t p = 0; p < s.panels.size(); ++p)
    s.triangles.middleCols(s.first_triangle[p], s.panels[p].triangles.cols()) =
        s.panels[p].triangles.array() + s.first_vertex[p];
  s.cotangents.resize(3, count);
  s.areas.resize(count);
  for (Eigen::Index t = 0; t < count; ++t) {
    const Eigen::Matrix2d& shape = reference[static_cast<std::size_t>(t)];
    s.areas(t) = shape.determinant() / 2;
    if (!(s.areas(t) > 0)) throw std::invalid_argument("Embedder: reference triangle " + std::to_string(t) + " has no area");
    for (int e = 0; e < 3; ++e) s.cotangents(e, t) = cotangent(edge_of(shape, (e + 2) % 3), -edge_of(shape, (e + 1) % 3));
  }
  s.find_seams(mating);
  if (count > 0) {
    const double per_panel = static_cast<double>(count) / static_cast<double>(s.panels.size());
    s.seam_weight = options.seam_weight * s.cotangents.cwiseAbs().mean() * std::max(1.0, std::sqrt(per_panel / 500));
  }
  s.find_hinges(reference);
  s.factor();
}

Embedder::~Embedder() = default;
Embedder::Embedder(Embedder&&) noexcept = default;
Embedder& Embedder::operator=(Embedder&&) noexcept = default;

Embedding Embedder::embed(const std::vector<Eigen::Matrix2d>& shapes, const std::vector<Eigen::Matrix2Xd>& start) const {
  const State& s = *state_;
  if (static_cast<Eigen::Index>(shapes.size()) != s.triangles.cols() || start.size() != s.panels.size())
    throw std::invalid_argument("embed: one shape per triangle and one start per panel are needed");
  Eigen::Matrix2Xd from(2, s.vertex_count());
  for (std::size_t p = 0; p < start.size(); ++p) {
    if (start[p].cols() != s.panels[p].vertex_count) throw std::invalid_argument("embed: vertex count of a start differs");
    from.middleCols(s.first_vertex[p], start[p].cols()) = start[p];
  }

  std::vector<double> angles = s.first_angles(shapes, from);
  Eigen::Matrix2Xd pull = s.wanted_seams(shapes, angles);
  Eigen::Matrix2Xd at = s.global_step(shapes, angles, pull, from);
  FixedPointMemory memory(5);
  Eigen::Matrix2Xd plain = at;  // what the last plain iteration gave: the way back when acceleration overshoots
  double last_energy = std::numeric_limits<double>::infinity();
  Embedding result;
  while (result.iterations < s.options.most_iterations) {
    ++result.iterations;
    double energy = s.local_step(shapes, at, angles, pull);
    if (energy > last_energy) {
      at = plain;
      memory.forget();
      energy = s.local_step(shapes, at, angles, pull);
    }
    last_energy = energy;
    plain = s.global_step(shapes, angles, pull, from);
    const double move = std::sqrt((plain - at).colwise().squaredNorm().maxCoeff());
    at = move < s.options.tolerance ? plain : memory.next(at, plain);
    if (move < s.options.tolerance) break;
  }
  if (s.local_step(shapes, at, angles, pull) > last_energy) at = plain;
  s.align(at, from);

  double area = 0;
  for (Eigen::Index t = 0; t < s.triangles.cols(); ++t) {
    const auto i = static_cast<std::size_t>(t);
    const Eigen::Matrix2d flat = s.triangle_at(at, t);
    const Eigen::Vector2d sigma = stretch_values(shapes[i], flat);
    result.distortion.push_back((std::abs(sigma(0) - 1) + std::abs(sigma(1) - 1)) / 2);
    result.mean_distortion += s.areas(t) * result.distortion.back();
    result.inverted += flat.determinant() <= 0;
    area += s.areas(t);
  }
  if (area > 0) result.mean_distortion /= area;
  for (std::size_t p = 0; p < start.size(); ++p)
    result.panels.push_back(at.middleCols(s.first_vertex[p], s.first_vertex[p + 1] - s.first_vertex[p]));
  return result;
}

}  // namespace toile
