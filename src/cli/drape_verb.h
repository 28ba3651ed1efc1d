#pragma once
// The verb `toile drape`: a pattern on a body, as it hangs.

#include <filesystem>
#include <optional>
#include <string>

#include "cli/progress.h"

namespace toile {

struct DrapeOptions {
  std::filesystem::path pattern;
  std::optional<std::filesystem::path> seams;
  std::string units;  // of a pattern file that does not say; empty: it must
  std::string chart = "women", size = "38";
  std::filesystem::path body;  // an OBJ instead of chart and size
  std::optional<std::filesystem::path> skeleton;
  std::string fabric = "cotton_poplin";  // of templates/fabrics, or a file
  std::string simulator = "fem";
  std::string edge_length = "12 mm";
  double tolerance = 1e-3;
  std::optional<double> time_limit;            // s
  std::optional<std::filesystem::path> go_on;  // drape.obj of an earlier run of the same pattern
  std::filesystem::path out;
  bool force = false;
  bool quiet = false;
  ProgressStyle progress = ProgressStyle::automatic;
};

// Writes the folder and returns the exit code. Throws BadInput, then nothing is left behind but the
// picture of dressing that got stuck. Interrupted while it settles, it
// writes how far it got, to go on from.
int drape_pattern(const DrapeOptions& options);

}  // namespace toile
