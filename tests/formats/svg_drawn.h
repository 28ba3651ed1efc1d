#pragma once
// SVG documents for tests, and what is read of them.

#include <algorithm>
#include <string>

#include "formats/svg_read/svg_read.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile::test {

// A4-like page in mm: 1 unit = 1 mm.
inline std::string svg_mm(const std::string& body, const std::string& attributes = "") {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
         "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' width='1000mm' height='1000mm' viewBox='0 0 1000 "
         "1000' " +
         attributes + ">" + body + "</svg>";
}

inline Loaded<PatternFile> read_text(const std::string& text) { return read_svg_bytes(text, "drawn.svg"); }

inline bool has_finding(const Report& report, const std::string& code) {
  return std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& f) { return f.code == code; });
}

struct Extent {
  double width = 0, height = 0;  // mm
};
inline Extent extent_mm(const Piece& piece) {
  Eigen::Vector2d low = piece.outline.front().points.front().at, high = low;
  for (const Edge& edge : piece.outline)
    for (const OutlinePoint& point : edge.points) {
      low = low.cwiseMin(point.at);
      high = high.cwiseMax(point.at);
    }
  return {(high - low).x() * 1e3, (high - low).y() * 1e3};
}

}  // namespace toile::test
