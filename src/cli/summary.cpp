#include "cli/summary.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "garment/units.h"

namespace toile {
namespace {

using Json = nlohmann::ordered_json;

// A measure rounded to what it can mean, so that the file reads well. JSON has no NaN: it must never come to that.
double rounded(double value, int digits) {
  if (!std::isfinite(value)) throw std::runtime_error("summary: a measure is not finite");
  const double scale = std::pow(10, digits);
  return std::round(value * scale) / scale;
}

double percent(double metres, const Job& job) { return rounded(100 * metres / job.scene.body.form.height, 4); }
double mm(double metres) { return rounded(metres * mm_per_m, 4); }

const char* severity(Severity s) { return s == Severity::error ? "error" : s == Severity::warning ? "warning" : "note"; }

Json step_json(const AdjustStep& step, const Job& job) {
  return {{"hausdorff_percent", percent(step.hausdorff, job)},
          {"mean_percent", percent(step.mean, job)},
          {"hausdorff_mm", mm(step.hausdorff)},
          {"mean_mm", mm(step.mean)},
          {"stretch", rounded(step.stretch, 6)},
          {"worst_stretch", rounded(step.worst_stretch, 6)},
          {"seam_mismatch_mm", mm(step.seam_mismatch)},
          {"contracting", rounded(step.contracting, 4)},
          {"embedding_distortion", rounded(step.embedding_distortion, 6)},
          {"residual", step.residual},
          {"slipped_mm", mm(step.slipped)},
          {"seconds", rounded(step.seconds, 3)}};
}

Json drape_json(const Drape& drape) {
  return {{"simulator", drape.simulator},
          {"settled", drape.settled},
          {"residual", drape.residual},
          {"steps", drape.steps},
          {"max_penetration_mm", mm(drape.max_penetration)},
          {"slipped_mm", mm(drape.slipped)},
          {"inverted_triangles", drape.inverted_triangles},
          {"seconds", rounded(drape.seconds, 3)}};
}

}  // namespace

std::string summary_json(const Job& job, const std::vector<std::string>& files) {
  const Mannequin& form = job.scene.body.form;
  Json drape = drape_json(job.worn.drape);
  drape["seam_gap_mm"] = mm(job.worn.seam_gap);
  drape["tolerance"] = job.recipe.drape.tolerance;
  Json adjusted = step_json(job.verified.step, job);
  adjusted["stop"] = in_words(job.adjustment.stop);
  adjusted["steps"] = Json::array();
  for (const AdjustStep& step : job.adjustment.steps) adjusted["steps"].push_back(step_json(step, job));
  adjusted["best_step"] = job.adjustment.best;
  adjusted["seam_mismatch_mm"] = mm(job.redrawn.seam_mismatch);
  adjusted["seconds"] = rounded(job.adjustment.seconds, 3);
  adjusted["redrape"] = drape_json(job.verified.drape);
  Json findings = Json::array();
  for (const Finding& finding : job.findings)
    findings.push_back({{"code", finding.code}, {"severity", severity(finding.severity)}, {"place", finding.place}, {"text", finding.text}, {"remedy", finding.remedy}});
  const Json summary = {
      {"schema", 1},
      {"program", std::string("toile ") + TOILE_VERSION},
      {"name", job.recipe.name},
      {"mannequin", {{"name", form.name}, {"height_m", rounded(form.height, 6)}}},
      {"fabric", job.scene.fabric.name},
      {"garment",
       {{"triangles", triangle_count(job.worn.garment)},
        {"vertices", job.worn.garment.vertex_count},
        {"panels", job.worn.garment.panels.size()},
        {"pieces", job.worn.pattern.pieces.size()},
        {"seams", job.worn.pattern.seams.size()}}},
      {"drape", drape},
      {"edit",
       {{"count", job.recipe.edits.size()},
        {"normal_deviation_mean_deg", rounded(job.target.normal_deviation_mean / degree, 4)},
        {"normal_deviation_max_deg", rounded(job.target.normal_deviation_max / degree, 4)}}},
      {"flattened", step_json(job.flattened, job)},
      {"adjusted", adjusted},
      {"outlines",
       {{"max_deviation_mm", mm(job.redrawn.max_deviation)}, {"symmetry_mm", mm(job.redrawn.symmetry)}, {"seam_mismatch_mm", mm(job.redrawn.seam_mismatch)}}},
      {"findings", findings},
      {"files", files}};
  return summary.dump(2) + "\n";
}

std::string verdict(const Job& job) {
  char words[512];
  const double h = job.scene.body.form.height;
  std::snprintf(words, sizeof words, "%s: off the target by %.1f mm (%.2f %% of height) as flattened, %.1f mm (%.2f %%) as adjusted, mean %.2f mm; seams match within %.2f mm",
                job.recipe.name.c_str(), job.flattened.hausdorff * mm_per_m, 100 * job.flattened.hausdorff / h, job.verified.step.hausdorff * mm_per_m,
                100 * job.verified.step.hausdorff / h, job.verified.step.mean * mm_per_m, job.redrawn.seam_mismatch * mm_per_m);
  return words;
}

}  // namespace toile
