#include "cli/drape_verb.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "cli/account.h"
#include "cli/exit_codes.h"
#include "cli/job.h"
#include "cli/output_folder.h"
#include "cli/pictures.h"
#include "cli/stuck.h"
#include "cli/templates.h"
#include "formats/formats.h"
#include "formats/obj/mesh_text.h"
#include "garment/units.h"
#include "measure/girth_table.h"

namespace toile {
namespace {

double length_of(const std::string& option, const std::string& text) {
  const auto length = parse_length(text);
  if (!length || *length <= 0)
    throw BadInput({"option.no-length", Severity::error, option, "'" + text + "' is not a length with its unit",
                    "Write it like \"12 mm\" or \"0.5 in\""});
  return *length;
}

Recipe as_recipe(const DrapeOptions& options) {
  Recipe recipe;
  recipe.name = options.pattern.stem().string();
  recipe.pattern.file = options.pattern;
  recipe.pattern.seams = options.seams;
  if (!options.units.empty()) recipe.pattern.unit_in_metres = length_of("--units", "1" + options.units);
  recipe.body.chart = options.chart;
  recipe.body.size = options.size;
  recipe.body.file = options.body;
  recipe.body.skeleton = options.skeleton;
  const bool is_file = options.fabric.find('/') != std::string::npos || options.fabric.find('.') != std::string::npos;
  if (is_file)
    recipe.fabric.file = options.fabric;
  else
    recipe.fabric.name = options.fabric;
  recipe.drape.simulator = options.simulator;
  recipe.drape.edge_length = length_of("--edge-length", options.edge_length);
  recipe.drape.tolerance = options.tolerance;
  return recipe;
}

// Interrupted, the drape ends with the best state so far instead of throwing it away.
DrapeControl control_of(Progress& progress, const DrapeOptions& options) {
  DrapeControl control = watched(progress);
  control.progress = [shown = control.progress](const DrapeProgress& state) {
    if (!interrupted()) shown(state);
  };
  control.stop = interrupted;
  control.time_limit = options.time_limit;
  return control;
}

std::string verdict_of(const Job& job, int code) {
  const Drape& drape = job.worn.drape;
  char words[512];
  std::snprintf(words, sizeof words,
                "%s on %s: %s, %.2f mm inside the body at most, seams within %.2f mm, %d intersections, dropped by %.1f mm",
                job.recipe.name.c_str(), job.scene.body.form.name.c_str(),
                !job.stuck.png.empty()     ? "did not come together (see stuck.png)"
                : drape.settled            ? "settled"
                : code == exit_interrupted ? "interrupted before it settled"
                                           : "not settled",
                drape.max_penetration * mm_per_m, job.worn.seam_gap * mm_per_m, drape.self_intersections,
                drape.slipped * mm_per_m);
  return words;
}

RunSummary summary(const Job& job, int code, const std::vector<std::string>& files) {
  RunSummary summary = summary_of_drape(job, files);
  summary.verdict = verdict_of(job, code);
  summary.ok = code == exit_ok;
  summary.only_draped = true;
  return summary;
}

}  // namespace

int drape_pattern(const DrapeOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  Progress progress(options.progress);
  Job job;
  job.recipe = as_recipe(options);
  OutputFolder out(options.out, options.force);
  load(job, progress);
  const DrapeControl control = with_stuck_picture(control_of(progress, options), job, out);
  try {
    if (options.go_on) {
      const ObjMesh earlier =
          value_or_throw(read_obj_mesh(value_or_throw(read_whole_file(*options.go_on)), options.go_on->string()));
      drape(job, progress, control, &earlier.positions);
    } else {
      drape(job, progress, control);
    }
  } catch (const BadInput&) {
    keep_stuck_picture(job, out);
    throw;
  }
  const int code = interrupted() ? static_cast<int>(exit_interrupted) : exit_code(job);

  job.girths = girth_table(job.worn.garment, job.worn.drape.positions, job.scene.body.form);
  write_obj(out.path("drape.obj"), job.worn.garment, job.worn.drape.positions);
  write_obj(out.path("body.obj"), job.scene.body.form);
  const ShownPictures pictures = write_drape_pictures(job, out);
  std::vector<std::string> files = out.names();
  files.insert(files.end(), {"report.html", "summary.json"});
  std::sort(files.begin(), files.end());
  job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  RunReport report = report_of_drape(job, pictures, files);
  report.verdict = verdict_of(job, code);
  write_report(out.path("report.html"), report, template_file("reports", "report.html"));
  write_summary(out.path("summary.json"), summary(job, code, files));
  out.keep();
  for (const Finding& finding : job.findings)
    if (finding.severity == Severity::error || !options.quiet) std::fprintf(stderr, "toile: %s\n", in_words(finding).c_str());
  if (!job.worn.drape.settled)
    std::fprintf(stderr, "toile: to go on from here: the same command with --go-on %s\n",
                 (out.folder() / "drape.obj").string().c_str());
  std::printf("%s; files in %s\n", verdict_of(job, code).c_str(), out.folder().string().c_str());
  return code;
}

}  // namespace toile
