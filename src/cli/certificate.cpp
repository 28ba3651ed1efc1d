#include "cli/certificate.h"

#include <cstdio>

#include "cli/exit_codes.h"
#include "garment/units.h"

namespace toile {
namespace {

std::string off_target(const std::string& what, const AdjustStep& step, double height) {
  char words[160];
  std::snprintf(words, sizeof words, "%s: mean %.2f mm (%.3f %% of height), worst %.1f mm (%.2f %%), S %.4f", what.c_str(),
                step.mean * mm_per_m, 100 * step.mean / height, step.hausdorff * mm_per_m, 100 * step.hausdorff / height,
                step.stretch);
  return words;
}

}  // namespace

std::vector<std::string> made_from(const Job& job) {
  constexpr std::size_t longest = 200;
  std::vector<std::string> lines{std::string("Made by toile ") + TOILE_VERSION + " from "};
  for (std::size_t i = 0; i < job.inputs.size(); ++i) {
    const std::string words = in_short(job.inputs[i]) + (i + 1 < job.inputs.size() ? ", " : "");
    if (i > 0 && lines.back().size() + words.size() > longest) lines.emplace_back();
    lines.back() += words;
  }
  return lines;
}

std::vector<std::string> certificate(const Job& job) {
  const double height = job.scene.body.form.height;
  std::vector<std::string> lines{job.recipe.name};
  lines.push_back(off_target("Re-drape of this pattern against its 3D target", job.verified.step, height));
  lines.push_back(off_target("Plain flattening of the target, for comparison", job.flattened, height));
  char words[240];
  std::snprintf(words, sizeof words,
                "Seams match within %.2f mm. Adjusted in %zu drapes (%s). Draped on %s by %s, tolerance %.0e",
                job.redrawn.seam_mismatch * mm_per_m, job.adjustment.steps.size(), in_words(job.adjustment.stop).c_str(),
                job.scene.body.form.name.c_str(), job.scene.simulator.name.c_str(), job.recipe.drape.tolerance);
  lines.emplace_back(words);
  lines.push_back("Fabric: " + job.scene.fabric.name +
                  (exit_code(job) == exit_ok ? "" : ". NOT ALL CHECKS WERE PASSED: see report.html"));
  for (const std::string& line : made_from(job)) lines.push_back(line);
  return lines;
}

}  // namespace toile
