#pragma once
// toile check: do the edges that are sewn together fit.

#include <filesystem>
#include <optional>
#include <string>

namespace toile {

struct CheckOptions {
  std::filesystem::path pattern;
  std::optional<std::filesystem::path> seams;
  std::string units, size;
  bool json = false;
};

// Prints a line a seam; exit_checks_failed when one is 3 mm or more apart beyond its ease. Throws BadInput.
int check_pattern(const CheckOptions& options);

}  // namespace toile
