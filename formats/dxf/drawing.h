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

// Circles, arcs, ellipses and splines are polylines too: see read_drawing.
enum class Kind { line, point, text, polyline, insert, other };

struct Entity {
  Kind kind = Kind::other;
  std::string type;  // as the file says: "LWPOLYLINE"
  std::string layer;
  int line = 0;                         // of the file
  std::vector<Eigen::Vector2d> points;  // LINE two; POINT, TEXT and INSERT one; a polyline any number
  std::vector<double> bulges;           // of a polyline: tan(angle / 4) of the arc from each vertex to the next, 0 straight
  int degree = 0;                       // of a spline, whose control points `points` are; 0: no spline
  std::vector<double> knots, weights;   // of a spline; weights empty: all 1
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

// Reads HEADER variables, BLOCKS and ENTITIES; other sections are passed over. ARC and CIRCLE become polylines with bulges,
// ELLIPSE and SPLINE splines (kind polyline, type as in the file); any other entity keeps its type and layer only
// (Kind::other). Texts are UTF-8 without drawing codes, every paragraph of an MTEXT a text of its own. An extrusion that looks
// from below mirrors. Errors: those of read_tags, "dxf.truncated" (a section, block or polyline is not ended),
// "dxf.not-a-number" (a coordinate is no finite number of at most 1e9), "dxf.incomplete-entity", "dxf.broken-tag",
// "dxf.too-large" (256 MB). Warnings "dxf.no-eof", "dxf.insert-array"; and those of decode.
Loaded<Drawing> read_drawing(std::string_view bytes, const std::string& name);

// A polyline's points with its arcs or its spline replaced by chords no farther than `chord` (file units) from them.
std::vector<Eigen::Vector2d> flattened(const Entity& polyline, double chord);

}  // namespace toile::dxf
