#include "formats/dxf_aama/drawn_piece.h"

#include <algorithm>
#include <cmath>

#include "formats/dxf/explode.h"
#include "formats/dxf/tags.h"
#include "formats/dxf_aama/layers.h"
#include "garment/units.h"

namespace toile::aama {
namespace {

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
    case Role::dense_internal_line:
      return &piece.dense_internal_lines;
    case Role::dense_cut_out:
      return &piece.dense_cut_outs;
    case Role::grade_reference:
      return &piece.grade_reference;
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
  Sorter(DrawnPiece& piece, const Transform& to_metres, Sorted& sorted)
      : piece_(piece), to_metres_(to_metres), sorted_(sorted) {}

  void sort(const dxf::Entity& entity) {
    const Layer* layer = find_layer(entity.layer);
    const Role role = layer ? layer->role : Role::unknown;
    switch (entity.kind) {
      case dxf::Kind::line:
      case dxf::Kind::polyline:
        if (role == Role::notch)
          notch_line(entity, layer->notch);
        else if (role == Role::drill_hole)
          circle(entity);
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
        ++sorted_.unread["INSERT of block '" + entity.text + "'"];
        break;
      case dxf::Kind::other:
        ++(entity.type == "ATTDEF" || entity.type == "ATTRIB" ? sorted_.not_kept
                                                              : sorted_.unread)[entity.type + " on layer " + entity.layer];
        break;
    }
  }

 private:
  void not_kept(const dxf::Entity& entity) {
    const Layer* layer = find_layer(entity.layer);
    ++sorted_.not_kept[entity.type + " on layer " + entity.layer + (layer ? " (" + std::string(layer->name) + ")" : "")];
  }

  void run(const dxf::Entity& entity, Role role) {
    std::vector<Run>* runs = runs_of(piece_, role);
    if (!runs) return not_kept(entity);
    if (role == Role::unknown) ++sorted_.unknown_layers[entity.layer];
    if (role == Role::grade_reference) not_kept(entity);  // used by grade rules alone
    Run drawn{{}, entity.closed, entity.line};
    for (const Eigen::Vector2d& p :
         entity.kind == dxf::Kind::polyline ? dxf::flattened(entity, to_metres_.chord) : entity.points)
      drawn.points.push_back(to_metres_(p));
    runs->push_back(std::move(drawn));
  }

  // A hole drawn as what is left of the cloth.
  void circle(const dxf::Entity& entity) {
    const Points<2>& p = entity.points;
    if (entity.type != "CIRCLE" || p.size() < 4) return run(entity, Role::internal_line);
    piece_.drill_holes.push_back(
        {to_metres_((p[0] + p[p.size() / 2]) / 2), (to_metres_(p[p.size() / 2]) - to_metres_(p[0])).norm()});
  }

  void point(const dxf::Entity& entity, Role role, const Layer* layer) {
    const Eigen::Vector2d at = to_metres_(entity.points.front());
    if (role == Role::turn_point || role == Role::curve_point) {
      piece_.points.push_back({at, role == Role::turn_point});
    } else if (role == Role::drill_hole) {
      piece_.drill_holes.push_back({at, std::abs(entity.z.value_or(0)) * to_metres_.unit});
    } else if (role == Role::notch) {
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
    } else {
      not_kept(entity);
    }
  }

  // Some writers draw a notch as a short line; which end is on the outline is found later.
  void notch_line(const dxf::Entity& entity, NotchKind kind) {
    if (entity.points.size() < 2) return not_kept(entity);
    const Eigen::Vector2d a = to_metres_(entity.points.front());
    const Eigen::Vector2d b = to_metres_(entity.points.back());
    if ((b - a).norm() == 0) return not_kept(entity);
    piece_.notches.push_back({a, kind, (b - a).norm(), 0, (b - a).normalized(), entity.line});
    piece_.notches.back().from_line = true;
  }

  void text(const dxf::Entity& entity, Role role) {
    const Eigen::Vector2d at = to_metres_(entity.points.front());
    if (const std::optional<int> rule = grade_rule(entity.text))
      piece_.grade_rules.push_back({at, *rule, role});
    else if (!is_piece_text(entity))
      not_kept(entity);
    if (role == Role::internal_line && dxf::same_word(entity.text, "NM")) piece_.not_mirrored.push_back(at);
  }

  DrawnPiece& piece_;
  const Transform& to_metres_;
  Sorted& sorted_;
};

}  // namespace

std::string DrawnPiece::place(std::optional<int> at_line) const {
  return file + ":" + std::to_string(at_line.value_or(line)) + ", piece '" + name + "'";
}

Transform transform_of(const dxf::Block& block, const std::vector<dxf::Entity>& entities, double unit, double chord) {
  Transform transform;
  transform.unit = unit;
  transform.chord = chord;
  const auto insert = std::find_if(entities.begin(), entities.end(),
                                   [&](const dxf::Entity& e) { return e.kind == dxf::Kind::insert && e.text == block.name; });
  if (insert != entities.end()) {
    const dxf::Affine placed = dxf::placed_by(*insert, block);
    transform.linear = placed.linear;
    transform.shift = unit * placed.shift;
  }
  transform.linear *= unit;
  return transform;
}

DrawnPiece sort_by_layer(const dxf::Block& block, const std::vector<dxf::Entity>& entities, const Transform& to_metres,
                         Sorted& sorted) {
  DrawnPiece piece;
  piece.line = block.line;
  piece.linear = to_metres.linear;
  piece.unit = to_metres.unit;
  piece.texts = piece_texts(entities);
  piece.tolerance = std::max(2e-5, 1e-3 * to_metres.unit);
  Sorter sorter(piece, to_metres, sorted);
  for (const dxf::Entity& entity : entities) sorter.sort(entity);
  return piece;
}

const char* too_much_in(const DrawnPiece& piece) {
  std::size_t vertices = 0, runs = 0;
  for (const auto* lines : {&piece.cut, &piece.sew, &piece.dense_cut, &piece.dense_sew, &piece.internal_lines,
                            &piece.dense_internal_lines, &piece.cut_outs, &piece.dense_cut_outs, &piece.grain, &piece.mirror}) {
    runs += lines->size();
    for (const Run& run : *lines) {
      vertices += run.points.size();
      if (run.points.size() > 20'000) return "a line of more than 20000 points";
    }
  }
  if (vertices > 60'000) return "more than 60000 points";
  if (runs > 10'000) return "more than 10000 lines";
  if (piece.points.size() + piece.grade_rules.size() > 60'000) return "more than 60000 marked points";
  return piece.notches.size() + piece.drill_holes.size() > 5'000 ? "more than 5000 notches and drill holes" : nullptr;
}

void report_left_out(const Sorted& sorted, const std::string& name, Report& report) {
  const auto times = [](int count) { return std::to_string(count) + (count == 1 ? " time" : " times"); };
  for (const auto& [layer, count] : sorted.unknown_layers)
    report.warn("aama.unknown-layer", name,
                "layer '" + layer + "' is in no standard; its lines (" + std::to_string(count) + ") are kept as internal lines",
                "");
  for (const auto& [what, count] : sorted.unread)
    report.warn("aama.unsupported-entity", name, what + " (" + times(count) + ") is not read",
                "export the curves as polylines (R12)");
  for (const auto& [what, count] : sorted.not_kept)
    report.note("aama.not-kept", name, what + " (" + times(count) + "): read, but a pattern has no place for it");
}

}  // namespace toile::aama
