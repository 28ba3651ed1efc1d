#include "cli/common_flags.h"

#include <CLI/CLI.hpp>

namespace toile {

void FolderFlags::add_to(CLI::App* verb, const std::string& explained) {
  verb->footer(explained + "\n\n" + exit_codes_help);
  verb->add_option("--out,-o", out, "folder for the results; made when missing")->required()->type_name("DIR");
  verb->add_flag("--force,-f", force, "write into a folder that is not empty, replacing files of the same names");
  verb->add_option(
          "--progress", progress,
          "progress on standard error: a bar on a terminal, else a line a stage (auto); one JSON object a line (json); none")
      ->check(CLI::IsMember({"auto", "json", "none"}))
      ->capture_default_str();
  verb->add_flag("--quiet,-q", quiet, "the same as --progress none, and no notes or warnings");
}

}  // namespace toile
