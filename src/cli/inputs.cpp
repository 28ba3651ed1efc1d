#include "cli/inputs.h"

#include <algorithm>

#include "cli/templates.h"
#include "formats/formats.h"
#include "formats/sha256/sha256.h"

namespace toile {
namespace {

std::filesystem::path fabric_file(const FabricName& fabric) {
  return fabric.file.empty() ? template_file("fabrics", fabric.name + ".toml") : fabric.file;
}

// Edits that mean nothing are refused elsewhere.
std::vector<std::pair<std::string, std::filesystem::path>> files_of_edits(const std::filesystem::path& folder,
                                                                          const std::vector<Edit>& edits) {
  std::vector<std::pair<std::string, std::filesystem::path>> files;
  for (const Edit& edit : edits)
    for (const EditOperation& operation : operations())
      for (const Parameter& parameter : operation.parameters)
        if (operation.name == edit.operation && parameter.unit == "file")
          if (const auto given = edit.arguments.find(parameter.name);
              given != edit.arguments.end() && given->second != parameter.by_default)
            files.emplace_back(parameter.name + " of edit '" + edit.operation + "'", folder / given->second);
  return files;
}

}  // namespace

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
  files.fabric = fabric_file(recipe.fabric);
  if (recipe.adjust.fabric) files.other_fabric = fabric_file(*recipe.adjust.fabric);
  files.of_edits = files_of_edits(file.parent_path(), recipe.edits);
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
  if (files.other_fabric) add("fabric of the new pattern", *files.other_fabric);
  for (const auto& [role, file] : files.of_edits) add(role.c_str(), file);
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
