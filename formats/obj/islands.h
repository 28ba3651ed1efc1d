#pragma once
// The islands of a texture: each is one pattern piece laid flat.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "formats/obj/faces.h"
#include "garment/report.h"

namespace toile {

// Triangles that hang together in the texture. Its vertices are pairs of a vertex and a texture coordinate of the file.
struct Island {
  std::string name;                     // each once; where the file names nothing "piece 1", ...
  std::vector<int> vertex;              // by island vertex: the file's vertex
  Eigen::Matrix2Xd flat;                // by island vertex: texture coordinates, counter-clockwise seen from the faces' outside
  Eigen::Matrix3Xi triangles;           // island vertices, counter-clockwise
  bool turned_over = false;             // the file shows its other side; `flat` is reflected
  std::vector<std::vector<int>> loops;  // boundaries with the island on their left, the outermost first; each starts at a
                                        // vertex that comes first in the file
  long line = 0;                        // of its first face
};

// Islands in the order of their first faces. Errors, naming the island and a line: "obj.not-manifold" (three faces at an edge,
// or two corners of the outline in one point), "obj.degenerate-island" (no area), "obj.folded-island" (parts of it lie the
// wrong way round, or a face crosses itself), "obj.closed-island" (no outline at all). Note "obj.polygons-split".
Loaded<std::vector<Island>> islands_of(const ObjFaces& faces, const std::string& place);

}  // namespace toile
