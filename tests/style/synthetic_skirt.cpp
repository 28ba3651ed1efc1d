#include "style/synthetic_skirt.h"

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace toile::testing {
namespace {

constexpr double pi = std::numbers::pi;

// Evenly spread in [-0.5, 0.5), the same on every machine.
class Scatter {
 public:
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1.0p-53 - 0.5;
  }

 private:
  std::uint64_t state_ = 42;
};

double ease_in(double u) {
  u = std::min(1.0, std::max(0.0, u));
  return u * u * (3 - 2 * u);
}

Eigen::Vector3d skirt_point(const SkirtShape& shape, double angle, double drop) {
  const double below = std::max(0.0, drop - shape.tight);
  const Eigen::Vector2d section = body_section(shape, std::min(drop, shape.tight));
  double out = shape.ease + shape.flare * below;
  if (below > 0) out += shape.fold_depth * below / (shape.length - shape.tight) * std::cos(shape.folds * angle);
  return {(section(0) + out) * std::sin(angle), shape.waist_height - drop, (section(1) + out) * std::cos(angle)};
}

Pattern gored_pattern(const SkirtShape& shape) {
  const double top = 2 * pi * 0.12 / shape.gores, bottom = 2 * pi * 0.26 / shape.gores;
  const Eigen::Vector2d corners[] = {{-bottom / 2, -shape.length}, {bottom / 2, -shape.length}, {top / 2, 0}, {-top / 2, 0}};
  const char* names[] = {"hem", "side_right", "waist", "side_left"};
  Piece gore;
  gore.name = "gore";
  gore.quantity = shape.gores;
  for (int e = 0; e < 4; ++e)
    gore.outline.push_back({shape.named_edges ? names[e] : std::string("e").append(std::to_string(e)),
                            {{corners[e], true, {}}, {corners[(e + 1) % 4], true, {}}},
                            {}});
  Pattern pattern;
  pattern.name = "synthetic";
  for (int g = 0; g < shape.gores; ++g)
    pattern.seams.push_back({std::string("side").append(std::to_string(g)),
                             {"gore", g + 1, gore.outline[1].id, 0, 1},
                             {"gore", (g + 1) % shape.gores + 1, gore.outline[3].id, 1, 0}});
  pattern.pieces.push_back(std::move(gore));
  return pattern;
}

}  // namespace

Eigen::Vector2d body_section(const SkirtShape& shape, double drop) {
  const double hip = ease_in(drop / shape.tight);
  const double knee = ease_in((drop - shape.tight) / 0.5);
  return {0.125 + 0.045 * hip - 0.02 * knee, 0.09 + 0.03 * hip - 0.015 * knee};
}

double section_gap(const SkirtShape& shape, const Eigen::Vector3d& at) {
  const Eigen::Vector2d section = body_section(shape, shape.waist_height - at.y());
  const Eigen::Vector2d p(at.x() / section(0), at.z() / section(1));
  const double level = p.norm();
  const double slope = Eigen::Vector2d(p(0) / section(0), p(1) / section(1)).norm() / level;
  return (level - 1) / slope;
}

Mannequin elliptical_body(const SkirtShape& shape) {
  constexpr int around = 72, levels = 110;
  Mannequin form;
  form.name = "elliptical";
  form.height = 1.7;
  form.positions.resize(3, around * levels + 2);
  const double top = form.height;
  for (int level = 0; level < levels; ++level)
    for (int i = 0; i < around; ++i) {
      const double y = top * (1 - level / (levels - 1.0));
      const double angle = 2 * pi * i / around;
      const Eigen::Vector2d section = body_section(shape, std::abs(shape.waist_height - y));
      form.positions.col(level * around + i) = Eigen::Vector3d(section(0) * std::sin(angle), y, section(1) * std::cos(angle));
    }
  const int crown = around * levels, sole = crown + 1;
  form.positions.col(crown) = Eigen::Vector3d(0, top, 0);
  form.positions.col(sole) = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around;
    triangles.emplace_back(crown, i, j);
    triangles.emplace_back(sole, (levels - 1) * around + j, (levels - 1) * around + i);
    for (int level = 0; level + 1 < levels; ++level) {
      const int a = level * around + i, b = level * around + j;
      triangles.emplace_back(a, a + around, b);
      triangles.emplace_back(b, a + around, b + around);
    }
  }
  form.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) form.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
  const double hip = shape.waist_height - shape.tight;
  form.bones = {{"pelvis", "", {0, hip - 0.02, -0.02}, {0, hip, 0}},
                {"spine_low", "pelvis", {0, hip, 0}, {0, shape.waist_height, 0}},
                {"chest", "spine_low", {0, shape.waist_height, 0}, {0, 1.4, 0}},
                {"head", "chest", {0, 1.4, 0}, {0, form.height - 0.02, 0}},
                {"thigh.L", "pelvis", {0.07, hip, 0}, {0.08, 0.45, 0}},
                {"foot.L", "thigh.L", {0.08, 0.45, 0}, {0.08, 0.02, 0}},
                {"thigh.R", "pelvis", {-0.07, hip, 0}, {-0.08, 0.45, 0}},
                {"foot.R", "thigh.R", {-0.08, 0.45, 0}, {-0.08, 0.02, 0}}};
  form.landmarks = {{"waist", shape.waist_height}, {"hip", hip}, {"knee", 0.45}};
  form.measures = {{"waist", 0.68}, {"hip", 0.92}};
  return form;
}

