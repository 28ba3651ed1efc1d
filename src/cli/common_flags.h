#pragma once
// What verbs share on the command line: exit codes in the help, and the flags of verbs that fill a folder.

#include <CLI/CLI.hpp>
#include <string>

#include "cli/progress.h"

namespace toile {

inline constexpr const char* exit_codes_help = R"(Exit codes:
   0  done                         64  wrong use of the command line
  10  written, but a check failed  65  bad input (the message names file, place and remedy)
  11  did not converge: the best   66  a file is missing
      state so far is written      73  the output cannot be written
  12  ambiguous units: say which   75  interrupted
   1, 70  a fault of the program
Lengths are written with their unit: "10 cm", "5 mm", "5/8 in".)";

// Flags of a verb that writes a folder.
struct FolderFlags {
  std::filesystem::path out;
  bool force = false, quiet = false;
  std::string progress = "auto";

  void add_to(CLI::App* verb, const std::string& explained) {
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

}  // namespace toile
