#pragma once
// What verbs share on the command line: exit codes in the help, and the flags of verbs that fill a folder.

#include <filesystem>
#include <string>

#include "cli/progress.h"

namespace CLI {
class App;
}

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

  void add_to(CLI::App* verb, const std::string& explained);

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