SyntheticSkirt synthetic_skirt(const SkirtShape& shape) {
  SyntheticSkirt skirt;
  skirt.pattern = gored_pattern(shape);
  skirt.form = elliptical_body(shape);
  const int columns = shape.columns, rows = shape.rows, wide = columns / shape.gores;
  Eigen::MatrixXd angle(rows, columns), drop(rows, columns);
  skirt.drape.resize(3, rows * columns);
  Scatter scatter;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const double dr = shape.length / (rows - 1), da = 2 * pi / columns;
      const double aside = shape.jitter * scatter.next();
      angle(r, c) = da * (c + (c % wide == 0 ? 0 : aside));  // seams run straight down
      drop(r, c) = dr * (r + (r == 0 || r == rows - 1 ? 0 : shape.jitter * scatter.next()));
      skirt.drape.col(r * columns + c) = skirt_point(shape, angle(r, c), drop(r, c));
    }
  std::vector<Eigen::Vector3i> garment_triangles;
  for (int g = 0; g < shape.gores; ++g) {
    PanelMesh panel;
    panel.piece = 0;
    panel.copy = g + 1;
    panel.name = std::string("gore:").append(std::to_string(g + 1));
    panel.rest.resize(2, rows * (wide + 1));
    Eigen::VectorXi welded(rows * (wide + 1));
    const double middle = 2 * pi * (g + 0.5) / shape.gores;
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c <= wide; ++c) {
        const int column = (g * wide + c) % columns;
        double turn = angle(r, column) - middle;
        if (turn < -pi) turn += 2 * pi;
        const Eigen::Vector3d at = skirt_point(shape, 0.3, drop(r, column));
        panel.rest.col(r * (wide + 1) + c) = Eigen::Vector2d(turn * std::hypot(at.x(), at.z()), -drop(r, column));
        welded(r * (wide + 1) + c) = r * columns + column;
      }
    std::vector<Eigen::Vector3i> triangles;
    for (int r = 0; r + 1 < rows; ++r)
      for (int c = 0; c < wide; ++c) {
        const int a = r * (wide + 1) + c, b = a + 1, d = a + wide + 1, e = d + 1;
        if (scatter.next() < 0) {
          triangles.emplace_back(a, d, b);
          triangles.emplace_back(b, d, e);
        } else {
          triangles.emplace_back(a, d, e);
          triangles.emplace_back(a, e, b);
        }
      }
    panel.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      panel.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
      garment_triangles.push_back({welded(triangles[t](0)), welded(triangles[t](1)), welded(triangles[t](2))});
    }
    const int last = rows - 1;
    for (int c = 0; c < wide; ++c) panel.boundary.push_back({last * (wide + 1) + c, 0, c / double(wide)});
    for (int r = 0; r < last; ++r) panel.boundary.push_back({(last - r) * (wide + 1) + wide, 1, r / double(last)});
    for (int c = 0; c < wide; ++c) panel.boundary.push_back({wide - c, 2, c / double(wide)});
    for (int r = 0; r < last; ++r) panel.boundary.push_back({r * (wide + 1), 3, r / double(last)});
    skirt.garment.panels.push_back(std::move(panel));
    skirt.garment.welded.push_back(std::move(welded));
  }
  skirt.garment.vertex_count = rows * columns;
  skirt.garment.triangles.resize(3, static_cast<Eigen::Index>(garment_triangles.size()));
  for (std::size_t t = 0; t < garment_triangles.size(); ++t)
    skirt.garment.triangles.col(static_cast<Eigen::Index>(t)) = garment_triangles[t];
  return skirt;
}

}  // namespace toile::testing
