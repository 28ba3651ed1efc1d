#include <CLI/CLI.hpp>
#include <memory>

#include "cli/common_flags.h"
#include "cli/run.h"
#include "cli/verbs.h"

namespace toile {
namespace {

constexpr const char* help =
    R"(Reads a pattern, sews and drapes it on a body, makes the recipe's edits in 3D, adjusts the pattern until its drape is
the edited shape, and writes cut sheet and report. The last line on standard output says how well it came out.

Written to the output folder:
  NAME.dxf, NAME.seams.toml   the new pattern (AAMA DXF, mm) and what is sewn to what
  NAME.svg, NAME.pdf          cut sheet, true size, one page
  NAME_a4.pdf                 the same in pages to print and tape ([print] paper = "letter" in the recipe)
  report.html, summary.json   the report, for people and for programs
  source.obj, target.obj, flattened.obj, redrape.obj, body.obj
                              metres; the drapes have the same vertices, vt is the rest shape in metres
  *.png                       pictures of the drapes and of the outlines
  stuck.png, stuck.obj        only when a seam or panel did not come together: where, and the loose panels
  stretch_warp, stretch_weft, stretch_bias, ease, pressure, each .png and .glb
                              the re-drape in colours, with their scale)";

}  // namespace

Verb add_run(CLI::App& app) {
  const auto given = std::make_shared<RunOptions>();
  const auto folder = std::make_shared<FolderFlags>();
  RunOptions& options = *given;
  CLI::App* run = app.add_subcommand("run", "the main job: a recipe from pattern to cut sheet");
  run->add_option("recipe", options.recipe, "the recipe (TOML); see samples/gored_skirt/shorten.toml")
      ->required()
      ->type_name("RECIPE.toml");
  folder->add_to(run, help);
  return {run, [given, folder] {
            folder->give(*given);
            return run_recipe(*given);
          }};
}

}  // namespace toile
