#pragma once
// An OBJ text line by line, before tinyobjloader reads it: every number is looked at, because it takes "nan" for 0 and drops
// faces that name a vertex which is not there.

#include <string>
#include <vector>

#include "garment/report.h"

namespace toile {

// What a face stands under; empty where the file says nothing.
struct ObjNames {
  std::string group, object, material;
  bool operator==(const ObjNames&) const = default;
};

struct ObjLines {
  long vertices = 0, textures = 0, faces = 0;
  std::vector<ObjNames> names;
  std::vector<int> names_of_face;  // index into `names`, by face in the file's order
  std::vector<long> line_of_face;
};

// Errors carry PLACE:LINE: "body.not-finite" ("obj.not-finite" with texture) for nan or inf, "body.too-far" ("obj.too-far")
// beyond 1e9, "obj.not-a-number", "obj.bad-face", "obj.no-such-vertex", "obj.no-faces". `with_texture`: texture coordinates
// (vt) are needed and looked at too, with "obj.no-vt" naming the first face that has none.
ObjLines check_obj_lines(const std::string& text, const std::string& place, bool with_texture, Report& report);

}  // namespace toile
