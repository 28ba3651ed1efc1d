#pragma once
// Runs another program, without a shell, and is sure that it is gone afterwards.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace toile::external {

struct ChildOrder {
  std::vector<std::string> command;  // [0]: a path, see find_on_path
  std::filesystem::path folder;      // its working folder; stdout.txt and stderr.txt are written there
  std::optional<double> time_limit;  // s
  std::function<bool()> stop;        // asked some times a second; may throw, which ends the child as well
};

enum class ChildEnd { exited, signalled, out_of_time, stopped };

struct ChildOutcome {
  ChildEnd end = ChildEnd::exited;
  int code = 0;  // exit code, or number of the signal
};

// Throws std::system_error when the program cannot be started at all. The child has its own process group, which gets SIGTERM
// and, 2 s later, SIGKILL when it is to end.
ChildOutcome run_child(const ChildOrder& order);

// `name` itself when it has a slash, else where PATH has it; empty when there is no such program.
std::filesystem::path find_on_path(const std::string& name);

// The last lines, at most about `most` characters, of stderr.txt; of stdout.txt when that is empty.
std::string last_words(const std::filesystem::path& folder, std::size_t most = 800);

}  // namespace toile::external
