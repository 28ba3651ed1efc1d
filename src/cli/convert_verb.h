#pragma once
// The verb `toile convert`: a pattern in another format.

#include <filesystem>
#include <optional>
#include <string>

namespace toile {

struct ConvertOptions {
  std::filesystem::path in, out;
  std::optional<std::filesystem::path> seams;
  std::string profile = "aama";  // of DXF
  std::string size;              // of a graded pattern; empty: the sample size, and all sizes where the format holds them
  std::string units;             // of the input, when it does not say
  std::string allowance, hem;    // of edges without their own; empty: none
  std::string grading = "nest";  // of DXF: "nest", "rules", "none"
  std::string width;             // of the sheet; empty: 1.5 m or what the widest piece needs, of a PDF what the pieces need
  std::string paper = "roll";    // of PDF: formats/pdf/papers.h
  std::string margin = "10 mm", overlap = "10 mm";  // of the pages of a PDF
  bool unfold = false;
  bool force = false, quiet = false;
};

// Writes the file (and those that belong to it, beside it) and returns the exit code. What the format cannot hold is a finding.
// Throws BadInput, then nothing is written.
int convert_pattern(const ConvertOptions& options);

}  // namespace toile
