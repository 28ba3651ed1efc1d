#include "cli/edit_verb.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "cli/account.h"
#include "cli/job.h"
#include "cli/output_folder.h"
#include "cli/pictures.h"
#include "cli/recipe_file.h"
#include "cli/stuck.h"
#include "cli/templates.h"
#include "cli/write_run.h"
#include "formats/formats.h"
#include "garment/units.h"

namespace toile {
namespace {

std::string verdict_of(const Job& job) {
  const double furthest = (job.target.positions - job.target.source).colwise().norm().maxCoeff();
  char words[512];
  std::snprintf(words, sizeof words,
                "%s: %zu edits, moved by %.1f mm at most, normals turned by %.1f degrees in the mean, %.1f at most",
                job.recipe.name.c_str(), job.recipe.edits.size(), furthest * mm_per_m,
                job.target.normal_deviation_mean / units::degree, job.target.normal_deviation_max / units::degree);
  return words;
}

ReportFact energy(const std::string& name, double before, double after) {
  char words[96];
  std::snprintf(words, sizeof words, "%.3g before, %.3g after", before, after);
  return {name, words};
}

std::vector<ReportFact> style_facts(const Target& target) {
  return {energy("style energy of shape", target.before.shape, target.after.shape),
          energy("style energy of proportion", target.before.proportion, target.after.proportion),
          energy("style energy of fit", target.before.fit, target.after.fit)};
}

}  // namespace

int edit_recipe(const RunOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  Progress progress(options.progress);
  Job job;
  job.recipe_file = options.recipe;
  job.recipe = value_or_throw(read_recipe(options.recipe));
  OutputFolder out(options.out, options.force);
  load(job, progress);
  try {
    drape(job, progress, with_stuck_picture(watched(progress), job, out));
    make_target(job, progress);
  } catch (const BadInput&) {
    keep_stuck_picture(job, out);
    throw;
  }
  job.girths = girth_table(job.target.garment, job.target.positions, job.scene.body.form);
  write_obj(out.path("source.obj"), job.worn.garment, job.worn.drape.positions);
  write_obj(out.path("target.obj"), job.target.garment, job.target.positions);
  write_obj(out.path("body.obj"), job.scene.body.form);
  const ShownPictures pictures = write_edit_pictures(job, out);
  std::vector<std::string> files = out.names();
  files.insert(files.end(), {"report.html", "summary.json"});
  std::sort(files.begin(), files.end());
  job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  RunReport report = report_of_drape(job, pictures, files);
  report.verdict = verdict_of(job);
  report.drape_heading = "Source drape and edits";
  for (const ReportFact& fact : style_facts(job.target)) report.drape.push_back(fact);
  report.recipe = value_or_throw(read_whole_file(options.recipe));
  write_report(out.path("report.html"), report, template_file("reports", "report.html"));
  RunSummary summary = summary_of_drape(job, files);
  summary.verdict = verdict_of(job);
  summary.ok = exit_code(job) == 0;
  summary.only_draped = true;
  write_summary(out.path("summary.json"), summary);
  out.keep();
  say(job, options.quiet);
  std::printf("%s; files in %s\n", verdict_of(job).c_str(), out.folder().string().c_str());
  return exit_code(job);
}

}  // namespace toile
