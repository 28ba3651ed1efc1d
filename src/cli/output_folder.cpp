#include "cli/output_folder.h"

#include <unistd.h>

#include <algorithm>

#include "garment/report.h"

namespace toile {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(fs::path folder, bool overwrite) : folder_(std::move(folder)) {
  const auto refuse = [&](const std::string& why) {
    throw BadInput({"output.cannot-create", Severity::error, folder_.string(), why, "Choose a folder that you may write",
                    Fault::cannot_create});
  };
  std::error_code error;
  const fs::file_status status = fs::status(folder_, error);
  if (fs::exists(status) && !fs::is_directory(status)) refuse("is a file, not a folder");
  if (fs::exists(status) && !overwrite && !fs::is_empty(folder_, error))
    throw BadInput({"output.exists", Severity::error, folder_.string(), "the folder is not empty",
                    "Choose another, or give --force to replace files of the same names", Fault::cannot_create});
  if (!fs::exists(status)) {
    std::vector<fs::path> missing;
    for (fs::path up = fs::absolute(folder_).lexically_normal(); up.has_relative_path() && !fs::exists(up, error);
         up = up.parent_path())
      missing.push_back(up);
    for (auto made = missing.rbegin(); made != missing.rend(); ++made) {
      if (fs::create_directory(*made, error)) made_.push_back(*made);
      if (error) {
        remove_made();
        refuse(error.message());
      }
    }
  }
  staging_ = folder_ / (".toile-" + std::to_string(getpid()));
  fs::create_directory(staging_, error);
  if (error) {
    const std::string why = error.message();
    remove_made();
    refuse(why);
  }
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  if (!kept_) remove_made();
}

void OutputFolder::remove_made() {
  std::error_code ignored;
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
    fs::remove(*folder, ignored);  // unless it holds something by now
  made_.clear();
}

fs::path OutputFolder::path(const std::string& name) const { return staging_ / name; }

std::vector<std::string> OutputFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(staging_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void OutputFolder::keep(const std::vector<std::string>& names) {
  std::error_code error;
  for (const std::string& name : names) {
    fs::rename(staging_ / name, folder_ / name, error);
    if (error)
      throw BadInput({"output.cannot-create", Severity::error, (folder_ / name).string(), error.message(),
                      "Choose a folder that you may write", Fault::cannot_create});
    kept_ = true;
  }
}

}  // namespace toile
