#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "cli/exit_codes.h"
#include "cli/run.h"
#include "garment/report.h"

namespace toile {
namespace {

constexpr const char* footer = R"(Exit codes:
   0  done                         64  wrong use of the command line
  10  written, but a check failed  65  bad input (the message names file, place and remedy)
  11  did not converge             66  a file is missing
  12  ambiguous units: say which   73  the output cannot be written
   1, 70  a fault of the program   75  interrupted
Lengths are written with their unit: "10 cm", "5 mm", "5/8 in".)";

constexpr const char* run_help =
    R"(Reads a pattern, sews and drapes it on a body, makes the recipe's edits in 3D, adjusts the pattern until its drape is
the edited shape, and writes cut sheet and report. The last line on standard output says how well it came out.

Written to the output folder:
  NAME.dxf, NAME.seams.toml   the new pattern (AAMA DXF, mm) and what is sewn to what
  NAME.svg                    cut sheet, true size in mm
  report.html, summary.json   the report, for people and for programs
  source.obj, target.obj, flattened.obj, redrape.obj, body.obj
                              metres; the drapes have the same vertices, vt is the rest shape in metres
  *.png                       pictures of the drapes and of the outlines)";

int main_program(int argc, char** argv) {
  CLI::App app("Toile: edit a garment in 3D, get back 2D patterns that drape into that shape", "toile");
  app.set_version_flag("--version", std::string("toile ") + TOILE_VERSION);
  app.require_subcommand(1);
  app.footer(footer);

  RunOptions options;
  CLI::App* run = app.add_subcommand("run", "the main job: a recipe from pattern to cut sheet");
  run->description(run_help);
  run->footer(footer);
  run->add_option("recipe", options.recipe, "the recipe (TOML); see samples/gored_skirt/shorten.toml")
      ->required()
      ->type_name("RECIPE.toml");
  run->add_option("--out,-o", options.out, "folder for the results; made when missing")->required()->type_name("DIR");
  run->add_flag("--force,-f", options.force, "write into a folder that is not empty, replacing files of the same names");
  std::string progress = "auto";
  run->add_option(
         "--progress", progress,
         "progress on standard error: a bar on a terminal, else a line a stage (auto); one JSON object a line (json); none")
      ->check(CLI::IsMember({"auto", "json", "none"}))
      ->capture_default_str();
  bool quiet = false;
  run->add_flag("--quiet,-q", quiet, "the same as --progress none, and no notes or warnings");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  options.quiet = quiet;
  options.progress = quiet || progress == "none" ? ProgressStyle::none
                     : progress == "json"        ? ProgressStyle::json
                                                 : ProgressStyle::automatic;
  interrupt_by_signals();
  try {
    return run_recipe(options);
  } catch (const Interrupted&) {
    std::fputs("toile: interrupted; nothing is written\n", stderr);
    return exit_interrupted;
  } catch (const BadInput& bad) {
    std::fprintf(stderr, "toile: %s\n", bad.what());
    return exit_code(bad.finding().fault);
  } catch (const std::bad_alloc&) {
    std::fputs("toile: out of memory; use a larger edge_length\n", stderr);
    return exit_internal;
  } catch (const std::invalid_argument& bug) {
    std::fprintf(stderr, "toile: a fault of the program (%s); please report it with the recipe\n", bug.what());
    return exit_bug;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "toile: %s\n", error.what());
    return exit_internal;
  }
}

}  // namespace
}  // namespace toile

int main(int argc, char** argv) { return toile::main_program(argc, argv); }
