#include <CLI/CLI.hpp>
#include <memory>

#include "cli/common_flags.h"
#include "cli/drape_verb.h"
#include "cli/verbs.h"

namespace toile {
namespace {

constexpr const char* help =
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

}  // namespace

Verb add_drape(CLI::App& app) {
  const auto given = std::make_shared<DrapeOptions>();
  const auto folder = std::make_shared<FolderFlags>();
  DrapeOptions& options = *given;
  CLI::App* drape = app.add_subcommand("drape", "a pattern on a body, as it hangs");
  drape->add_option("pattern", options.pattern, "a pattern in any format Toile reads")->required()->type_name("PATTERN");
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
  folder->add_to(drape, help);
  return {drape, [given, folder] {
            folder->give(*given);
            return drape_pattern(*given);
          }};
}

}  // namespace toile
