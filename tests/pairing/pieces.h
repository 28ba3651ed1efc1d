#pragma once
// Small garments of rectangles and triangles, cut from nothing but corners.

#include <string>
#include <vector>

#include "formats/garment_template/garment_template.h"
#include "garment/pattern.h"

namespace toile::test {

// Corners counter-clockwise, m; edges "e0", "e1", ... between them.
inline Piece polygon(const std::string& name, const std::vector<Eigen::Vector2d>& corners) {
  Piece piece;
  piece.name = name;
  for (std::size_t k = 0; k < corners.size(); ++k)
    piece.outline.push_back(
        {"e" + std::to_string(k), {{corners[k], true, {}}, {corners[(k + 1) % corners.size()], true, {}}}, {}, false});
  return piece;
}

// Wider at the hem than at the waist: e0 hem, e1 right, e2 waist, e3 left.
inline Piece skirt_half(const std::string& name, double waist = .36) {
  return polygon(name, {{-.3, 0}, {.3, 0}, {waist / 2, .6}, {-waist / 2, .6}});
}

inline std::vector<GarmentTemplate> templates() {
  return value_or_throw(read_garment_templates(std::string(TOILE_SOURCE_DIR) + "/templates/garments"));
}

}  // namespace toile::test
