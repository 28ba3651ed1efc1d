#include "formats/dxf/entity.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "formats/dxf/curve_entity.h"
#include "formats/dxf/text_codes.h"

namespace toile::dxf {
namespace {

constexpr double unset = std::numeric_limits<double>::quiet_NaN();
constexpr std::pair<const char*, Kind> kinds[] = {
    {"LINE", Kind::line},         {"POINT", Kind::point},         {"TEXT", Kind::text},        {"MTEXT", Kind::text},
    {"POLYLINE", Kind::polyline}, {"LWPOLYLINE", Kind::polyline}, {"INSERT", Kind::insert},    {"VERTEX", Kind::point},
    {"ARC", Kind::polyline},      {"CIRCLE", Kind::polyline},     {"ELLIPSE", Kind::polyline}, {"SPLINE", Kind::polyline}};

Kind kind_of(const std::string& type) {
  for (const auto& [word, kind] : kinds)
    if (type == word) return kind;
  return Kind::other;
}

// How many points an entity must have; text and inserts without a place are at the origin.
std::size_t points_needed(const Entity& entity) {
  if (entity.kind == Kind::line) return 2;
  if (entity.kind == Kind::polyline) return entity.type == "LWPOLYLINE" ? 1 : 0;
  return 1;
}

class EntityReader {
 public:
  EntityReader(Entity& entity, const std::string& name, Report& report) : entity_(entity), name_(name), report_(report) {}

  void read(const Tag& tag) {
    switch (tag.code) {
      case 8:
        entity_.layer = tag.value;
        break;
      case 1:
        if (entity_.kind == Kind::text) entity_.text += tag.value;
        break;
      case 3:
        if (entity_.type == "MTEXT") entity_.text += tag.value;
        break;
      case 2:
        if (entity_.kind == Kind::insert) entity_.text = tag.value;
        break;
      case 10:
        begin_point(value(tag));
        break;
      case 20:
        set_y(value(tag));
        break;
      case 11:
        if (entity_.kind == Kind::line) far_end().x() = value(tag);
        break;
      case 21:
        if (entity_.kind == Kind::line) far_end().y() = value(tag);
        break;
      case 30:
        if (entity_.kind == Kind::point) entity_.z = value(tag);
        break;
      case 39:
        if (entity_.kind == Kind::point) entity_.thickness = value(tag);
        break;
      case 50:
        if (entity_.kind == Kind::point || entity_.kind == Kind::insert) entity_.angle = value(tag);
        break;
      case 41:
        if (entity_.kind == Kind::insert) entity_.scale.x() = value(tag);
        break;
      case 42:
        if (entity_.kind == Kind::insert) entity_.scale.y() = value(tag);
        if ((entity_.type == "LWPOLYLINE" || entity_.type == "VERTEX") && !entity_.bulges.empty())
          entity_.bulges.back() = value(tag);
        break;
      case 230:
        from_below_ = value(tag) < 0;
        break;
      case 70:
        if (entity_.kind == Kind::insert) columns_ = whole_number(tag.value).value_or(1);
        read_flags(tag);
        break;
      case 71:
        if (entity_.kind == Kind::insert) rows_ = whole_number(tag.value).value_or(1);
        break;
      default:
        break;
    }
  }

  void finish() {
    if (from_below_ && entity_.kind != Kind::line && entity_.kind != Kind::point) mirror(entity_);
    if (entity_.kind == Kind::text || entity_.kind == Kind::insert)
      if (entity_.points.empty()) entity_.points.push_back(Eigen::Vector2d::Zero());
    if (entity_.kind == Kind::text) entity_.text = plain_text(entity_.text, entity_.type == "MTEXT");
    if (columns_ > 1 || rows_ > 1)
      report_.warn("dxf.insert-array", name_ + ":" + std::to_string(entity_.line),
                   "block '" + entity_.text + "' is put in as an array of " + std::to_string(std::max(columns_, 1)) + " by " +
                       std::to_string(std::max(rows_, 1)) + "; only its first place is read",
                   "explode the array, or give the piece its quantity");
    bool complete = entity_.points.size() >= points_needed(entity_);
    for (const Eigen::Vector2d& point : entity_.points) complete = complete && !point.hasNaN();
    if (!complete && !failed_)
      report_.error("dxf.incomplete-entity", name_ + ":" + std::to_string(entity_.line),
                    entity_.type + " without all its coordinates", "the file is damaged; export it again");
  }

 private:
  void begin_point(double x) {
    const bool many = entity_.kind == Kind::polyline;
    if (entity_.type == "POLYLINE") return;  // a dummy point that carries the elevation
    if (many || entity_.points.empty()) {
      entity_.points.emplace_back(x, unset);
      if (many || entity_.type == "VERTEX") entity_.bulges.push_back(0);
    } else {
      entity_.points.front().x() = x;
    }
  }
  void set_y(double y) {
    if (entity_.type == "POLYLINE") return;
    if (entity_.points.empty()) entity_.points.emplace_back(unset, unset);
    (entity_.kind == Kind::polyline ? entity_.points.back() : entity_.points.front()).y() = y;
  }
  Eigen::Vector2d& far_end() {
    while (entity_.points.size() < 2) entity_.points.emplace_back(unset, unset);
    return entity_.points[1];
  }
  void read_flags(const Tag& tag) {
    const int flags = whole_number(tag.value).value_or(0);
    if (entity_.kind == Kind::polyline) entity_.closed = (flags & 1) != 0;
    if (entity_.type == "POLYLINE" && (flags & (16 | 64)) != 0) entity_.kind = Kind::other;  // a mesh
    if (entity_.type == "VERTEX" && (flags & 16) != 0) entity_.kind = Kind::other;           // control point of a spline fit
  }
  double value(const Tag& tag) {
    if (const std::optional<double> parsed = number(tag.value)) return *parsed;
    failed_ = true;
    report_.error("dxf.not-a-number", name_ + ":" + std::to_string(tag.line + 1),
                  "group " + std::to_string(tag.code) + " of a " + entity_.type + " on layer " + entity_.layer + " is '" +
                      tag.value.substr(0, 40) + "', not a coordinate",
                  "repair the value or export the file again");
    return 0;
  }

  Entity& entity_;
  const std::string& name_;
  Report& report_;
  int columns_ = 1, rows_ = 1;  // of an INSERT
  bool failed_ = false, from_below_ = false;
};

}  // namespace

void mirror(Entity& entity) {
  for (Eigen::Vector2d& point : entity.points) point.x() = -point.x();
  for (double& bulge : entity.bulges) bulge = -bulge;
  if (entity.kind == Kind::insert) {
    entity.scale.x() = -entity.scale.x();
    entity.angle = -entity.angle.value_or(0);
  }
}

Entity read_entity(std::span<const Tag> tags, const std::string& name, Report& report) {
  Entity entity;
  entity.type = tags.front().value;
  entity.kind = kind_of(entity.type);
  entity.line = tags.front().line;
  entity.layer = "0";
  if (entity.kind == Kind::other) {
    for (const Tag& tag : tags)
      if (tag.code == 8) entity.layer = tag.value;
    return entity;
  }
  if (is_curve(entity.type)) {
    read_curve(tags, entity, name, report);
    return entity;
  }
  EntityReader reader(entity, name, report);
  for (const Tag& tag : tags.subspan(1)) reader.read(tag);
  reader.finish();
  return entity;
}

}  // namespace toile::dxf
