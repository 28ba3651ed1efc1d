#pragma once
// summary.json, schema 1: the figures of a run for programs.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "garment/adjustment.h"
#include "garment/drape.h"
#include "garment/report.h"

namespace toile {

// Metres and seconds here; the file says mm, m and percent of the mannequin's height in its field names.
struct SummaryDistance {
  double hausdorff = 0, mean = 0;  // m, symmetric, surface to surface
  double stretch = 0;              // mean of S, Eq. 8
};

struct SummaryGirth {
  std::string name;                         // "bust"
  double height = 0, body = 0;              // m
  bool covered = false;                     // the garment goes all round there; only then:
  double garment = 0, cloth = 0, ease = 0;  // m: as it hangs, laid flat, garment - body
};

struct RunSummary {
  std::string version;  // of toile
  std::string recipe;
  std::string verdict;                   // the one line that is printed
  std::vector<std::string> certificate;  // lines, as they are on every sheet
  bool ok = false;                       // every check passed
  struct {
    std::string name;
    double height = 0;
  } mannequin;
  struct {
    std::string name;
    int triangles = 0, panels = 0;
  } garment;
  std::string fabric;
  Drape drape;                       // the source drape; positions are not written
  double tolerance = 0;              // asked of the drapes that are reported
  double seam_gap = 0;               // m, widest seam just before it was welded
  bool links_ok = true;              // every limb goes through the opening it belongs to
  std::vector<SummaryGirth> girths;  // of the drape that came out: in a run, of the adjusted pattern
  bool only_draped = false;          // by `toile drape`: flattened, adjusted and outlines are left out
  SummaryDistance flattened;
  struct {
    SummaryDistance distance;  // of the re-exported outlines, draped anew
    AdjustStop stop = AdjustStop::step_limit;
    std::vector<AdjustStep> steps;
    int best = 0;
    double seam_mismatch = 0;  // m
    bool settled = false;
    double residual = 0;         // of the verifying drape
    double max_penetration = 0;  // m
    double girth = 0;            // share; this and the next two: worst against the target, for a tape measure
    double seam_length = 0;      // m, of the seams as they hang
    double level = 0;            // m, of the openings' mean heights
    double seconds = 0;
  } adjusted;
  struct {
    double max_deviation = 0, symmetry = 0;  // m
  } outlines;
  std::vector<Finding> findings;
  std::map<std::string, std::string> inputs;  // file -> SHA-256
  std::vector<std::string> files;             // of the output folder
  double seconds = 0;                         // of the whole run
};

// Fields in a fixed order, numbers to six digits. Throws std::invalid_argument naming the field when a number is not finite or
// the height is 0.
std::string summary_json(const RunSummary& summary);

// Also throws BadInput "file.cannot-create".
void write_summary(const std::filesystem::path& file, const RunSummary& summary);

}  // namespace toile
