#include "cli/bench_verb.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <sstream>

#include "cli/exit_codes.h"
#include "cli/job.h"
#include "cli/output_folder.h"
#include "cli/recipe_file.h"
#include "cli/table1_file.h"
#include "cli/templates.h"
#include "cli/write_run.h"
#include "formats/formats.h"
#include "garment/units.h"
#include "picture/plot.h"

namespace toile {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double worth_sharing = .1;  // of the flattening's error: where less was taken off, nothing is said of its steps

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

struct Measured {
  const TableRow* row = nullptr;
  std::string trouble;  // why there are no figures
  std::string fabric, simulator;
  int triangles = 0;
  double flattened_stretch = 0, stretch = 0, printed_stretch = 0;
  double flattened_hausdorff = 0, hausdorff = 0, mean = 0;  // percent of the height
  int iterations = 0;
  std::optional<double> first_share;  // of what was taken off the flattening's error: by the first iteration
  double seam_mismatch = 0;
  double girth = 0, level = 0;
  bool folds_only = false;
  double dress_seconds = 0, edit_seconds = 0, adjust_seconds = 0, verify_seconds = 0;
  std::vector<double> stretch_by_step, hausdorff_by_step;
  double seconds() const { return edit_seconds + adjust_seconds + verify_seconds; }
};

std::string folder_name(const std::string& row) {
  std::string name;
  for (const char c : row)
    if (std::isalnum(static_cast<unsigned char>(c))) name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

void measure_row(const BenchOptions& options, Progress& progress, Measured& measured) {
  const auto began = Clock::now();
  Job job;
  job.recipe_file = measured.row->recipe;
  job.recipe = value_or_throw(read_recipe(job.recipe_file));
  OutputFolder out(options.out / folder_name(measured.row->name), options.force);
  load(job, progress);
  drape(job, progress, watched(progress));
  measured.dress_seconds = since(began);
  const auto edited = Clock::now();
  make_target(job, progress);
  measured.edit_seconds = since(edited) - job.dressing_others;
  measured.dress_seconds += job.dressing_others;
  finish_run(job, out, value_or_throw(read_whole_file(job.recipe_file)), began, progress);
  out.keep();
  const double percent = 100 / job.scene.body.form.height;
  measured.fabric = job.scene.fabric.name;
  measured.simulator = job.scene.simulator.name;
  measured.triangles = triangle_count(job.target.garment);
  measured.flattened_stretch = job.flattened.stretch;
  measured.flattened_hausdorff = percent * job.flattened.hausdorff;
  measured.stretch = job.verified.step.stretch;
  measured.printed_stretch = job.verified.step.printed_stretch;
  measured.hausdorff = percent * job.verified.step.hausdorff;
  measured.mean = percent * job.verified.step.mean;
  measured.iterations = static_cast<int>(job.adjustment.steps.size()) - 1;
  for (const AdjustStep& step : job.adjustment.steps) {
    measured.stretch_by_step.push_back(step.stretch);
    measured.hausdorff_by_step.push_back(percent * step.hausdorff);
  }
  const double taken = measured.flattened_hausdorff - measured.hausdorff;
  if (measured.hausdorff_by_step.size() > 1 && taken > worth_sharing * measured.flattened_hausdorff)
    measured.first_share = (measured.hausdorff_by_step[0] - measured.hausdorff_by_step[1]) / taken;
  measured.seam_mismatch = job.redrawn.seam_mismatch;
  measured.girth = job.tailoring.girth;
  measured.level = job.tailoring.level;
  measured.folds_only = only_folds_differ(job.tailoring);
  measured.adjust_seconds = job.adjustment.seconds;
  measured.verify_seconds = job.verified.drape.seconds;
}

std::string formatted(const char* form, double value) {
  char text[48];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

std::string csv(const std::vector<Measured>& rows) {
  std::string text =
      "row,triangles,flattened_stretch,flattened_hausdorff_percent,stretch,hausdorff_percent,mean_percent,iterations,"
      "seam_mismatch_mm,seconds,paper_hausdorff_percent\n";
  for (const Measured& m : rows) {
    text += m.row->name;
    if (m.trouble.empty()) {
      text += "," + std::to_string(m.triangles);
      for (const double value : {m.flattened_stretch, m.flattened_hausdorff, m.stretch, m.hausdorff, m.mean})
        text += formatted(",%.4f", value);
      text +=
          "," + std::to_string(m.iterations) + formatted(",%.3f", m.seam_mismatch * mm_per_m) + formatted(",%.1f", m.seconds());
    } else {
      text += ",,,,,,,,,";
    }
    text += formatted(",%.1f\n", m.row->paper.hausdorff);
  }
  return text;
}

std::string for_people(const std::vector<Measured>& rows) {
  std::string text;
  char line[512];
  std::snprintf(line, sizeof line, "%-19s %9s %13s %15s %7s %5s %6s %6s %6s  %s\n", "row", "triangles", "S", "Hausdorff, % h",
                "mean", "iter.", "1st", "seams", "time", "");
  text += line;
  for (const Measured& m : rows) {
    const PaperFigures& p = m.row->paper;
    if (!m.trouble.empty()) {
      text += m.row->name + ": " + m.trouble + "\n";
      continue;
    }
    std::snprintf(line, sizeof line, "%-19s %9d %5.3f - %5.3f %6.2f - %6.2f %7.3f %5d %6s %3.2fmm %5.1fs  %s; %s, %s\n",
                  m.row->name.c_str(), m.triangles, m.flattened_stretch, m.stretch, m.flattened_hausdorff, m.hausdorff, m.mean,
                  m.iterations, m.first_share ? formatted("%.0f %%", 100 * *m.first_share).c_str() : "-",
                  m.seam_mismatch * mm_per_m, m.seconds(), m.row->what.c_str(), m.fabric.c_str(), m.simulator.c_str());
    text += line;
    std::snprintf(line, sizeof line, "%-19s %9d %5.3f - %5.3f %6.1f - %6.1f  %s\n", "  paper", p.triangles, p.flattened_stretch,
                  p.stretch, p.flattened_hausdorff, p.hausdorff, m.hausdorff <= p.hausdorff ? "" : "NOT REACHED");
    text += line;
    std::snprintf(
        line, sizeof line,
        "%-19s S as the paper prints it %.3f; girth %.2f %%, openings %.1f mm; dressed %.1f s, edit %.1f, adjust %.1f, "
        "verify %.1f%s\n",
        "", m.printed_stretch, 100 * m.girth, m.level * mm_per_m, m.dress_seconds, m.edit_seconds, m.adjust_seconds,
        m.verify_seconds, m.folds_only && m.hausdorff > 0.3 ? "; only the folds fall otherwise" : "");
    text += line;
  }
  return text;
}

void write_plots(const std::vector<Measured>& rows, const OutputFolder& out) {
  LinePlot stretch{"Stretch S by iteration", "iteration (0: plain flattening)", "mean of S (paper Eq. 8)", {}};
  LinePlot hausdorff{"Hausdorff distance by iteration", "iteration (0: plain flattening)", "% of the mannequin's height", {}};
  for (const Measured& m : rows) {
    if (!m.trouble.empty()) continue;
    stretch.series.push_back({m.row->name, m.stretch_by_step});
    hausdorff.series.push_back({m.row->name, m.hausdorff_by_step});
  }
  if (stretch.series.empty()) return;
  write_whole_file(out.path("stretch.png"), png_bytes(line_plot(stretch)));
  write_whole_file(out.path("hausdorff.png"), png_bytes(line_plot(hausdorff)));
}

std::vector<TableRow> chosen(std::vector<TableRow> rows, const std::string& names) {
  if (names.empty()) return rows;
  std::vector<TableRow> some;
  std::istringstream in(names);
  for (std::string name; std::getline(in, name, ',');) {
    name.erase(0, name.find_first_not_of(' '));
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const TableRow& r) { return r.name == name; });
    if (row == rows.end()) {
      std::string known;
      for (const TableRow& each : rows) known += (known.empty() ? "" : ", ") + each.name;
      throw BadInput({"option.no-such-row", Severity::error, "--rows", "there is no row '" + name + "'", "Rows: " + known});
    }
    some.push_back(*row);
  }
  return some;
}

}  // namespace

int bench(const BenchOptions& options) {
  Progress progress(options.progress);
  const std::vector<TableRow> rows =
      chosen(value_or_throw(read_table1(template_file(options.table, options.table + ".toml"))), options.rows);
  OutputFolder out(options.out, options.force);
  std::vector<Measured> measured(rows.size());
  bool all = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    measured[i].row = &rows[i];
    if (!options.quiet) std::fprintf(stderr, "toile: %s, %s\n", rows[i].name.c_str(), rows[i].what.c_str());
    try {
      measure_row(options, progress, measured[i]);
    } catch (const BadInput& bad) {
      measured[i].trouble = bad.what();
      all = false;
    }
  }
  write_whole_file(out.path(options.table + ".csv"), csv(measured));
  write_whole_file(out.path(options.table + ".txt"), for_people(measured));
  write_plots(measured, out);
  out.keep();
  std::fputs(for_people(measured).c_str(), stdout);
  return all ? exit_ok : exit_checks_failed;
}

}  // namespace toile
