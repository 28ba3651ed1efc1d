#include "formats/seams/sit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "formats/seams/span_text.h"
#include "garment/units.h"

namespace toile {
namespace {

constexpr std::array<const char*, 5> parts = {"trunk", "arm.L", "arm.R", "leg.L", "leg.R"};

BodyPart mirrored(BodyPart on) {
  on.angle = -on.angle;
  if (on.part.ends_with(".L"))
    on.part.back() = 'R';
  else if (on.part.ends_with(".R"))
    on.part.back() = 'L';
  return on;
}

// The middle of the k-th of n equal parts of a turn, k from 0, in (-pi, pi].
double share_of_turn(int k, int n, double first) {
  const double angle = first + 2 * std::numbers::pi * k / n;
  const double wrapped = std::remainder(angle, 2 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

struct Sitting {
  BodyPart on;
  bool around = false;
  std::optional<double> first;
};

std::optional<Sitting> read_sitting(const TomlNode& table, Sidecar& sidecar) {
  if (table.kind != TomlKind::table) {
    sidecar.report.error("seams.bad-value", sidecar.at(table), "'on' must be a table, or a list of tables",
                         "Write for example on = { part = \"trunk\", level = \"waist\", drop = \"4 cm\", angle = \"0 deg\" }");
    return std::nullopt;
  }
  refuse_unknown_keys(table, {"part", "level", "drop", "angle", "around", "first", "grain"}, sidecar.file, "seam.unknown-key",
                      sidecar.report);
  Sitting sitting;
  bool good = true;
  const auto take = [&](const char* key, auto read, auto& into) {
    const TomlNode* node = find(table, key);
    if (!node) return;
    if (const auto value = read(*node, sidecar))
      into = *value;
    else
      good = false;
  };
  take("part", text_of, sitting.on.part);
  if (sitting.on.part.starts_with("arm")) sitting.on.level = "shoulder";
  take("level", text_of, sitting.on.level);
  take("drop", length_of, sitting.on.drop);
  take("angle", angle_of, sitting.on.angle);
  take("around", truth_of, sitting.around);
  take("first", angle_of, sitting.first);
  std::string grain = "upright";
  take("grain", text_of, grain);
  sitting.on.grain_round = grain == "round";
  if (grain != "upright" && grain != "round") {
    sidecar.report.error("seams.bad-value", sidecar.at(*find(table, "grain")), "'grain' is '" + grain + "'",
                         "Write \"upright\", or \"round\" for a piece whose grain runs round the body, such as a waistband");
    good = false;
  }
  if (std::find(parts.begin(), parts.end(), sitting.on.part) == parts.end()) {
    sidecar.report.error("seam.unknown-part", sidecar.at(*find(table, "part")),
                         "the body has no part '" + sitting.on.part + "'", "The parts are trunk, arm.L, arm.R, leg.L, leg.R");
    good = false;
  }
  if (sitting.around && find(table, "angle")) {
    sidecar.report.error("seams.bad-value", sidecar.at(*find(table, "angle")), "'angle' and 'around' exclude each other",
                         "With around = true write the angle of the first copy as 'first'");
    good = false;
  }
  return good ? std::optional(sitting) : std::nullopt;
}

bool one_each(const TomlNode& list, const Piece& piece, Sidecar& sidecar) {
  if (list.kind == TomlKind::array && list.items.size() == static_cast<std::size_t>(copies(piece))) return true;
  sidecar.report.error("seam.copies", sidecar.at(list),
                       "'" + list.key + "' of piece '" + piece.name + "' must be a list of " + std::to_string(copies(piece)) +
                           " tables, one for each copy",
                       "Write {} for a copy of which nothing is known");
  return false;
}

void read_on(const TomlNode& on, Piece& piece, Sidecar& sidecar) {
  const int count = copies(piece);
  std::vector<std::optional<BodyPart>> parts_of_copies;
  if (on.kind == TomlKind::array) {
    if (!one_each(on, piece, sidecar)) return;
    for (const TomlNode& item : on.items) {
      if (item.kind == TomlKind::table && item.items.empty()) {
        parts_of_copies.push_back(std::nullopt);
        continue;
      }
      const auto sitting = read_sitting(item, sidecar);
      if (!sitting) return;
      parts_of_copies.push_back(sitting->on);
    }
  } else {
    const auto sitting = read_sitting(on, sidecar);
    if (!sitting) return;
    for (int copy = 1; copy <= count; ++copy) {
      BodyPart part = sitting->on;
      if (sitting->around)
        part.angle = share_of_turn(copy - 1, count, sitting->first.value_or(std::numbers::pi / count));
      else if (is_mirrored(piece, copy))
        part = mirrored(part);
      parts_of_copies.push_back(part);
    }
  }
  piece.body_part = std::move(parts_of_copies);
}

std::optional<Eigen::Vector3d> three(const TomlNode& table, const char* key,
                                     std::optional<double> (*read)(const TomlNode&, Sidecar&), Sidecar& sidecar) {
  const TomlNode* node = find(table, key);
  if (!node) return Eigen::Vector3d::Zero();
  if (node->kind != TomlKind::array || node->items.size() != 3) {
    sidecar.report.error("seams.bad-value", sidecar.at(*node), "'" + std::string(key) + "' must be a list of three values",
                         "Write x, y and z, each with its unit");
    return std::nullopt;
  }
  Eigen::Vector3d out;
  for (int i = 0; i < 3; ++i) {
    const auto value = read(node->items[static_cast<std::size_t>(i)], sidecar);
    if (!value) return std::nullopt;
    out[i] = *value;
  }
  return out;
}

void read_place(const TomlNode& place, Piece& piece, Sidecar& sidecar) {
  if (!one_each(place, piece, sidecar)) return;
  std::vector<std::optional<Placement>> placements;
  for (const TomlNode& item : place.items) {
    if (item.kind != TomlKind::table || item.items.empty()) {
      placements.push_back(std::nullopt);
      continue;
    }
    refuse_unknown_keys(item, {"shift", "turn"}, sidecar.file, "seam.unknown-key", sidecar.report);
    const auto shift = three(item, "shift", length_of, sidecar);
    const auto turn = three(item, "turn", angle_of, sidecar);
    if (!shift || !turn) return;
    const auto about = [](double angle, const Eigen::Vector3d& axis) { return Eigen::AngleAxisd(angle, axis); };
    placements.push_back(Placement{(about(turn->z(), Eigen::Vector3d::UnitZ()) * about(turn->y(), Eigen::Vector3d::UnitY()) *
                                    about(turn->x(), Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix(),
                                   *shift});
  }
  piece.placement = std::move(placements);
}

// Angles about x, y, z with R = Rz Ry Rx.
Eigen::Vector3d turns_of(const Eigen::Matrix3d& r) {
  const double flat = std::hypot(r(0, 0), r(1, 0));
  if (flat < 1e-12) return {std::atan2(-r(1, 2), r(1, 1)), std::atan2(-r(2, 0), flat), 0};
  return {std::atan2(r(2, 1), r(2, 2)), std::atan2(-r(2, 0), flat), std::atan2(r(1, 0), r(0, 0))};
}

std::string three_text(const Eigen::Vector3d& values, double unit, const std::string& name) {
  std::string text;
  for (int i = 0; i < 3; ++i) text += (i ? ", " : "[") + toml_quoted(exact_number(values[i] / unit) + " " + name);
  return text + "]";
}

std::string on_text(const BodyPart& on) {
  return "{ part = " + toml_quoted(on.part) + ", level = " + toml_quoted(on.level) +
         ", drop = " + toml_quoted(exact_number(on.drop * 1e3) + " mm") +
         ", angle = " + toml_quoted(exact_number(on.angle / units::degree) + " deg") +
         (on.grain_round ? ", grain = \"round\"" : "") + " }";
}

}  // namespace

void sit_on_body(const TomlNode& entry, Piece& piece, Sidecar& sidecar) {
  if (const TomlNode* on = find(entry, "on")) read_on(*on, piece, sidecar);
  if (const TomlNode* place = find(entry, "place")) read_place(*place, piece, sidecar);
}

std::string sitting_text(const Piece& piece) {
  std::string text;
  const auto any = [](const auto& list) { return std::any_of(list.begin(), list.end(), [](const auto& x) { return x; }); };
  if (any(piece.body_part)) {
    text += "on = [\n";
    for (const auto& on : piece.body_part) text += "  " + (on ? on_text(*on) : std::string("{}")) + ",\n";
    text += "]\n";
  }
  if (any(piece.placement)) {
    text += "place = [\n";
    for (const auto& place : piece.placement)
      text += "  " +
              (place ? "{ shift = " + three_text(place->translation, 1e-3, "mm") +
                           ", turn = " + three_text(turns_of(place->rotation), units::degree, "deg") + " }"
                     : std::string("{}")) +
              ",\n";
    text += "]\n";
  }
  return text;
}

}  // namespace toile
