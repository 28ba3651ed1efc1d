#include "edit/in_turn.h"

#include <gtest/gtest.h>

#include "edit/worn_skirt.h"

namespace toile {
namespace {

const testing::WornSkirt& scene() {
  static const testing::WornSkirt made({.columns = 48, .rows = 30});
  return made;
}

TEST(InTurn, KeepsEdgesTogetherAndLevelsApart) {
  const EditInput input = scene().input();
  EXPECT_EQ(names_apart(input, "hem"), std::vector<std::string>({"hem"}));
  EXPECT_EQ(names_apart(input, "gore:1.side_left, gore:2.side_left").size(), 1u);
  EXPECT_EQ(names_apart(input, "thigh.L:0.5, thigh.R:0.5"), std::vector<std::string>({"thigh.L:0.5", "thigh.R:0.5"}));
}

TEST(InTurn, MovesEachHandleOnWhatTheOneBeforeMade) {
  const std::string level = "hip";
  const Target both = scene().apply("fit", {{"loop", "hem," + level}, {"by", "1 cm"}, {"anchor", "waist"}});
  const std::vector<std::string> names = names_apart(scene().input(), "hem," + level);
  ASSERT_EQ(names.size(), 2u);
  const Target one = scene().apply("fit", {{"loop", names[0]}, {"by", "1 cm"}, {"anchor", "waist"}});
  EditInput next = scene().input();
  const Target other = find_operation("fit").apply({next.pattern, next.garment, one.positions, next.body},
                                                   {{"loop", names[1]}, {"by", "1 cm"}, {"anchor", "waist"}});
  EXPECT_EQ(both.positions, other.positions);
  EXPECT_EQ(both.source, scene().skirt.drape);
  EXPECT_EQ(both.held.size(), one.held.size() + other.held.size());
  EXPECT_GT(both.normal_deviation_mean, 0);
}

TEST(InTurn, NamesTheHandleThatIsNotThere) {
  const Finding finding = scene().refusal("length", {{"loop", "hem,elbow.L:0.5"}, {"by", "1 cm"}});
  EXPECT_EQ(finding.code, "edit.unknown-loop");
  EXPECT_NE(finding.text.find("elbow.L:0.5"), std::string::npos);
}

}  // namespace
}  // namespace toile
