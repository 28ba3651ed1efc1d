#include "cli/grade_verb.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <sstream>

#include "cli/account.h"
#include "cli/exit_codes.h"
#include "cli/graded_files.h"
#include "cli/job.h"
#include "cli/output_folder.h"
#include "cli/recipe_file.h"
#include "cli/stuck.h"
#include "cli/templates.h"
#include "cli/write_run.h"
#include "cut/cut.h"
#include "formats/formats.h"
#include "formats/html/grading.h"
#include "workbench/graded.h"

namespace toile {
namespace {

// What is kept of a size once it is written.
struct Done {
  std::string size;
  Pattern pattern;
  GradingSize row;
  int code = exit_ok;
};

std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> sizes;
  std::istringstream in(text);
  for (std::string size; std::getline(in, size, ',');) {
    size.erase(0, size.find_first_not_of(' '));
    size.erase(size.find_last_not_of(' ') + 1);
    if (size.empty() || std::find(sizes.begin(), sizes.end(), size) != sizes.end())
      throw BadInput({"option.bad-sizes", Severity::error, "--sizes", "'" + text + "' names a size twice or not at all",
                      "Write sizes of the chart with commas: 34,36,38"});
    sizes.push_back(size);
  }
  if (sizes.empty())
    throw BadInput({"option.bad-sizes", Severity::error, "--sizes", "no size is named", "Write sizes of the chart: 34,36,38"});
  return sizes;
}

GradingSize row_of(const Job& job, const std::string& size, const std::string& png) {
  const RunSummary summary = summary_of(job, {});
  GradingSize row;
  row.size = row.folder = size;
  row.body = job.scene.body.form.name;
  row.height = job.scene.body.form.height;
  row.mean = job.verified.step.mean;
  row.hausdorff = job.verified.step.hausdorff;
  row.stretch = job.verified.step.stretch;
  row.seam_mismatch = job.redrawn.seam_mismatch;
  row.ok = summary.ok;
  for (const Finding& finding : job.findings)
    if (finding.severity == Severity::error && row.trouble.empty()) row.trouble = finding.text;
  row.girths = summary.girths;
  row.png = png;
  return row;
}

// A size of `base`, whose drape and edits it shares.
Done make_size(const Job& base, const std::string& size, const GradeOptions& options, const std::string& recipe_text,
               Progress& progress) {
  const auto began = std::chrono::steady_clock::now();
  Job job = base;
  if (size != base.recipe.body.size) job.recipe.edits.push_back({"grade", {{"size", size}}, "--sizes"});
  job.recipe.name += ", size " + size;
  OutputFolder out(options.out / size, options.force);
  make_target(job, progress);
  job.pattern.sample_size = job.worn.pattern.sample_size = size;
  finish_run(job, out, recipe_text, began, progress);
  const std::string png = value_or_throw(read_whole_file(out.path("redrape.png")));
  out.keep();
  std::fprintf(stderr, "%s", options.quiet ? "" : ("toile: size " + size + ": " + verdict(job) + "\n").c_str());
  for (const Finding& finding : job.findings)
    if (finding.severity == Severity::error || (finding.severity == Severity::warning && !options.quiet))
      std::fprintf(stderr, "toile: size %s: %s\n", size.c_str(), in_words(finding).c_str());
  return {size, job.redrawn.pattern, row_of(job, size, png), exit_code(job)};
}

// The recipe's size, or the first where it is not asked for.
std::size_t base_of(const Job& base, const std::vector<Done>& sizes) {
  const auto found = std::find_if(sizes.begin(), sizes.end(), [&](const Done& d) { return d.size == base.recipe.body.size; });
  return found == sizes.end() ? 0 : static_cast<std::size_t>(found - sizes.begin());
}

GradingReport report_on(const Job& recipe, const std::vector<Done>& sizes) {
  GradingReport report;
  const std::size_t base = base_of(recipe, sizes);
  report.base = sizes[base].size;
  report.title = recipe.recipe.name + ", sizes";
  for (const Done& done : sizes) report.title += (done.size == sizes.front().size ? " " : ", ") + done.size;
  std::vector<Pattern> patterns;
  for (const Done& done : sizes) {
    report.sizes.push_back(done.row);
    patterns.push_back(done.pattern);
  }
  for (std::size_t p = 0; p < patterns.front().pieces.size(); ++p) {
    GradingPiece piece{patterns.front().pieces[p].name, {}, {}};
    for (const Pattern& pattern : patterns) {
      Eigen::AlignedBox2d box;
      for (const Edge& edge : pattern.pieces[p].outline)
        for (const OutlinePoint& point : edge.points) box.extend(point.at);
      piece.width.push_back(box.sizes().x());
      piece.height.push_back(box.sizes().y());
    }
    report.pieces.push_back(std::move(piece));
  }
  for (const PointGrade& grade : turn_point_grades(patterns, base)) {
    GradingPoint point{grade.piece, grade.edge, {}, {}};
    for (const Eigen::Vector2d& move : grade.moves) {
      point.dx.push_back(move.x());
      point.dy.push_back(move.y());
    }
    report.points.push_back(std::move(point));
  }
  return report;
}

// All sizes in one file, and the base with rules; both read back.
void write_graded(const Job& base, const std::vector<Done>& sizes, const OutputFolder& out) {
  if (sizes.size() < 2) return;
  PatternFile graded;
  for (const Done& done : sizes) {
    graded.sizes.push_back(done.size);
    graded.graded.push_back(done.pattern);
    graded.graded.back().sample_size = done.size;
  }
  graded.graded = with_same_points(std::move(graded.graded));
  graded.pattern = graded.graded[base_of(base, sizes)];
  const std::string stem = file_stem(base.recipe_file);
  const GradedFiles files = graded_files(graded, stem, base.recipe.cut);
  write_whole_file(out.path(stem + ".nest.dxf"), files.nest);
  write_whole_file(out.path(stem + ".base.dxf"), files.base);
  write_whole_file(out.path(stem + ".rul"), files.rules);
  for (const char* name : {".nest.dxf", ".base.dxf"})
    check_graded(graded, value_or_throw(read_pattern_file(out.path(stem + name))), stem + name);
}

}  // namespace

