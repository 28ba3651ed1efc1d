#include <CLI/CLI.hpp>
#include <memory>

#include "cli/common_flags.h"
#include "cli/sew_verb.h"
#include "cli/verbs.h"

namespace toile {

Verb add_sew(CLI::App& app) {
  const auto options = std::make_shared<SewOptions>();
  CLI::App* sew = app.add_subcommand("sew", "propose what is sewn to what");
  sew->footer(
      std::string(
          "Pairs the edges of the pieces by length, shape, notches, names and how the whole comes together, and writes what "
          "it\n"
          "finds as a seams file with a comment for each seam: how sure it is, and why. Kept as NAME.seams.toml beside the\n"
          "pattern it is read with it.\n\n") +
      exit_codes_help);
  sew->add_option("pattern", options->pattern, "a pattern file; its own seams are not looked at")
      ->required()
      ->type_name("PATTERN");
  sew->add_option("--out,-o", options->out, "the seams file")->required()->type_name("FILE");
  sew->add_option("--units", options->units, "of the pattern's numbers, when its file does not say: mm, cm, m, in")
      ->type_name("UNIT");
  sew->add_option("--size", options->size, "of a graded pattern (default: the sample size)")->type_name("SIZE");
  sew->add_flag("--force,-f", options->force, "replace the file when it exists");
  return {sew, [options] { return sew_pattern(*options); }};
}

}  // namespace toile
