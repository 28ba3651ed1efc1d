#include "cli/inputs.h"

#include <algorithm>

#include "cli/templates.h"
#include "formats/formats.h"
#include "formats/sha256/sha256.h"

namespace toile {

InputFiles input_files(const std::filesystem::path& file, const Recipe& recipe) {
  InputFiles files;
  files.recipe = file;
  files.pattern = recipe.pattern.file;
  files.seams = recipe.pattern.seams ? recipe.pattern.seams : seams_beside(recipe.pattern.file);
  files.is_chart = recipe.body.file.empty();
  if (files.is_chart) {
    files.body = template_file("mannequins", recipe.body.chart + ".csv");
  } else {
    files.body = recipe.body.file;
    files.skeleton = recipe.body.skeleton ? recipe.body.skeleton : skeleton_beside(recipe.body.file);
  }
  files.fabric = recipe.fabric.file.empty() ? template_file("fabrics", recipe.fabric.name + ".toml") : recipe.fabric.file;
  return files;
}

std::vector<InputHash> hashes(const InputFiles& files) {
  std::vector<InputHash> inputs;
  const auto add = [&](const char* role, const std::filesystem::path& file) {
    inputs.push_back({role, file, sha256(value_or_throw(read_whole_file(file)))});
  };
  if (!files.recipe.empty()) add("recipe", files.recipe);
  add("pattern", files.pattern);
  if (files.seams) add("seams", *files.seams);
  add(files.is_chart ? "size chart" : "body", files.body);
  if (files.skeleton) add("skeleton", *files.skeleton);
  add("fabric", files.fabric);
  return inputs;
}

std::string in_short(const InputHash& input) {
  return input.file.filename().string() + " (SHA-256 " + input.sha256.substr(0, 12) + ")";
}

std::map<std::string, std::string> by_name(const std::vector<InputHash>& inputs) {
  std::map<std::string, std::string> named;
  for (const InputHash& input : inputs) {
    const auto alike = std::count_if(inputs.begin(), inputs.end(),
                                     [&](const InputHash& other) { return other.file.filename() == input.file.filename(); });
    named[alike == 1 ? input.file.filename().string() : input.file.string()] = input.sha256;
  }
  return named;
}

}  // namespace toile
