#pragma once
// The faces of an OBJ text with their texture coordinates (tinyobjloader behind it).

#include <Eigen/Core>
#include <string>
#include <vector>

#include "formats/obj/line_check.h"
#include "garment/report.h"

namespace toile {

struct ObjCorner {
  int vertex = 0, texture = 0;
  auto operator<=>(const ObjCorner&) const = default;
};

struct ObjFaces {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix2Xd textures;
  std::vector<std::vector<ObjCorner>> polygons;  // in the file's order, three corners and more
  ObjLines lines;
};

// Errors as check_obj_lines with texture has them.
Loaded<ObjFaces> read_obj_faces(const std::string& text, const std::string& place);

// A polygon as triangles of its corners' numbers, all turning as the polygon does: ears cut off, the best shaped first. Fewer
// than size - 2 triangles when the polygon crosses itself or has no area.
std::vector<Eigen::Vector3i> split_polygon(const std::vector<Eigen::Vector2d>& polygon);

}  // namespace toile
