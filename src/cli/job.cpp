#include "cli/job.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "body/parametric.h"
#include "cli/exit_codes.h"
#include "cli/proposed_seams.h"
#include "cli/stuck.h"
#include "cli/unsewn.h"
#include "cut/cut.h"
#include "edit/arguments.h"
#include "formats/formats.h"
#include "garment/units.h"
#include "workbench/locked_edges.h"
#include "workbench/replica.h"

namespace toile {
namespace {

template <class T>
T take(Loaded<T> loaded, Job& job) {
  job.findings.insert(job.findings.end(), loaded.report.findings.begin(), loaded.report.findings.end());
  return value_or_throw(std::move(loaded));
}

// How far a drape has come, on the scale of decades its residual has to fall.
DrapeSteps drape_bar(Progress& progress) {
  auto first = std::make_shared<double>(0);
  return [&progress, first](const DrapeProgress& state) {
    if (state.step <= 1) *first = std::max(state.residual, 10 * state.tolerance);
    char detail[64];
    std::snprintf(detail, sizeof detail, "step %d, residual %.1e", state.step, state.residual);
    progress.update(std::log(*first / state.residual) / std::log(*first / state.tolerance), detail);
  };
}

Mannequin body_of(const InputFiles& files, Job& job) {
  if (!files.is_chart) return take(read_body(files.body, files.skeleton), job);
  return build_mannequin(take(read_size_chart_row(files.body, job.recipe.body.size), job));
}

// What is wrong with a body from a file is said about the file.
Body ready(Mannequin form, const std::filesystem::path& file) {
  try {
    return make_body(std::move(form));
  } catch (const BadInput& bad) {
    Finding finding = bad.finding();
    if (!file.empty()) finding.place = file.string() + ", " + finding.place;
    throw BadInput(finding);
  }
}

// Bodies for edits: sizes of the recipe's chart, files beside the recipe. Each is made once.
FindBody body_finder(const Job& job, const InputFiles& files) {
  using Made = std::vector<std::pair<BodyName, std::shared_ptr<const Body>>>;
  return [chart = files.is_chart ? files.body : std::filesystem::path(), folder = job.recipe_file.parent_path(),
          made = std::make_shared<Made>()](const BodyName& name, const std::string& place) {
    for (const auto& [known, body] : *made)
      if (known == name) return body;
    if (!name.size.empty() && chart.empty())
      throw BadInput({"edit.no-chart", Severity::error, place, "the recipe's body is a file, which has no sizes",
                      "Give body = \"other.obj\" instead of size, or make the garment for a size of a chart"});
    const auto file = folder / name.file;
    std::optional<std::filesystem::path> skeleton = skeleton_beside(file);
    if (!name.skeleton.empty()) skeleton = folder / name.skeleton;
    Mannequin form = name.size.empty() ? value_or_throw(read_body(file, skeleton))
                                       : build_mannequin(value_or_throw(read_size_chart_row(chart, name.size)));
    made->emplace_back(name, std::make_shared<const Body>(ready(std::move(form), name.size.empty() ? file : chart)));
    return made->back().second;
  };
}

// Patterns beside the recipe, worn as the recipe's own. Each is worn once on each body.
FindGarment garment_finder(Job& job) {
  struct Made {
    std::string file, body;
    std::shared_ptr<const WornGarment> garment;
  };
  return [&job, made = std::make_shared<std::vector<Made>>()](const std::string& file, const Body& body,
                                                              const std::string& place) {
    for (const Made& known : *made)
      if (known.file == file && known.body == body.form.name) return known.garment;
    const auto path = job.recipe_file.parent_path() / file;
    Pattern pattern = value_or_throw(read_pattern(path, {std::nullopt, seams_beside(path)}));
    take_unsewn(pattern);
    if (pattern.seams.empty())
      throw BadInput({"pattern.no-seams", Severity::error, place, "nothing says what is sewn to what in '" + file + "'",
                      "Write a seams file beside it: " + path.stem().string() + ".seams.toml"});
    const auto& [simulator, edge_length, tolerance] = job.recipe.drape;
    Scene scene{body, job.scene.fabric, job.scene.simulator, job.scene.hem};
    const auto began = std::chrono::steady_clock::now();
    Worn worn = wear(pattern, scene, edge_length, tolerance);
    job.dressing_others += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    for (Finding& finding : worn.report.findings) finding.place = file + ", " + finding.place;
    made->push_back({file, body.form.name, std::make_shared<const WornGarment>(as_worn(std::move(worn), edge_length))});
    return made->back().garment;
  };
}

// Before the drape, which takes its time: what can be known to be wrong with the edits as written.
void check_written(const std::vector<Edit>& edits, const FindBody& find_body) {
  for (const Edit& edit : edits) try {
      const ReadArguments read = read_arguments(edit.operation, find_operation(edit.operation).parameters, edit.arguments);
      if (const auto name = body_name(edit.operation, read)) find_body(*name, "edit '" + edit.operation + "'");
    } catch (const BadInput& bad) {
      Finding finding = bad.finding();
      finding.place = finding.place.empty() ? edit.place : edit.place + ", " + finding.place;
      throw BadInput(finding);
    }
}

}  // namespace

void add(Job& job, const Report& report) {
  job.findings.insert(job.findings.end(), report.findings.begin(), report.findings.end());
}

std::string percent_of_height(double metres, const Job& job) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f %%", 100 * metres / job.scene.body.form.height);
  return text;
}

