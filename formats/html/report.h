#pragma once
// report.html of a run or of a drape: one file with its pictures inside, nothing to fetch, printable.

#include <filesystem>
#include <string>
#include <vector>

#include "formats/summary/summary.h"
#include "garment/adjustment.h"
#include "garment/report.h"

namespace toile {

struct ReportFact {
  std::string name, value;
};

// How far a re-drape is from the target, surface to surface. Metres.
struct ReportDistance {
  std::string name;  // "plain flattening", "adjusted"
  double mean = 0, hausdorff = 0;
  double stretch = 0;  // mean of S, Eq. 8
};

// The two sides of a seam, metres. `mismatch`: worst departure from the ratio of lengths that the seam was given with.
struct ReportSeam {
  std::string name;
  double before_a = 0, before_b = 0, after_a = 0, after_b = 0, mismatch = 0;
};

struct ReportEdge {
  std::string piece, edge;
  double before = 0, after = 0;  // m
  bool straight = false;
  int points = 0;  // on the new outline
};

struct ReportPicture {
  std::string caption;
  std::string png;  // bytes
};

struct RunReport {
  std::string title;
  std::string verdict;                   // one line
  Severity outcome = Severity::note;     // colour of the verdict: note is good
  std::vector<std::string> certificate;  // lines, as they are on every sheet
  std::vector<ReportFact> inputs;        // pattern, body, fabric, simulator, tolerance, version, hashes
  std::string drape_heading = "First drape";
  std::vector<ReportFact> drape;  // its figures
  double height = 0;              // m, of the body; distances are also given in percent of it
  std::vector<ReportDistance> distances;
  std::vector<AdjustStep> steps;  // steps[0] is the plain flattening
  int best = 0;                   // index into steps
  std::string stop;               // why it stopped, in words
  std::vector<ReportSeam> seams;
  double seam_warning = 1e-3, seam_failure = 3e-3;  // m, mismatches from which a seam is marked
  std::vector<ReportEdge> edges;
  std::vector<Finding> findings;
  std::vector<ReportPicture> pictures;
  std::vector<SummaryGirth> girths;
  std::vector<ReportPicture> maps;  // the drape in colours, each with its scale
  std::vector<std::string> files;
  std::string recipe;  // its text; none: the command line said it all
};

// Fills the slots of `page` (templates/reports/report.html; the README there lists them). Throws BadInput "report.bad-template"
// when the template cannot be parsed, std::invalid_argument for figures that are not finite or a height of 0.
std::string report_html(const RunReport& report, const std::string& page);

// Also throws BadInput "file.cannot-create" and what reading the template finds.
void write_report(const std::filesystem::path& file, const RunReport& report, const std::filesystem::path& page);

}  // namespace toile
