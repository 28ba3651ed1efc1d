#include <CLI/CLI.hpp>
#include <memory>

#include "cli/check_verb.h"
#include "cli/common_flags.h"
#include "cli/verbs.h"

namespace toile {

Verb add_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* check = app.add_subcommand("check", "do the edges that are sewn together fit, notch to notch");
  check->footer(
      std::string("One line a seam, in mm and inch: 1 mm apart is a warning, 3 mm fails (exit code 10). Ease that the seams "
                  "file says is\n"
                  "meant does not count. A pattern without seams is checked with those that `toile sew` would propose.\n\n") +
      exit_codes_help);
  check->add_option("pattern", options->pattern, "a pattern file")->required()->type_name("PATTERN");
  check->add_option("--seams", options->seams, "what is sewn to what (default: NAME.seams.toml beside the pattern)")
      ->type_name("FILE");
  check->add_option("--units", options->units, "of the pattern's numbers, when its file does not say: mm, cm, m, in")
      ->type_name("UNIT");
  check->add_option("--size", options->size, "of a graded pattern (default: the sample size)")->type_name("SIZE");
  check->add_flag("--json", options->json, "as one JSON object on standard output");
  return {check, [options] { return check_pattern(*options); }};
}

}  // namespace toile
