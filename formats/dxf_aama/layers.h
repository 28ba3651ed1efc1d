#pragma once
// What AAMA/ASTM pattern files put on which layer. Reader, writer, README and tests all go by this table.

#include <string_view>

#include "garment/pattern.h"

namespace toile::aama {

enum class Role {
  cut_line,
  turn_point,
  curve_point,
  notch,
  grade_reference,
  mirror_line,
  grain_line,
  internal_line,
  match_line,
  cut_out,
  drill_hole,
  sew_line,
  plotted_text,
  dense_cut_line,
  dense_internal_line,
  dense_cut_out,
  dense_sew_line,
  unknown
};

// What is drawn there: closed lines, open or closed lines, one straight line, points, nothing but text.
enum class Shape { closed, lines, segment, points, text };

struct Layer {
  std::string_view number;
  std::string_view name;
  Role role;
  Shape shape;
  bool read;                          // otherwise passed over
  bool written;                       // by write_dxf_aama
  NotchKind notch = NotchKind::slit;  // of a notch layer; group 39 > 0 makes a slit a V
};

// clang-format off
inline constexpr Layer layers[] = {
    {"1",  "piece boundary (cut line) and texts",     Role::cut_line,            Shape::closed,  true,  true},
    {"2",  "turn points",                             Role::turn_point,          Shape::points,  true,  true},
    {"3",  "curve points",                            Role::curve_point,         Shape::points,  true,  true},
    {"4",  "slit and V notches",                      Role::notch,               Shape::points,  true,  true, NotchKind::slit},
    {"5",  "grade reference line",                    Role::grade_reference,     Shape::segment, true,  false},
    {"6",  "mirror line of a half piece",             Role::mirror_line,         Shape::segment, true,  false},
    {"7",  "grain line",                              Role::grain_line,          Shape::segment, true,  true},
    {"8",  "internal lines",                          Role::internal_line,       Shape::lines,   true,  true},
    {"9",  "stripe reference lines",                  Role::match_line,          Shape::segment, false, false},
    {"10", "plaid reference lines",                   Role::match_line,          Shape::segment, false, false},
    {"11", "internal cut-outs",                       Role::cut_out,             Shape::closed,  true,  true},
    {"13", "drill holes",                             Role::drill_hole,          Shape::points,  true,  true},
    {"14", "sew line",                                Role::sew_line,            Shape::closed,  true,  true},
    {"15", "plotted text",                            Role::plotted_text,        Shape::text,    false, false},
    {"80", "T notches",                               Role::notch,               Shape::points,  true,  true, NotchKind::t},
    {"81", "castle notches",                          Role::notch,               Shape::points,  true,  true, NotchKind::castle},
    {"82", "check notches",                           Role::notch,               Shape::points,  true,  true, NotchKind::check},
    {"83", "U notches",                               Role::notch,               Shape::points,  true,  true, NotchKind::u},
    {"84", "boundary, sampled densely",               Role::dense_cut_line,      Shape::closed,  true,  false},
    {"85", "internal lines, sampled densely",         Role::dense_internal_line, Shape::lines,   true,  false},
    {"86", "internal cut-outs, sampled densely",      Role::dense_cut_out,       Shape::closed,  true,  false},
    {"87", "sew line, sampled densely",               Role::dense_sew_line,      Shape::closed,  true,  false},
};
// clang-format on

// The table's row; nullptr for a layer it does not know.
constexpr const Layer* find_layer(std::string_view number) {
  for (const Layer& layer : layers)
    if (layer.number == number) return &layer;
  return nullptr;
}

constexpr Role role_of(std::string_view number) {
  const Layer* layer = find_layer(number);
  return layer ? layer->role : Role::unknown;
}

// The number of the first layer with that role; it must be in the table.
constexpr std::string_view number_of(Role role) {
  for (const Layer& layer : layers)
    if (layer.role == role) return layer.number;
  return {};
}

// The layer a notch is written to; V notches are slits with a width.
constexpr std::string_view notch_layer(NotchKind kind) {
  for (const Layer& layer : layers)
    if (layer.role == Role::notch && (layer.notch == kind || (kind == NotchKind::v && layer.notch == NotchKind::slit)))
      return layer.number;
  return {};
}

}  // namespace toile::aama
