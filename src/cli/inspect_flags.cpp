#include <CLI/CLI.hpp>
#include <memory>

#include "cli/common_flags.h"
#include "cli/inspect_verb.h"
#include "cli/verbs.h"

namespace toile {
namespace {

constexpr const char* help =
    R"(Says what a pattern file holds: format, unit and how it was decided, sizes, and for each piece its size in mm and inch,
copies, corners, notches, grain and where its sew line comes from; then everything that was left out or looks wrong.
A file that cannot be read is explained the same way, and the exit code says what kind of trouble it is.)";

}  // namespace

Verb add_inspect(CLI::App& app) {
  const auto given = std::make_shared<InspectOptions>();
  InspectOptions& options = *given;
  CLI::App* inspect = app.add_subcommand("inspect", "what a pattern file holds");
  inspect->footer(std::string(help) + "\n\n" + exit_codes_help);
  inspect->add_option("file", options.file, "a pattern in any format Toile reads")->required()->type_name("FILE");
  inspect->add_flag("--json", options.json, "for programs: one JSON object, schema 1 (formats/inspection/README.md)");
  inspect->add_option("--units", options.units, "of the file's numbers, whatever it says: mm, cm, m, in")->type_name("UNIT");
  inspect->add_option("--size", options.size, "of a graded file, that size alone")->type_name("SIZE");
  inspect->add_option("--seams", options.seams, "what is sewn to what (default: NAME.seams.toml beside the file)")
      ->type_name("FILE");
  inspect->add_option("--png", options.png, "also a picture of all pieces at one scale")->type_name("FILE");
  return {inspect, [given] { return inspect_pattern(*given); }};
}

}  // namespace toile
