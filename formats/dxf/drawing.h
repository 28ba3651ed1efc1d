#pragma once
// The entities of a DXF, as far as plane drawings need them, in file units. Knows no garment word.

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "garment/report.h"

namespace toile::dxf {

enum class Kind { line, point, text, polyline, insert, other };

struct Entity {
  Kind kind = Kind::other;
  std::string type;  // as the file says: "LWPOLYLINE"
  std::string layer;
  int line = 0;                         // of the file
  std::vector<Eigen::Vector2d> points;  // LINE two; POINT, TEXT and INSERT one; a polyline any number
  std::vector<double> bulges;           // of a polyline: tan(angle / 4) of the arc from each vertex to the next, 0 straight
  bool closed = false;                  // the polyline's flag; a repeated vertex is not looked for
  std::string text;                     // TEXT: what it says; INSERT: the block's name
  std::optional<double> z, thickness, angle;        // groups 30, 39, 50 (degrees)
  Eigen::Vector2d scale = Eigen::Vector2d::Ones();  // INSERT
};

struct Block {
  std::string name;
  std::string layer;
  Eigen::Vector2d base = Eigen::Vector2d::Zero();
  int line = 0;
  std::vector<Entity> entities;
};

struct Drawing {
  std::map<std::string, std::string> header;  // "$INSUNITS" -> first value
  std::vector<Block> blocks;                  // in file order; names may repeat
  std::vector<Entity> entities;
};

// Reads HEADER variables, BLOCKS and ENTITIES; other sections are passed over. Entities other than LINE, POINT, TEXT, MTEXT,
// POLYLINE, LWPOLYLINE and INSERT keep their type and layer only (Kind::other). Errors: those of read_tags, "dxf.truncated" (a
// section, block or polyline is not ended), "dxf.not-a-number" (a coordinate is no finite number), "dxf.broken-tag". Warning
// "dxf.no-eof".
Loaded<Drawing> read_drawing(std::string_view bytes, const std::string& name);

// The polyline's points with its arcs replaced by chords no farther than `chord` (file units) from them.
std::vector<Eigen::Vector2d> flattened(const Entity& polyline, double chord);

}  // namespace toile::dxf
