#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "cli/common_flags.h"
#include "cli/exit_codes.h"
#include "cli/verbs.h"
#include "garment/report.h"

namespace toile {
namespace {

constexpr const char* examples = R"(Try:
  toile drape samples/gored_skirt/gored_skirt.dxf --size 38 --fabric jersey --out hangs
  toile run samples/gored_skirt/shorten.toml --out shorter
`toile drape --help` and `toile run --help` say what these need and what they write; look at report.html first.
)";

int main_program(int argc, char** argv) {
  CLI::App app("Toile: edit a garment in 3D, get back 2D patterns that drape into that shape", "toile");
  app.set_version_flag("--version", std::string("toile ") + TOILE_VERSION);
  app.require_subcommand(1);
  app.footer(std::string(examples) + "\n" + exit_codes_help);

  const std::vector<Verb> verbs = add_verbs(app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  interrupt_by_signals();
  try {
    for (const Verb& verb : verbs)
      if (*verb.app) return verb.act();
    return exit_usage;
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
