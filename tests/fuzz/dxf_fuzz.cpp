// Any bytes as a DXF with a small rule table beside it: read or refused in words, within memory and time.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "formats/dxf_aama/dxf_aama.h"
#include "formats/formats.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toile;
  PatternReadOptions options;
  if (size > 0 && data[size - 1] % 2 == 0) options.unit_in_metres = 1e-3;  // else as the file says
  const auto rules = [](const std::string&, Report&) {
    GradeTable table;
    table.sizes = {"36", "38", "40"};
    table.sample_size = "38";
    for (int rule = 0; rule < 8; ++rule) table.rules[rule] = {{-rule, -.5 * rule}, {0, 0}, {rule, .5 * rule}};
    return std::optional<GradeTable>(table);
  };
  const Loaded<PatternFile> loaded =
      read_dxf_pattern_bytes({reinterpret_cast<const char*>(data), size}, "fuzz.dxf", options, rules);
  if (loaded.value.has_value() != loaded.report.ok()) std::abort();
  if (!loaded.value) return 0;
  const PatternFile& file = *loaded.value;
  if (file.facts.size() != file.pattern.pieces.size()) std::abort();
  if (!file.graded.empty() && file.graded.size() != file.sizes.size()) std::abort();
  for (const Pattern& size_of : file.graded)
    if (size_of.pieces.size() != file.pattern.pieces.size()) std::abort();
  for (const Piece& piece : file.pattern.pieces) {
    if (piece.outline.empty() || !(signed_area(piece) > 0)) std::abort();
    for (const Edge& edge : piece.outline)
      for (const OutlinePoint& point : edge.points)
        if (!std::isfinite(point.at.x()) || !std::isfinite(point.at.y())) std::abort();
    for (const Notch& notch : piece.notches)
      if (!find_edge(piece, notch.edge) || !(notch.at >= 0 && notch.at <= 1)) std::abort();
  }
  return 0;
}
