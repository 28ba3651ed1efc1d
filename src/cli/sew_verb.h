#pragma once
// toile sew: proposes what is sewn to what.

#include <filesystem>
#include <optional>
#include <string>

namespace toile {

struct SewOptions {
  std::filesystem::path pattern, out;
  std::string units, size;
  bool force = false;
};

// Writes the proposal as a seams sidecar with a comment for each seam; returns the exit code. Throws BadInput.
int sew_pattern(const SewOptions& options);

}  // namespace toile
