#pragma once
// grading.html: a pattern in several sizes, each with its fit and its re-drape, and what every corner moves.

#include <filesystem>
#include <string>
#include <vector>

#include "formats/html/report.h"

namespace toile {

struct GradingSize {
  std::string size, folder, body;                                  // folder: of its own run, beside the page
  double height = 0;                                               // m, of the body
  double mean = 0, hausdorff = 0, stretch = 0, seam_mismatch = 0;  // of the verifying re-drape; m
  bool ok = false;
  std::string trouble;  // first error, when there is one
  std::vector<SummaryGirth> girths;
  std::string png;  // bytes of its re-drape
};

struct GradingPiece {
  std::string name;
  std::vector<double> width, height;  // m, by size, of the net line
};

struct GradingPoint {
  std::string piece, point;
  std::vector<double> dx, dy;  // m, by size, from the base
};

struct GradingReport {
  std::string title;
  std::string base;  // the size that the others are graded from
  std::vector<GradingSize> sizes;
  std::vector<GradingPiece> pieces;
  std::vector<GradingPoint> points;
  std::vector<std::string> files;
};

// Fills templates/reports/grading.html. Throws BadInput "report.bad-template", "file.cannot-create", and what reading the
// template finds.
void write_grading(const std::filesystem::path& file, const GradingReport& report, const std::filesystem::path& page);

}  // namespace toile