Pattern cut_pattern(const Job& job) {
  Pattern pattern = job.redrawn.pattern;
  pattern.pieces.insert(pattern.pieces.end(), job.unsewn.begin(), job.unsewn.end());
  return pattern;
}

const Pattern& edited_pattern(const Job& job) { return edited_pattern(job.worn, job.target); }

DrapeControl watched(Progress& progress) {
  DrapeControl control;
  control.progress = drape_bar(progress);
  control.dressing = [&progress](int step, int steps) {
    progress.update(0, "sewing " + std::to_string(100 * step / std::max(1, steps)) + " %");
  };
  return control;
}

void load(Job& job, Progress& progress) {
  const Recipe& recipe = job.recipe;
  progress.begin("read");
  const InputFiles files = input_files(job.recipe_file, recipe);
  job.scene.find_body = body_finder(job, files);
  job.scene.find_garment = garment_finder(job);
  check_written(recipe.edits, job.scene.find_body);
  PatternFile read = take(read_pattern_file(files.pattern, {recipe.pattern.unit_in_metres, files.seams}), job);
  job.pattern = std::move(read.pattern);
  job.came_draped = std::move(read.drape);
  add(job, set_unsewn_apart(job.pattern, recipe.pattern.file, job.unsewn));
  if (wants_seams(job.pattern)) {
    Report report;
    job.pattern = with_proposed_seams(job.pattern, recipe.pattern.file, report);
    add(job, report);
    add(job, set_unsewn_apart(job.pattern, recipe.pattern.file, job.unsewn));
  }
  if (job.pattern.seams.empty())
    throw BadInput({"pattern.no-seams", Severity::error, recipe.pattern.file.string(), "nothing says what is sewn to what",
                    "Write a seams file beside it: " + recipe.pattern.file.stem().string() + ".seams.toml"});
  job.scene.fabric = take(read_fabric(files.fabric), job);
  if (files.other_fabric) job.new_fabric = take(read_fabric(*files.other_fabric), job);
  job.scene.simulator = find_simulator(recipe.drape.simulator);
  job.scene.hem = recipe.cut.allowances.hem;
  job.scene.body = ready(body_of(files, job), recipe.body.file);
  job.inputs = hashes(files);
  progress.end(std::to_string(job.pattern.pieces.size()) + " pieces, " + std::to_string(job.pattern.seams.size()) +
               " seams; body " + job.scene.body.form.name + "; " + job.scene.fabric.name);
}

