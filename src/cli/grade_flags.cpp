#include <CLI/CLI.hpp>
#include <memory>

#include "cli/common_flags.h"
#include "cli/grade_verb.h"
#include "cli/verbs.h"

namespace toile {
namespace {

constexpr const char* help =
    R"(Drapes the recipe's size once, makes its edits, carries the garment over to the body of every size asked for (its ease,
proportions and style kept), and adjusts the pattern of each until its drape is that garment. The method of carrying over is
patented (US 9177423, EP 2856433): check before commercial use.

Written to the output folder:
  SIZE/                       for every size what `toile run` writes
  grading.html                the sizes side by side: error of the re-drape, ease, pieces, what every corner moves
  NAME.nest.dxf               every size in one file (AAMA), one block for each size of each piece
  NAME.base.dxf, NAME.rul     the recipe's size with grade rule numbers, and their table
Both graded files are read back: every size comes out within 0.05 mm.)";

}  // namespace

Verb add_grade(CLI::App& app) {
  const auto given = std::make_shared<GradeOptions>();
  const auto folder = std::make_shared<FolderFlags>();
  CLI::App* grade = app.add_subcommand("grade", "a recipe in a range of sizes, every one draped and measured");
  grade->add_option("recipe", given->recipe, "the recipe (TOML), for a size of a chart")->required()->type_name("RECIPE.toml");
  grade->add_option("--sizes", given->sizes, "of the recipe's chart, with commas: 34,36,38,40")->required()->type_name("LIST");
  folder->add_to(grade, help);
  return {grade, [given, folder] {
            folder->give(*given);
            return grade_recipe(*given);
          }};
}

}  // namespace toile
