#pragma once
// The folder that a job writes: everything is made in a hidden folder inside it and moved into place at the end, or not at all.

#include <filesystem>
#include <string>
#include <vector>

namespace toile {

class OutputFolder {
 public:
  // Throws BadInput: "output.cannot-create" when the folder cannot be made or written, "output.exists" when it holds files and
  // `overwrite` is false.
  OutputFolder(std::filesystem::path folder, bool overwrite);
  ~OutputFolder();  // removes what was not kept
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // Where to write `name` until keep().
  std::filesystem::path path(const std::string& name) const;
  std::vector<std::string> names() const;  // of the files so far, sorted
  // Moves every file into the folder, or only those named.
  void keep() { keep(names()); }
  void keep(const std::vector<std::string>& names);
  const std::filesystem::path& folder() const { return folder_; }

 private:
  void remove_made();

  std::filesystem::path folder_, staging_;
  std::vector<std::filesystem::path> made_;  // folders that were not there, outermost first
  bool kept_ = false;
};

}  // namespace toile
