#include "cli/verbs.h"

namespace toile {

std::vector<Verb> add_verbs(CLI::App& app) {
  return {
      add_run(app),   add_drape(app), add_inspect(app), add_convert(app), add_sew(app),
      add_check(app), add_edit(app),  add_grade(app),   add_bench(app),
  };
}

}  // namespace toile
