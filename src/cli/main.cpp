#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "cli/drape_verb.h"
#include "cli/exit_codes.h"
#include "cli/run.h"
#include "garment/report.h"

namespace toile {
namespace {

constexpr const char* footer = R"(Exit codes:
   0  done                         64  wrong use of the command line
  10  written, but a check failed  65  bad input (the message names file, place and remedy)
  11  did not converge: the best   66  a file is missing
      state so far is written      73  the output cannot be written
  12  ambiguous units: say which   75  interrupted
   1, 70  a fault of the program
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
  *.png                       pictures of the drapes and of the outlines
  stuck.png, stuck.obj        only when a seam or panel did not come together: where, and the loose panels
  stretch_warp, stretch_weft, stretch_bias, ease, pressure, each .png and .glb
                              the re-drape in colours, with their scale)";

constexpr const char* drape_help =
    R"(Reads a pattern, sews it, dresses a body with it and lets it come to rest. The last line on standard output says how it
hangs.

Written to the output folder:
  drape.obj, body.obj   metres; vt is the rest shape in metres, one group a panel
  drape.png             front, side and back
  stretch_warp, stretch_weft, stretch_bias (%), ease (mm to the body), pressure (kPa), each .png and .glb
                        the drape in colours, with their scale
  stuck.png, stuck.obj  only when a seam or panel did not come together: where, and the loose panels
  report.html, summary.json
                        all of it on one page; the figures for programs
Interrupted (Ctrl-C) or out of time, it writes how far it got; --go-on takes that up again.)";

constexpr const char* examples = R"(Try:
  toile drape samples/gored_skirt/gored_skirt.dxf --size 38 --fabric jersey --out hangs
  toile run samples/gored_skirt/shorten.toml --out shorter
`toile drape --help` and `toile run --help` say what these need and what they write; look at report.html first.
)";

// What all verbs share.
struct Common {
  std::filesystem::path out;
  bool force = false, quiet = false;
  std::string progress = "auto";

  void add_to(CLI::App* verb, const std::string& explained) {
    verb->footer(explained + "\n\n" + footer);
    verb->add_option("--out,-o", out, "folder for the results; made when missing")->required()->type_name("DIR");
    verb->add_flag("--force,-f", force, "write into a folder that is not empty, replacing files of the same names");
    verb->add_option(
            "--progress", progress,
            "progress on standard error: a bar on a terminal, else a line a stage (auto); one JSON object a line (json); none")
        ->check(CLI::IsMember({"auto", "json", "none"}))
        ->capture_default_str();
    verb->add_flag("--quiet,-q", quiet, "the same as --progress none, and no notes or warnings");
  }

  template <class Options>
  void give(Options& options) const {
    options.out = out;
    options.force = force;
    options.quiet = quiet;
    options.progress = quiet || progress == "none" ? ProgressStyle::none
                       : progress == "json"        ? ProgressStyle::json
                                                   : ProgressStyle::automatic;
  }
};

CLI::App* add_run(CLI::App& app, RunOptions& options) {
  CLI::App* run = app.add_subcommand("run", "the main job: a recipe from pattern to cut sheet");
  run->add_option("recipe", options.recipe, "the recipe (TOML); see samples/gored_skirt/shorten.toml")
      ->required()
      ->type_name("RECIPE.toml");
  return run;
}

CLI::App* add_drape(CLI::App& app, DrapeOptions& options) {
  CLI::App* drape = app.add_subcommand("drape", "a pattern on a body, as it hangs");
  drape->add_option("pattern", options.pattern, "AAMA DXF or GarmentCode JSON")->required()->type_name("PATTERN");
  drape->add_option("--seams", options.seams, "what is sewn to what (default: NAME.seams.toml beside the pattern)")
      ->type_name("FILE");
  drape->add_option("--units", options.units, "of the pattern's numbers, when its file does not say: mm, cm, m, in")
      ->type_name("UNIT");
  auto* size = drape->add_option("--size", options.size, "of the mannequin: a row of the size chart")
                   ->type_name("SIZE")
                   ->capture_default_str();
  drape->add_option("--chart", options.chart, "size chart of templates/mannequins: women, men")
      ->type_name("NAME")
      ->capture_default_str();
  auto* body = drape->add_option("--body", options.body, "a body of your own (OBJ, metres, Y up) instead of a size");
  body->type_name("OBJ")->excludes(size);
  drape->add_option("--skeleton", options.skeleton, "its bones (default: NAME.skeleton.json beside the body)")
      ->type_name("JSON")
      ->needs(body);
  drape
      ->add_option("--fabric", options.fabric,
                   "one of templates/fabrics (jersey, denim, silk_chiffon, ...), or the path of such a file")
      ->type_name("NAME|FILE")
      ->capture_default_str();
  drape
      ->add_option("--simulator", options.simulator,
                   "fem; mass-spring; external:NAME or a file, a program of your own (templates/simulators)")
      ->type_name("NAME|FILE")
      ->capture_default_str();
  drape->add_option("--edge-length", options.edge_length, "of the triangles; shorter is finer and slower")
      ->type_name("LENGTH")
      ->capture_default_str();
  drape->add_option("--tolerance", options.tolerance, "it rests when unbalanced force / weight is below this")
      ->type_name("SHARE")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  drape
      ->add_option("--time-limit", options.time_limit,
                   "for coming to rest, after dressing; then the best state so far is written, exit code 11")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  drape->add_option("--go-on", options.go_on, "from the drape.obj of an earlier run of the same pattern and edge length")
      ->type_name("OBJ");
  return drape;
}

int main_program(int argc, char** argv) {
  CLI::App app("Toile: edit a garment in 3D, get back 2D patterns that drape into that shape", "toile");
  app.set_version_flag("--version", std::string("toile ") + TOILE_VERSION);
  app.require_subcommand(1);
  app.footer(std::string(examples) + "\n" + footer);

  RunOptions run_options;
  DrapeOptions drape_options;
  Common common;
  CLI::App* run = add_run(app, run_options);
  CLI::App* drape = add_drape(app, drape_options);
  common.add_to(run, run_help);
  common.add_to(drape, drape_help);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  common.give(run_options);
  common.give(drape_options);
  interrupt_by_signals();
  try {
    return *drape ? drape_pattern(drape_options) : run_recipe(run_options);
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
