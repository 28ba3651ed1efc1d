#include "formats/dxf_aama/drawn_piece.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "formats/dxf/tags.h"
#include "formats/dxf_aama/layers.h"
#include "garment/units.h"

namespace toile::aama {
namespace {

constexpr double arc_chord = 1e-4;  // m

std::vector<Run>* runs_of(DrawnPiece& piece, Role role) {
  switch (role) {
    case Role::cut_line:
      return &piece.cut;
    case Role::sew_line:
      return &piece.sew;
    case Role::dense_cut_line:
      return &piece.dense_cut;
    case Role::dense_sew_line:
      return &piece.dense_sew;
    case Role::cut_out:
      return &piece.cut_outs;
    case Role::grain_line:
      return &piece.grain;
    case Role::mirror_line:
      return &piece.mirror;
    case Role::internal_line:
    case Role::unknown:
      return &piece.internal_lines;
    default:
      return nullptr;
  }
}

class Sorter {
 public:
  Sorter(DrawnPiece& piece, const Transform& to_metres, LeftOut& unknown_layers, LeftOut& unread)
      : piece_(piece), to_metres_(to_metres), unknown_layers_(unknown_layers), unread_(unread) {}

  void sort(const dxf::Entity& entity) {
    const Layer* layer = find_layer(entity.layer);
    if (layer && !layer->read) return;
    const Role role = layer ? layer->role : Role::unknown;
    switch (entity.kind) {
      case dxf::Kind::line:
      case dxf::Kind::polyline:
        if (role == Role::notch)
          notch_line(entity, layer->notch);
        else
          run(entity, role);
        break;
      case dxf::Kind::point:
        point(entity, role, layer);
        break;
      case dxf::Kind::text:
        text(entity, role);
        break;
      case dxf::Kind::insert:
        ++unread_["INSERT inside a block"];
        break;
      case dxf::Kind::other:
        if (entity.type != "ATTDEF" && entity.type != "ATTRIB" && entity.type != "VERTEX")
          ++unread_[entity.type + " on layer " + entity.layer];
        break;
    }
  }

 private:
  void run(const dxf::Entity& entity, Role role) {
    if (role == Role::unknown) ++unknown_layers_[entity.layer];
    std::vector<Run>* runs = runs_of(piece_, role);
    if (!runs) return;
    const double scale = std::sqrt(std::abs(to_metres_.linear.determinant()));
    Run drawn{{}, entity.closed, entity.line};
    for (const Eigen::Vector2d& p :
         entity.kind == dxf::Kind::polyline ? dxf::flattened(entity, arc_chord / scale) : entity.points)
      drawn.points.push_back(to_metres_(p));
    runs->push_back(std::move(drawn));
  }

  void point(const dxf::Entity& entity, Role role, const Layer* layer) {
    const Eigen::Vector2d at = to_metres_(entity.points.front());
    if (role == Role::turn_point || role == Role::curve_point) piece_.points.push_back({at, role == Role::turn_point});
    if (role == Role::drill_hole) piece_.drill_holes.push_back({at, std::abs(entity.z.value_or(0)) * to_metres_.unit});
    if (role != Role::notch) return;
    DrawnNotch notch{at,
                     layer->notch,
                     std::abs(entity.z.value_or(0)) * to_metres_.unit,
                     std::abs(entity.thickness.value_or(0)) * to_metres_.unit,
                     Eigen::Vector2d::Zero(),
                     entity.line};
    if (notch.kind == NotchKind::slit && notch.width > 0) notch.kind = NotchKind::v;
    if (entity.angle) {
      const double angle = *entity.angle * units::degree;
      notch.direction = (to_metres_.linear * Eigen::Vector2d(std::cos(angle), std::sin(angle))).normalized();
    }
    piece_.notches.push_back(notch);
  }

  // Some writers draw a notch as a short line; which end is on the outline is found later.
  void notch_line(const dxf::Entity& entity, NotchKind kind) {
    if (entity.points.size() < 2) return;
    const Eigen::Vector2d a = to_metres_(entity.points.front());
    const Eigen::Vector2d b = to_metres_(entity.points.back());
    if ((b - a).norm() == 0) return;
    piece_.notches.push_back({a, kind, (b - a).norm(), 0, (b - a).normalized(), entity.line});
    piece_.notches.back().from_line = true;
  }

  void text(const dxf::Entity& entity, Role role) {
    const Eigen::Vector2d at = to_metres_(entity.points.front());
    if (const std::optional<int> rule = grade_rule(entity.text)) piece_.grade_rules.emplace_back(at, *rule);
    if (role == Role::internal_line && dxf::same_word(entity.text, "NM")) piece_.not_mirrored.push_back(at);
  }

  DrawnPiece& piece_;
  const Transform& to_metres_;
  LeftOut& unknown_layers_;
  LeftOut& unread_;
};

}  // namespace

std::string DrawnPiece::place(std::optional<int> at_line) const {
  return file + ":" + std::to_string(at_line.value_or(line)) + ", piece '" + name + "'";
}

Transform transform_of(const dxf::Block& block, const std::vector<dxf::Entity>& entities, double unit) {
  Transform transform;
  transform.unit = unit;
  const auto insert = std::find_if(entities.begin(), entities.end(),
                                   [&](const dxf::Entity& e) { return e.kind == dxf::Kind::insert && e.text == block.name; });
  Eigen::Vector2d at = block.base;
  if (insert != entities.end()) {
    const double angle = insert->angle.value_or(0) * units::degree;
    Eigen::Matrix2d turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Eigen::Vector2d scale(insert->scale.x() != 0 ? insert->scale.x() : 1.0,
                                insert->scale.y() != 0 ? insert->scale.y() : 1.0);
    transform.linear = turn * scale.asDiagonal();
    at = insert->points.front();
  }
  transform.shift = unit * (at - transform.linear * block.base);
  transform.linear *= unit;
  return transform;
}

DrawnPiece sort_by_layer(const dxf::Block& block, const Transform& to_metres, LeftOut& unknown_layers, LeftOut& unread) {
  DrawnPiece piece;
  piece.line = block.line;
  piece.texts = piece_texts(block.entities);
  piece.tolerance = std::max(2e-5, 1e-3 * to_metres.unit);
  Sorter sorter(piece, to_metres, unknown_layers, unread);
  for (const dxf::Entity& entity : block.entities) sorter.sort(entity);
  return piece;
}

}  // namespace toile::aama
