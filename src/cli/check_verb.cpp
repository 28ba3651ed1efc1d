#include "cli/check_verb.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/exit_codes.h"
#include "cli/proposed_seams.h"
#include "formats/formats.h"
#include "formats/seams/ease.h"
#include "garment/units.h"
#include "pairing/seam_check.h"

namespace toile {
namespace {

constexpr double warn_at = 1e-3, fail_at = 3e-3;  // m
constexpr double a_hair = 1e-6;                   // m, of rounding

const char* verdict(const SeamCheck& check) {
  const double worst = std::max(check.mismatch, check.notch_mismatch);
  return worst >= fail_at - a_hair ? "fail" : worst >= warn_at - a_hair ? "warn" : "ok";
}

std::string both_units(double metres) {
  char text[48];
  std::snprintf(text, sizeof text, "%.1f mm (%.3f in)", metres * mm_per_m, metres / .0254);
  return text;
}

std::string span_name(const EdgeSpan& span) { return span.piece + ":" + std::to_string(span.copy) + "." + span.edge; }

nlohmann::json in_json(const SeamCheck& check) {
  nlohmann::json notches = nlohmann::json::array();
  for (const NotchCheck& notch : check.notches)
    notches.push_back({{"a_mm", notch.on_a * mm_per_m}, {"b_mm", notch.on_b * mm_per_m}});
  return {{"seam", check.seam},
          {"a", span_name(check.a)},
          {"b", span_name(check.b)},
          {"a_mm", check.length_a * mm_per_m},
          {"b_mm", check.length_b * mm_per_m},
          {"ease_mm", check.ease * mm_per_m},
          {"mismatch_mm", check.mismatch * mm_per_m},
          {"mismatch_inch", check.mismatch / .0254},
          {"notches", notches},
          {"notch_mismatch_mm", check.notch_mismatch * mm_per_m},
          {"lonely_notches", check.lonely_notches},
          {"verdict", verdict(check)}};
}

void print(const SeamCheck& check) {
  std::printf("%-5s %s: %s to %s, %s and %s", verdict(check), check.seam.c_str(), span_name(check.a).c_str(),
              span_name(check.b).c_str(), both_units(check.length_a).c_str(), both_units(check.length_b).c_str());
  if (check.ease > 0) std::printf(", ease %s", both_units(check.ease).c_str());
  std::printf(": %s apart", both_units(check.mismatch).c_str());
  for (const NotchCheck& notch : check.notches)
    std::printf("; notches at %s and %s", in_mm(notch.on_a).c_str(), in_mm(notch.on_b).c_str());
  if (check.lonely_notches) std::printf("; %d notches without a partner", check.lonely_notches);
  std::printf("\n");
}

}  // namespace

int check_pattern(const CheckOptions& options) {
  PatternReadOptions read;
  read.seams = options.seams ? options.seams : seams_beside(options.pattern);
  read.size = options.size;
  if (!options.units.empty()) {
    const auto unit = parse_length("1" + options.units);
    if (!unit)
      throw BadInput(
          {"option.no-length", Severity::error, "--units", "'" + options.units + "' is no unit", "Write mm, cm, m or in"});
    read.unit_in_metres = *unit;
  }
  Loaded<Pattern> loaded = read_pattern(options.pattern, read);
  for (const Finding& finding : loaded.report.findings)
    if (finding.severity != Severity::note && finding.code != "seam.length")
      std::fprintf(stderr, "toile: %s\n", in_words(finding).c_str());
  Pattern pattern = value_or_throw(std::move(loaded));
  std::map<std::string, double> ease;
  if (read.seams) ease = meant_ease(value_or_throw(read_whole_file(*read.seams)), read.seams->filename().string(), pattern);
  const bool proposed = pattern.seams.empty();
  if (proposed) pattern = propose(pattern).pattern;
  const std::vector<SeamCheck> checks = check_seams(pattern, ease);
  int failed = 0, warned = 0;
  for (const SeamCheck& check : checks) {
    const std::string word = verdict(check);
    failed += word == "fail";
    warned += word == "warn";
  }
  if (options.json) {
    nlohmann::json seams = nlohmann::json::array();
    for (const SeamCheck& check : checks) seams.push_back(in_json(check));
    const nlohmann::json all = {{"schema", 1},
                                {"pattern", options.pattern.filename().string()},
                                {"seams_proposed", proposed},
                                {"failed", failed},
                                {"warned", warned},
                                {"seams", seams}};
    std::printf("%s\n", all.dump(2).c_str());
  } else {
    for (const SeamCheck& check : checks) print(check);
    std::printf("%zu seams%s: %d fail (3 mm or more), %d warn (1 mm or more)\n", checks.size(),
                proposed ? ", which the program proposes itself" : "", failed, warned);
  }
  return failed ? exit_checks_failed : exit_ok;
}

}  // namespace toile
