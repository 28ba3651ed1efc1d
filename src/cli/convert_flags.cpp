#include <CLI/CLI.hpp>
#include <memory>

#include "cli/common_flags.h"
#include "cli/convert_verb.h"
#include "cli/verbs.h"
#include "formats/dxf_aama/profiles.h"
#include "formats/pdf/papers.h"

namespace toile {
namespace {

constexpr const char* help =
    R"(Reads a pattern and writes it in the format that the name of OUT says. What that format cannot hold is said, nothing is
dropped in silence.

  .dxf   pieces with cut line and sew line, layers of AAMA (--profile); seams in OUT.seams.toml beside it
         of a graded pattern every size (nest), or the sample size and OUT.rul (--grading rules)
  .svg   cut sheet at true size, data-* on every line; one size
  .pdf   the same to print: one page (roll, copy shop, projector), or pages to tape (--paper a4); one size
  .json  GarmentCode specification: net line, seams, places; one size
  .obj   the drape the pattern came with, else its pieces flat; vt is the pattern in metres

Halves on a fold are unfolded when they are read, so that OUT has whole pieces.

Profiles:)";

std::string explained() {
  std::string text = help;
  for (const DxfProfile& profile : dxf_profiles)
    text += "\n  " + std::string(profile.name) + std::string(9 - profile.name.size(), ' ') + std::string(profile.says);
  return text;
}

}  // namespace

Verb add_convert(CLI::App& app) {
  const auto given = std::make_shared<ConvertOptions>();
  ConvertOptions& options = *given;
  CLI::App* verb = app.add_subcommand("convert", "a pattern in another format");
  verb->footer(explained() + "\n\n" + exit_codes_help);
  verb->add_option("in", options.in, "a pattern in any format Toile reads")->required()->type_name("IN");
  verb->add_option("out", options.out, "its extension says the format: .dxf, .svg, .pdf, .json, .obj")
      ->required()
      ->type_name("OUT");
  verb->add_option("--profile", options.profile, "of DXF; see below")->type_name("NAME")->capture_default_str();
  verb->add_option("--size", options.size, "of a graded pattern (default: its sample size)")->type_name("SIZE");
  verb->add_option("--grading", options.grading, "of a graded pattern as DXF: nest, rules (OUT.rul beside it), none")
      ->check(CLI::IsMember({"nest", "rules", "none"}))
      ->capture_default_str();
  verb->add_option(
          "--width", options.width,
          "of the sheet that the pieces are laid on, such as a plotter's roll (default: 1.5 m, or wider for a wide piece)")
      ->type_name("LENGTH");
  verb->add_option("--paper", options.paper, "of PDF: " + paper_names())
      ->check(CLI::Validator(
          [](std::string& name) {
            return find_paper(name) || is_roll(name) ? "" : "there is no paper '" + name + "': they are " + paper_names();
          },
          "", "paper"))
      ->type_name("PAPER")
      ->capture_default_str();
  verb->add_option("--margin", options.margin, "of the pages of PDF, that the printer cannot print on")
      ->type_name("LENGTH")
      ->capture_default_str();
  verb->add_option("--overlap", options.overlap, "of the pages of PDF, to glue on")->type_name("LENGTH")->capture_default_str();
  verb->add_option("--units", options.units, "of IN's numbers, when it does not say: mm, cm, m, in")->type_name("UNIT");
  verb->add_option("--seams", options.seams, "what is sewn to what (default: IN.seams.toml beside IN)")->type_name("FILE");
  verb->add_option("--allowance", options.allowance, "for edges that have none of their own (default: none)")
      ->type_name("LENGTH");
  verb->add_option("--hem", options.hem, "for hems that have none of their own (default: none)")->type_name("LENGTH");
  verb->add_flag("--unfold", options.unfold, "whole pieces are wanted where IN has halves on a fold: say nothing about it");
  verb->add_flag("--force,-f", options.force, "replace OUT and what belongs to it");
  verb->add_flag("--quiet,-q", options.quiet, "no notes or warnings");
  return {verb, [given] { return convert_pattern(*given); }};
}

}  // namespace toile
