#pragma once
// One run of a recipe: what was read, what each stage made. The files are written from it.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/inputs.h"
#include "cli/progress.h"
#include "garment/cut_sheet.h"
#include "garment/pattern_file.h"
#include "measure/girth_table.h"
#include "measure/tailoring.h"
#include "workbench/workbench.h"

namespace toile {

// Dressing that did not come together.
struct StuckDressing {
  std::vector<Finding> errors;  // as dressing put them
  std::string png;              // bytes of the picture
};

struct Job {
  std::filesystem::path recipe_file;
  Recipe recipe;
  std::vector<InputHash> inputs;
  Pattern pattern;                         // as read, of pieces that are sewn
  std::vector<Piece> unsewn;               // the others: on the cut sheet as they were read
  std::vector<DrapedGarment> came_draped;  // with the pattern: one, or none
  Scene scene;
  std::optional<Fabric> new_fabric;  // that the new pattern is cut from, when it is another
  StuckDressing stuck;
  Worn worn;
  std::shared_ptr<const Body> source_body;  // of the source drape, when the target is worn on another
  Target target;
  Adjustment adjustment;
  Redrawn redrawn;
  CutSheet sheet;
  Pattern reread;  // the written DXF, read back
  Verified verified;
  AdjustStep flattened;           // the baseline's measures
  TailoringDifference tailoring;  // of the verifying drape to the target
  std::vector<GirthRow> girths;   // of the drape that came out: the verifying one in a run
  std::vector<Finding> findings;  // of all stages, in order
  double seconds = 0;             // of the whole run
  double dressing_others = 0;     // s, of the garments that edits take parts from
};

// Reads what the recipe names. Throws BadInput.
void load(Job& job, Progress& progress);
// The source drape: dressed and settled, or settled from `start` (3 x garment vertices) or `came_draped`.
void drape(Job& job, Progress& progress, DrapeControl control, const Eigen::Matrix3Xd* start = nullptr);
// The recipe's edits, and its replica.
void make_target(Job& job, Progress& progress);
// From the target to outlines and sheet.
void adjust_and_redraw(Job& job, Progress& progress);
// Reads the pattern file written from job.sheet again, holds it against what was meant, and drapes it from the target.
void prove(Job& job, const std::filesystem::path& dxf, const std::filesystem::path& seams, Progress& progress);

// Keeps what a stage had to say.
void add(Job& job, const Report& report);
std::string percent_of_height(double metres, const Job& job);  // "0.29 %"

// All that is cut: the redrawn pieces, and those that are not sewn as they were.
Pattern cut_pattern(const Job& job);

// The pattern that is adjusted: the one that was read, or what an edit made of it.
const Pattern& edited_pattern(const Job& job);

// Throws BadInput "export.changed" unless the pattern in the file is the one that was proved, to the bit.
void check_still_proved(const Job& job, const std::filesystem::path& dxf, const std::filesystem::path& seams);

// Steps of dressing and draping shown on `progress`.
DrapeControl watched(Progress& progress);

// What the exit code must say: the gravest of the findings.
int exit_code(const Job& job);

}  // namespace toile
