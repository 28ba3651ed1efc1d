#pragma once
// The triangles of a Wavefront OBJ text (tinyobjloader behind it).

#include <Eigen/Core>
#include <string>

#include "garment/report.h"

namespace toile {

struct ObjMesh {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi triangles;  // polygons are split; groups, materials, vt and vn are left out
};

// Errors carry FILE:LINE: "body.not-finite" for nan or inf, "body.too-far" beyond 1e9, "obj.not-a-number", "obj.bad-face",
// "obj.no-such-vertex", "obj.no-faces". A note "obj.welded" says when vertices in one place were made one, which is done only
// when it closes gaps.
Loaded<ObjMesh> read_obj_mesh(const std::string& text, const std::string& place);

}  // namespace toile
