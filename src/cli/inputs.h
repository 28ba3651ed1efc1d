#pragma once
// The files a job is made from, with what proves which version of them it was.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "workbench/recipe.h"

namespace toile {

struct InputFiles {
  std::filesystem::path recipe;  // empty: the command line says it all
  std::filesystem::path pattern;
  std::optional<std::filesystem::path> seams;
  std::filesystem::path body;  // an OBJ, or the size chart
  bool is_chart = false;
  std::optional<std::filesystem::path> skeleton;
  std::filesystem::path fabric;
  std::optional<std::filesystem::path> other_fabric;                    // that the new pattern is cut from
  std::vector<std::pair<std::string, std::filesystem::path>> of_edits;  // role and file
};

// What `recipe`, read from `file`, names or finds beside what it names. Throws BadInput("template.missing").
InputFiles input_files(const std::filesystem::path& file, const Recipe& recipe);

struct InputHash {
  std::string role;  // "pattern", "size chart"
  std::filesystem::path file;
  std::string sha256;  // 64 hexadecimal digits
};

// Throws BadInput for a file that cannot be read.
std::vector<InputHash> hashes(const InputFiles& files);

// "skirt.dxf (SHA-256 1f0c93ab52e4)": enough to tell versions apart by eye.
std::string in_short(const InputHash& input);

// File name -> SHA-256; two files of one name are told apart by their folders.
std::map<std::string, std::string> by_name(const std::vector<InputHash>& inputs);

}  // namespace toile
