#include <CLI/CLI.hpp>
#include <memory>

#include "cli/bench_verb.h"
#include "cli/common_flags.h"
#include "cli/verbs.h"

namespace toile {
namespace {

constexpr const char* help =
    R"(Runs edits of the kinds in Table 1 of the paper (Bartle et al. 2016) on the samples, with about its numbers of triangles, and
prints both figures beside each other; or one of them on ever finer meshes. templates/table1 and templates/scalability have the
recipes.

Written to the output folder:
  TABLE.csv, TABLE.txt          the table, for programs and for people
  stretch.png, hausdorff.png    both by iteration
  ROW/                          for every row what `toile run` writes)";

}  // namespace

Verb add_bench(CLI::App& app) {
  const auto given = std::make_shared<BenchOptions>();
  const auto folder = std::make_shared<FolderFlags>();
  CLI::App* bench_app = app.add_subcommand("bench", "the paper's Table 1, or its test of scalability, on the samples");
  bench_app->add_option("table", given->table, "table1 or scalability")->required()->check(CLI::IsMember({"table1", "scalability"}));
  bench_app->add_option("--rows", given->rows, "only these, with commas: \"Fig. 2,Fig. 10\"")->type_name("LIST");
  folder->add_to(bench_app, help);
  return {bench_app, [given, folder] {
            folder->give(*given);
            return bench(*given);
          }};
}

}  // namespace toile
