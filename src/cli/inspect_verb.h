#pragma once
// The verb `toile inspect`.

#include <filesystem>
#include <optional>
#include <string>

namespace toile {

struct InspectOptions {
  std::filesystem::path file;
  bool json = false;
  std::string units;  // "mm", "cm", "m", "in"; empty: as the file says
  std::string size;   // of a graded file: that one alone
  std::optional<std::filesystem::path> seams;
  std::optional<std::filesystem::path> png;
};

// Prints what the file holds on standard output and returns the exit code: 0, or that of the file's first error. Throws
// BadInput for --units that are none and for a picture that cannot be written.
int inspect_pattern(const InspectOptions& options);

}  // namespace toile
