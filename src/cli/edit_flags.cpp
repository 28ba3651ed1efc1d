#include <CLI/CLI.hpp>
#include <memory>

#include "cli/common_flags.h"
#include "cli/edit_verb.h"
#include "cli/verbs.h"
#include "edit/operation.h"

namespace toile {
namespace {

constexpr const char* help =
    R"(Reads a pattern, sews and drapes it on a body and makes the recipe's edits in 3D: the target that `toile run` then finds a
pattern for. To see what an edit does before it is worked out, or to take the target elsewhere.

Written to the output folder:
  source.obj, target.obj, body.obj   metres; vt is the rest shape of the source in metres, one group a panel
  source.png, target.png             the drape and the target
  report.html, summary.json          what every edit says of itself: what moved, ease before and after, warnings)";

// The table of every operation, as src/edit declares it.
std::string operations_help() {
  std::string text = "Operations of [[edit]]:";
  for (const EditOperation& operation : operations()) {
    text += "\n  " + operation.name + ": " + operation.summary;
    for (const Parameter& parameter : operation.parameters) {
      text += "\n    " + parameter.name;
      if (parameter.by_default) text += " (" + *parameter.by_default + ")";
      if (!parameter.instead_of.empty()) text += " (instead of " + parameter.instead_of + ")";
      text += ": " + parameter.meaning;
    }
  }
  return text;
}

}  // namespace

Verb add_edit(CLI::App& app) {
  const auto given = std::make_shared<RunOptions>();
  const auto folder = std::make_shared<FolderFlags>();
  CLI::App* edit = app.add_subcommand("edit", "a recipe's edits in 3D alone: source and target");
  edit->add_option("recipe", given->recipe, "the recipe (TOML); see samples/gored_skirt/shorten.toml")
      ->required()
      ->type_name("RECIPE.toml");
  folder->add_to(edit, help + ("\n\n" + operations_help()));
  return {edit, [given, folder] {
            folder->give(*given);
            return edit_recipe(*given);
          }};
}

}  // namespace toile
