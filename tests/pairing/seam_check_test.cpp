#include "pairing/seam_check.h"

#include <gtest/gtest.h>

#include "pairing/pieces.h"

namespace toile {
namespace {

Pattern two_strips(double second) {
  Pattern pattern;
  pattern.pieces = {test::polygon("a", {{0, 0}, {.5, 0}, {.5, .1}, {0, .1}}),
                    test::polygon("b", {{0, 0}, {second, 0}, {second, .1}, {0, .1}})};
  pattern.seams = {{"join", {"a", 1, "e0", 0, 1}, {"b", 1, "e0", 0, 1}, false}};
  return pattern;
}

TEST(SeamCheck, MeasuresTheDifferenceOfLengths) {
  const auto checks = check_seams(two_strips(.504));
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_NEAR(checks[0].mismatch, 4e-3, 1e-12);
}

TEST(SeamCheck, LeavesOutTheEaseThatIsMeant) {
  EXPECT_NEAR(check_seams(two_strips(.504), {{"join", 3e-3}})[0].mismatch, 1e-3, 1e-12);
  EXPECT_EQ(check_seams(two_strips(.504), {{"join", 5e-3}})[0].mismatch, 0);
}

TEST(SeamCheck, HoldsNotchAgainstNotch) {
  Pattern pattern = two_strips(.5);
  pattern.pieces[0].notches = {{"e0", .4}, {"e0", .8}};
  pattern.pieces[1].notches = {{"e0", .404}};
  const SeamCheck check = check_seams(pattern)[0];
  ASSERT_EQ(check.notches.size(), 1u);
  EXPECT_NEAR(check.notch_mismatch, 2e-3, 1e-12);
  EXPECT_EQ(check.lonely_notches, 1);
}

}  // namespace
}  // namespace toile
