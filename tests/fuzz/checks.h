#pragma once
// What every reader owes whatever it is given.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) { return {reinterpret_cast<const char*>(data), size}; }

inline void check_pattern(const Pattern& pattern) {
  for (const Piece& piece : pattern.pieces) {
    require(!piece.outline.empty() && signed_area(piece) > 0);
    for (const Edge& edge : piece.outline) {
      require(edge.points.size() >= 2);
      for (const OutlinePoint& point : edge.points) require(point.at.allFinite());
    }
    for (const Notch& notch : piece.notches) require(find_edge(piece, notch.edge) && notch.at >= 0 && notch.at <= 1);
    for (const auto& place : piece.placement)
      require(!place || (place->rotation.allFinite() && place->translation.allFinite()));
  }
  for (const Seam& seam : pattern.seams)
    require(std::isfinite(span_length(pattern, seam.a)) && std::isfinite(span_length(pattern, seam.b)));
}

// A value, or an error that says where and what to do.
inline void check_file(const Loaded<PatternFile>& loaded) {
  require(loaded.value.has_value() == loaded.report.ok());
  for (const Finding& finding : loaded.report.findings)
    if (finding.severity == Severity::error)
      require(!finding.code.empty() && !finding.place.empty() && !finding.text.empty() && !finding.remedy.empty());
  if (!loaded.value) return;
  const PatternFile& file = *loaded.value;
  require(file.facts.size() == file.pattern.pieces.size());
  require(file.graded.empty() || file.graded.size() == file.sizes.size());
  for (const Pattern& size : file.graded) require(size.pieces.size() == file.pattern.pieces.size());
  check_pattern(file.pattern);
}

}  // namespace toile::fuzz
