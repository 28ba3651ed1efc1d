#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_aama/rules_beside.h"
#include "formats/formats.h"

namespace toile {
namespace {

Loaded<Pattern> pattern_of(Loaded<PatternFile> loaded) {
  if (!loaded.value) return {std::nullopt, std::move(loaded.report)};
  return {std::move(loaded.value->pattern), std::move(loaded.report)};
}

}  // namespace

Loaded<PatternFile> read_dxf_pattern(const std::filesystem::path& file, const PatternReadOptions& options) {
  Loaded<std::string> bytes = read_whole_file(file);
  if (!bytes.value) return {std::nullopt, std::move(bytes.report)};
  Report report = std::move(bytes.report);
  // A table that cannot be read costs the other sizes only.
  const FindRules find_rules = [&](const std::string& named, Report& to) -> std::optional<GradeTable> {
    const auto beside = aama::rules_beside(file, named);
    if (!beside) return {};
    const Loaded<std::string> text = read_whole_file(*beside);
    Loaded<GradeTable> table{std::nullopt, text.report};
    if (text.value) table = read_rul_bytes(*text.value, beside->filename().string());
    for (Finding& finding : table.report.findings)
      if (finding.severity == Severity::error) finding.severity = Severity::warning;
    to.append(table.report);
    return std::move(table.value);
  };
  Loaded<PatternFile> loaded = read_dxf_pattern_bytes(*bytes.value, file.filename().string(), options, find_rules);
  report.append(loaded.report);
  if (!report.ok()) loaded.value.reset();
  return {std::move(loaded.value), std::move(report)};
}

Loaded<Pattern> read_dxf_aama_bytes(std::string_view bytes, const std::string& name, std::optional<double> unit_in_metres) {
  PatternReadOptions options;
  options.unit_in_metres = unit_in_metres;
  return pattern_of(read_dxf_pattern_bytes(bytes, name, options));
}

Loaded<Pattern> read_dxf_aama(const std::filesystem::path& file, std::optional<double> unit_in_metres) {
  PatternReadOptions options;
  options.unit_in_metres = unit_in_metres;
  return pattern_of(read_dxf_pattern(file, options));
}

}  // namespace toile
