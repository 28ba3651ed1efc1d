#include <cmath>
#include <nlohmann/json.hpp>

#include "formats/inspection/inspection.h"

namespace toile {
namespace {

using Json = nlohmann::ordered_json;

// Rounded to `digits` after the point, never -0.
double rounded(double value, double steps) { return std::round(value * steps) / steps + 0.0; }

const char* word(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json piece(const PieceRow& row) {
  Json to = Json::object();
  to["name"] = row.name;
  to["size"] = text_or_null(row.size);
  to["quantity"] = row.as_drawn + row.mirrored;
  to["quantity_as_drawn"] = row.as_drawn;
  to["quantity_mirrored"] = row.mirrored;
  to["material"] = text_or_null(row.material);
  to["width_mm"] = rounded(row.width_mm, 1e3);
  to["height_mm"] = rounded(row.height_mm, 1e3);
  to["area_mm2"] = rounded(row.area_mm2, 10);
  to["outline_points"] = row.outline_points;
  to["turn_points"] = row.turn_points;
  to["curve_points"] = row.curve_points;
  to["notches"] = row.notches;
  to["drill_holes"] = row.drill_holes;
  to["internal_lines"] = row.internal_lines;
  to["has_sew_line"] = row.has_sew_line;
  to["sew_line_source"] = text_or_null(row.sew_line_source);
  to["mirrored"] = row.unfolded;
  to["grainline_deg"] = row.grainline_deg ? Json(rounded(*row.grainline_deg, 1e3)) : Json();
  to["graded_points"] = row.graded_points;
  return to;
}

Json seam_end(const EdgeSpan& span) {
  return {{"piece", span.piece},
          {"copy", span.copy},
          {"edge", span.edge},
          {"begin", rounded(span.begin, 1e6)},
          {"end", rounded(span.end, 1e6)}};
}

}  // namespace

std::string inspection_json(const Loaded<PatternFile>& loaded, const std::vector<PieceRow>& rows) {
  static const PatternFile none;
  const PatternFile& file = loaded.value ? *loaded.value : none;
  Json to = Json::object();
  to["schema"] = 1;
  to["format"] = text_or_null(file.format);
  to["dialect"] = text_or_null(file.dialect);
  to["author"] = text_or_null(file.author);
  to["units"] = {{"name", text_or_null(file.units.name)}, {"decided_by", text_or_null(file.units.decided_by)}};
  to["sizes"] = file.sizes;
  to["sample_size"] = text_or_null(file.sample_size.empty() ? file.pattern.sample_size : file.sample_size);
  to["graded_by"] = text_or_null(file.graded_by);
  to["pieces"] = Json::array();
  for (const PieceRow& row : rows) to["pieces"].push_back(piece(row));
  to["seams"] = Json::array();
  for (const Seam& seam : file.pattern.seams)
    to["seams"].push_back(
        {{"name", seam.name}, {"a", seam_end(seam.a)}, {"b", seam_end(seam.b)}, {"right_to_wrong", seam.right_to_wrong}});
  to["findings"] = Json::array();
  for (const Finding& finding : loaded.report.findings)
    to["findings"].push_back({{"code", finding.code},
                              {"severity", word(finding.severity)},
                              {"place", finding.place},
                              {"text", finding.text},
                              {"remedy", finding.remedy}});
  return to.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace toile
