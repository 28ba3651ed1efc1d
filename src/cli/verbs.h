#pragma once
// The verbs of the command line: each adds its own flags and help, and says what to do when it is the one that is meant.

#include <functional>
#include <vector>

namespace CLI {
class App;
}

namespace toile {

struct Verb {
  CLI::App* app = nullptr;
  std::function<int()> act;  // returns the exit code; throws BadInput, Interrupted
};

// In the order of the help.
std::vector<Verb> add_verbs(CLI::App& app);

Verb add_run(CLI::App& app);
Verb add_drape(CLI::App& app);
Verb add_convert(CLI::App& app);
Verb add_inspect(CLI::App& app);
Verb add_edit(CLI::App& app);
Verb add_grade(CLI::App& app);
Verb add_bench(CLI::App& app);

}  // namespace toile