int grade_recipe(const GradeOptions& options) {
  Progress progress(options.progress);
  Job base;
  base.recipe_file = options.recipe;
  base.recipe = value_or_throw(read_recipe(options.recipe));
  const std::vector<std::string> sizes = listed(options.sizes);
  if (base.recipe.body.size.empty())
    throw BadInput({"edit.no-chart", Severity::error, options.recipe.string(),
                    "the recipe's body is a file, which has no sizes", "Give chart and size in [body]"});
  const auto chart = template_file("mannequins", base.recipe.body.chart + ".csv");
  for (const std::string& size : sizes) value_or_throw(read_size_chart_row(chart, size));
  OutputFolder out(options.out, options.force);
  load(base, progress);
  lay_out(base.pattern, base.recipe.cut);
  try {
    drape(base, progress, with_stuck_picture(watched(progress), base, out));
  } catch (const BadInput&) {
    keep_stuck_picture(base, out);
    throw;
  }
  const std::string recipe_text = value_or_throw(read_whole_file(options.recipe));
  std::vector<Done> done;
  int code = exit_ok;
  for (const std::string& size : sizes) {
    done.push_back(make_size(base, size, options, recipe_text, progress));
    if (code == exit_ok || done.back().code == exit_not_converged) code = done.back().code;
  }
  write_graded(base, done, out);
  GradingReport report = report_on(base, done);
  for (const std::string& file : out.names()) report.files.push_back(file);
  write_grading(out.path("grading.html"), report, template_file("reports", "grading.html"));
  out.keep();
  double worst = 0, mismatch = 0;
  for (const Done& size : done) {
    worst = std::max(worst, size.row.hausdorff / size.row.height);
    mismatch = std::max(mismatch, size.row.seam_mismatch);
  }
  std::printf("%s: %zu sizes, off their targets by at most %.2f %% of height; seams match within %.2f mm; files in %s\n",
              base.recipe.name.c_str(), done.size(), 100 * worst, 1e3 * mismatch, out.folder().string().c_str());
  return code;
}

}  // namespace toile
