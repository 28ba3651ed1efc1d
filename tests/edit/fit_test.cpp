#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "edit/operation.h"
#include "edit/worn_skirt.h"
#include "style/normal_deviation.h"
#include "style/synthetic_skirt.h"

namespace toile {
namespace {

using testing::SkirtShape;
using testing::synthetic_skirt;
using testing::SyntheticSkirt;

constexpr double degree = std::numbers::pi / 180;
constexpr int columns = 48, rows = 30;

struct Scene : testing::WornSkirt {
  using WornSkirt::WornSkirt;
  Target fit(const EditArguments& arguments) const { return apply("fit", arguments); }
  Finding refusal(const EditArguments& arguments) const { return WornSkirt::refusal("fit", arguments); }
};

const Scene& folded() {
  static const Scene scene({.columns = columns, .rows = rows});
  return scene;
}
const Scene& smooth() {
  static const Scene scene({.columns = columns, .rows = rows, .folds = 0, .fold_depth = 0, .jitter = 0});
  return scene;
}

double radius(const Eigen::Matrix3Xd& x, int v) { return std::hypot(x(0, v), x(2, v)); }
double greatest(const Eigen::Matrix3Xd& difference) { return difference.colwise().norm().maxCoeff(); }
double girth_of_row(const Eigen::Matrix3Xd& x, int row) {
  double length = 0;
  for (int c = 0; c < columns; ++c) length += (x.col(row * columns + c) - x.col(row * columns + (c + 1) % columns)).norm();
  return length;
}
bool says(const Target& target, const std::string& code) {
  for (const Finding& finding : target.report.findings)
    if (finding.code == code) return true;
  return false;
}

TEST(Fit, LoosensTheHemOfAConeAndNothingBeyondTheAnchor) {
  const Target target = smooth().fit({{"by", "2 cm"}});
  ASSERT_EQ(target.held.size(), static_cast<std::size_t>(columns));
  for (const int v : target.held) {
    EXPECT_NEAR(radius(target.positions, v) - radius(target.source, v), 0.02, 1e-4);
    EXPECT_NEAR(target.positions(1, v), target.source(1, v), 1e-12);
  }
  ASSERT_FALSE(target.anchor.empty());
  double lowest = 2;
  for (const int v : target.anchor) lowest = std::min(lowest, target.source(1, v));
  EXPECT_NEAR(lowest, 0.83, 0.05) << "the hip, where it leaves the body";
  for (Eigen::Index v = 0; v < target.source.cols(); ++v)
    EXPECT_TRUE(target.source(1, v) < lowest || target.positions.col(v) == target.source.col(v)) << "vertex " << v;
  EXPECT_LT(target.normal_deviation_max, 6 * degree);
}

TEST(Fit, MakesTheLoopLongerByWhatIsAsked) {
  for (const char* girth : {"6 cm", "-4 cm"}) {
    const Target target = folded().fit({{"girth", girth}});
    const double grown = girth_of_row(target.positions, rows - 1) - girth_of_row(target.source, rows - 1);
    EXPECT_NEAR(grown, girth[0] == '-' ? -0.04 : 0.06, 1.5e-3) << girth;
  }
}

TEST(Fit, GivesTheSourceBackForNoMove) {
  EXPECT_LT(greatest(folded().fit({{"by", "0"}}).positions - folded().skirt.drape), 1e-9);
  EXPECT_LT(greatest(folded().fit({{"by", "0"}, {"loop", "all"}}).positions - folded().skirt.drape), 1e-6);
}

TEST(Fit, StopsInwardsAtTheBodyAndSaysWhatEaseIsLeft) {
  const Target target = folded().fit({{"by", "-10 cm"}, {"loop", "thigh.L:0.2"}, {"anchor", "waist"}});
  EXPECT_TRUE(says(target, "edit.stopped-at-body"));
  EXPECT_TRUE(says(target, "edit.ease"));
  double least = 1;
  for (const int v : target.held) least = std::min(least, folded().body.distance.distance(target.positions.col(v)));
  EXPECT_GT(least, 1e-3);
  EXPECT_LT(least, 4e-3);
}

TEST(Fit, RefusesToTightenWhatLiesOnTheBody) {
  const EditArguments tighter{{"by", "-2 cm"}, {"loop", "waist"}};
  const Target tightened = folded().fit(tighter);
  EXPECT_TRUE(says(tightened, "edit.stopped-at-body"));
  try {
    find_operation("fit").apply({folded().skirt.pattern, folded().skirt.garment, tightened.positions, folded().body}, tighter);
    FAIL();
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "edit.no-room");
  }
}

TEST(Fit, LoosensTheWaistWithinItsReleaseAndWarnsThatItMaySlip) {
  const Target target = folded().fit({{"by", "2 cm"}, {"loop", "waist"}, {"anchor", "none"}, {"release", "1 m"}});
  for (const int v : target.held) EXPECT_NEAR(radius(target.positions, v) - radius(target.source, v), 0.02, 2e-3);
  EXPECT_TRUE(says(target, "edit.may-slip"));
  EXPECT_LT(target.normal_deviation_mean, 1.5 * degree);
  const Target near = folded().fit({{"by", "2 cm"}, {"loop", "waist"}});
  for (int v = 20 * columns; v < rows * columns; ++v) EXPECT_EQ(near.positions.col(v), near.source.col(v));
}

TEST(Fit, ChangesOnlyTheRangeOfAngles) {
  const Target target = smooth().fit({{"by", "2 cm"}, {"from", "-60 deg"}, {"to", "60 deg"}});
  double front = 0, back = 0;
  for (const int v : target.held) {
    const double angle = std::atan2(target.source(0, v), target.source(2, v));
    const double moved = (target.positions.col(v) - target.source.col(v)).norm();
    if (std::abs(angle) < 20 * degree) front = std::max(front, std::abs(moved - 0.02));
    if (std::abs(angle) > 61 * degree) back = std::max(back, moved);
  }
  EXPECT_LT(front, 2e-3);
  EXPECT_EQ(back, 0);
}

TEST(Fit, MeansTheWearersLeftByNinetyDegrees) {
  const Target target = smooth().fit({{"by", "2 cm"}, {"from", "60 deg"}, {"to", "120 deg"}});
  for (const int v : target.held) EXPECT_TRUE(target.source(0, v) >= 0 || target.positions.col(v) == target.source.col(v));
  EXPECT_GT((target.positions - target.source).row(0).maxCoeff(), 0.019);
}

TEST(Fit, LoosensTheWholeGarmentAllRound) {
  const Target target = smooth().fit({{"by", "1 cm"}, {"loop", "all"}});
  for (const int row : {0, 8, 15, 22, 29})
    for (int v = row * columns; v < (row + 1) * columns; ++v)
      EXPECT_NEAR(radius(target.positions, v) - radius(target.source, v), 0.01, 1.5e-3) << "row " << row;
  EXPECT_LT(target.normal_deviation_mean, 0.5 * degree);
  EXPECT_TRUE(says(target, "edit.may-slip"));
  const Target hung = smooth().fit({{"by", "1 cm"}, {"loop", "all"}, {"anchor", "waist"}});
  for (int v = 0; v < columns; ++v) EXPECT_EQ(hung.positions.col(v), hung.source.col(v));
}

TEST(Fit, KeepsFoldsThatItMovesOutwards) {
  const Target target = folded().fit({{"by", "3 cm"}});
  EXPECT_LT(target.normal_deviation_mean, 4 * degree);
  const auto triangles = source_triangles(target.source, target.garment.triangles);
  EXPECT_TRUE(normal_deviation(triangles, target.source, target.positions).flipped.empty());
}

TEST(Fit, StaysOutOfTheBodyWhenTightened) {
  const Target target = folded().fit({{"by", "-3 cm"}, {"loop", "thigh.L:0.3"}, {"anchor", "hip"}});
  for (Eigen::Index v = 0; v < target.positions.cols(); ++v)
    EXPECT_GT(folded().body.distance.distance(target.positions.col(v)), -1e-4) << "vertex " << v;
}

TEST(Fit, RefusesWhatCannotBeMeant) {
  EXPECT_EQ(folded().refusal({}).code, "edit.missing-parameter");
  EXPECT_EQ(folded().refusal({{"by", "1 cm"}, {"girth", "4 cm"}}).code, "edit.two-parameters");
  EXPECT_EQ(folded().refusal({{"by", "1 cm"}, {"from", "60 deg"}, {"to", "-60 deg"}}).code, "edit.bad-range");
  EXPECT_EQ(folded().refusal({{"by", "1 cm"}, {"from", "60"}}).code, "edit.bad-angle");
  EXPECT_EQ(folded().refusal({{"by", "1 cm"}, {"anchor", "hem"}}).code, "edit.anchor-elsewhere");
  EXPECT_EQ(folded().refusal({{"by", "1 cm"}, {"loop", "cuff"}}).code, "edit.unknown-loop");
  EXPECT_EQ(folded().refusal({{"by", "1 cm"}, {"loop", "all"}, {"to", "60 deg"}}).code, "edit.bad-range");
}

}  // namespace
}  // namespace toile