void drape(Job& job, Progress& progress, DrapeControl control, const Eigen::Matrix3Xd* start) {
  const auto& [simulator, edge_length, tolerance] = job.recipe.drape;
  progress.begin("drape");
  if (start)
    job.worn = wear_from(job.pattern, job.scene, edge_length, tolerance, *start, control);
  else if (!job.came_draped.empty())
    job.worn = wear_draped(job.pattern, job.came_draped.front(), job.scene, edge_length, tolerance, control);
  else
    job.worn = wear(job.pattern, job.scene, edge_length, tolerance, control);
  add(job, job.worn.report);
  name_stuck_picture(job.stuck, job.findings);
  char words[128];
  std::snprintf(words, sizeof words, "%d triangles, residual %.1e in %d steps, %.1f s", triangle_count(job.worn.garment),
                job.worn.drape.residual, job.worn.drape.steps, job.worn.drape.seconds);
  progress.end(words);
}

void make_target(Job& job, Progress& progress) {
  const Recipe& recipe = job.recipe;
  progress.begin("edit");
  job.target = edit(job.worn, job.scene, recipe.edits);
  if (recipe.replica.height) {
    const Body& body = job.target.body ? *job.target.body : job.scene.body;
    if (!job.unsewn.empty()) {
      Report report;
      report.warn("pieces.not-sewn", "replica", std::to_string(job.unsewn.size()) + " pieces that are not draped are left out",
                  "They have the size of the larger body: draw them anew for the replica");
      add(job, report);
      job.unsewn.clear();
    }
    job.target = replica(job.target, edited_pattern(job), body, *recipe.replica.height);
    AllowanceRules& allowances = job.recipe.cut.allowances;
    for (double* allowance : {&allowances.allowance, &allowances.hem})
      *allowance = replica_allowance(*allowance, *recipe.replica.height / body.form.height);
    job.scene.hem = allowances.hem;
  }
  if (job.new_fabric) {
    job.target.report.note(
        "adjust.other-fabric", "adjust",
        "the target is the drape in " + job.scene.fabric.name + "; the new pattern is cut from " + job.new_fabric->name);
    job.scene.fabric = *job.new_fabric;
  }
  if (job.target.body) {
    job.source_body = std::make_shared<const Body>(std::move(job.scene.body));
    job.scene.body = *job.target.body;
  }
  add(job, job.target.report);
  progress.end(std::to_string(recipe.edits.size()) + " edits");
}

void adjust_and_redraw(Job& job, Progress& progress) {
  const Recipe& recipe = job.recipe;
  if (!recipe.adjust.locked.empty()) {
    Pattern pattern = edited_pattern(job);
    lock_edges(pattern, recipe.adjust.locked, job.recipe_file.string());
    job.target.pattern = std::make_shared<const Pattern>(std::move(pattern));
  }
  progress.begin("adjust");
  AdjustOptions options;
  options.most_steps = recipe.adjust.steps;
  options.tolerance = recipe.adjust.tolerance;
  options.progress = [&](const AdjustStep& step) {
    progress.end(in_mm(step.hausdorff) + " (" + percent_of_height(step.hausdorff, job) + "), mean " + in_mm(step.mean, 2));
  };
  job.adjustment = adjust_pattern(edited_pattern(job), job.target, job.scene, options, watched(progress));
  job.flattened = job.adjustment.steps.front();
  progress.end(in_words(job.adjustment.stop) + ", best is step " + std::to_string(job.adjustment.best));

  progress.begin("redraw");
  job.redrawn = redraw(edited_pattern(job), job.target.garment, job.adjustment.rest);
  add(job, job.redrawn.report);
  try {
    job.sheet = lay_out(cut_pattern(job), recipe.cut);
  } catch (const BadInput& bad) {  // the pattern as it was read could be laid out
    Finding finding = bad.finding();
    finding.text = "the shape that the edit asks for cannot be cut: " + finding.text;
    finding.remedy = "Make the change smaller, or spread it over a larger part; `toile edit` shows the target";
    finding.fault = Fault::checks_failed;
    throw BadInput(finding);
  }
  progress.end("outlines within " + in_mm(job.redrawn.max_deviation, 2) + ", seams within " +
               in_mm(job.redrawn.seam_mismatch, 2));
}

int exit_code(const Job& job) {
  int code = exit_ok;
  for (const Finding& finding : job.findings) {
    if (finding.severity != Severity::error) continue;
    const int of_finding = exit_code(finding.fault);
    if (code == exit_ok || of_finding == exit_not_converged) code = of_finding;
  }
  return code;
}

}  // namespace toile
