#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>

#include "edit/operation.h"
#include "edit/worn_skirt.h"
#include "geometry/surface_distance.h"
#include "style/normal_deviation.h"
#include "style/synthetic_skirt.h"

namespace toile {
namespace {

using testing::SkirtShape;
using testing::synthetic_skirt;
using testing::SyntheticSkirt;

constexpr double degree = std::numbers::pi / 180;

struct Scene : testing::WornSkirt {
  using WornSkirt::WornSkirt;
  Target length(const EditArguments& arguments, const Eigen::Matrix3Xd& drape) const {
    return find_operation("length").apply({skirt.pattern, skirt.garment, drape, body}, arguments);
  }
  Target length(const EditArguments& arguments) const { return apply("length", arguments); }
  Finding finding(const EditArguments& arguments) const { return refusal("length", arguments); }
};

const Scene& full() {
  static const Scene scene;
  return scene;
}
const Scene& small() {
  static const Scene scene({.columns = 48, .rows = 30});
  return scene;
}

double greatest(const Eigen::Matrix3Xd& difference) { return difference.colwise().norm().maxCoeff(); }

TEST(Length, SlidesTheHemByFifteenCentimetresWithItsFolds) {
  const Target target = full().length({{"by", "15 cm"}});
  EXPECT_LT(target.normal_deviation_mean, 0.5 * degree);
  EXPECT_LT(target.normal_deviation_max, 3 * degree);
  const auto triangles = source_triangles(target.source, target.garment.triangles);
  const NormalDeviation deviation = normal_deviation(triangles, target.source, target.positions);
  EXPECT_TRUE(deviation.flipped.empty());
  EXPECT_LT(deviation.most_stretch, 1.6);
  EXPECT_GT(deviation.least_stretch, 0.8);
  EXPECT_LT(target.after.shape, 1e-4);
}

// Beyond its hem a skirt without folds goes on as it hangs: as one that was longer from the beginning.
TEST(Length, CarriesTheClothOnBeyondTheHem) {
  const SkirtShape shape{.folds = 0, .fold_depth = 0, .jitter = 0};
  SkirtShape longer = shape;
  longer.length += 0.10;
  const Scene plain(shape);
  const Target target = plain.length({{"by", "10 cm"}});
  const SyntheticSkirt whole = synthetic_skirt(longer);
  const SurfaceDistance off =
      surface_distance({target.positions, target.garment.triangles}, {whole.drape, whole.garment.triangles});
  EXPECT_LT(off.hausdorff, 2e-3);
  EXPECT_LT(off.mean, 0.2e-3);
}

TEST(Length, MovesTheLoopAsFarAsAskedAndNothingBeyondTheAnchor) {
  for (const double by : {0.10, -0.10, -0.20}) {
    const Target target = small().length({{"by", std::to_string(by) + " m"}});
    ASSERT_EQ(target.held.size(), 48u);
    double mean = 0;
    for (const int v : target.held) {
      const double moved = target.source(1, v) - target.positions(1, v);
      EXPECT_NEAR(moved, by, 0.1 * std::abs(by)) << "the same length of cloth all round, not of height";
      mean += moved / 48;
    }
    EXPECT_NEAR(mean, by, 1e-5);
    double lowest = 2;
    for (const int v : target.anchor) lowest = std::min(lowest, target.source(1, v));
    EXPECT_GT(lowest, 0.7);
    for (Eigen::Index v = 0; v < target.source.cols(); ++v)
      EXPECT_TRUE(target.source(1, v) < lowest || target.positions.col(v) == target.source.col(v)) << "vertex " << v;
  }
}

TEST(Length, KeepsTheFlareOfAShortenedHem) {
  const Target target = full().length({{"by", "-10 cm"}, {"anchor", "hip"}});
  EXPECT_LT(target.normal_deviation_mean, 0.5 * degree);
  // The cone of the skirt at its new hem: 43 cm of flare of 0.25 have become 33 cm.
  double mean = 0;
  for (const int v : target.held)
    mean += std::hypot(target.positions(0, v), target.positions(2, v)) / double(target.held.size());
  double before = 0;
  for (const int v : target.held) before += std::hypot(target.source(0, v), target.source(2, v)) / double(target.held.size());
  EXPECT_NEAR(before - mean, 0.25 * 0.10, 3e-3);
}

TEST(Length, SpreadsTheChangeEvenlyBetweenAnchorAndHem) {
  const Target target = full().length({{"by", "-20 cm"}, {"anchor", "hip"}});
  // Rows of the mesh: their mean heights shrink towards the hip in one ratio.
  const double wanted = (0.43 - 0.20) / 0.43;
  // The anchor itself is a row of the mesh next to that height, which tells in the first two.
  for (int r = 24; r < 60; ++r) {
    double before = 0, after = 0;
    for (int v = r * 96; v < (r + 1) * 96; ++v) {
      before += (0.83 - target.source(1, v)) / 96;
      after += (0.83 - target.positions(1, v)) / 96;
    }
    EXPECT_NEAR(after / before, wanted, 0.08) << "row " << r;
  }
}

TEST(Length, GivesTheSourceBackForNoMove) {
  EXPECT_LT(greatest(small().length({{"by", "0"}}).positions - small().skirt.drape), 1e-9);
}

TEST(Length, ComesBackWhenUndone) {
  const Target down = full().length({{"by", "10 cm"}, {"anchor", "hip"}});
  const Target back = full().length({{"by", "-10 cm"}, {"anchor", "hip"}}, down.positions);
  // As surfaces: lengthening stretches the cloth, shortening slides it back, so the vertices do not return to where they were.
  const Eigen::Matrix3Xi& triangles = full().skirt.garment.triangles;
  const SurfaceDistance off = surface_distance({back.positions, triangles}, {full().skirt.drape, triangles});
  EXPECT_LT(off.hausdorff, 8e-3);
  EXPECT_LT(off.mean, 1e-3);
}

TEST(Length, IsTheSameByAnyNameOfTheLoop) {
  const Scene other({.columns = 48, .rows = 30, .named_edges = false});
  const Eigen::Matrix3Xd named = small().length({{"by", "5 cm"}}).positions;
  EXPECT_EQ(named, small().length({{"by", "50 mm"}, {"loop", "gore.hem"}}).positions);
  EXPECT_EQ(named, other.length({{"by", "5 cm"}}).positions);
}

TEST(Length, StaysOutOfTheBody) {
  for (const char* anchor : {"auto", "waist"}) {
    const Target target = small().length({{"by", "-20 cm"}, {"anchor", anchor}});
    double least = 1;
    for (Eigen::Index v = 0; v < target.positions.cols(); ++v)
      least = std::min(least, small().body.distance.distance(target.positions.col(v)));
    EXPECT_GT(least, 0) << anchor;
    for (const Finding& finding : target.report.findings) EXPECT_NE(finding.code, "edit.touches-body");
  }
}

// The tight part slides along the hip; it must stay on the skin under it, not on the skin it came from.
TEST(Length, KeepsTheFitOfWhatSlides) {
  const Target target = small().length({{"by", "10 cm"}, {"anchor", "waist"}});
  double worst = 0;
  for (int v = 48; v < 5 * 48; ++v)
    worst = std::max(worst, std::abs(small().body.distance.distance(target.positions.col(v)) - 5e-3));
  EXPECT_LT(worst, 3e-3);
}

TEST(Length, MovesALoopInTheMiddleAndWhatIsBelowFollowsOrStays) {
  const Target follows = small().length({{"by", "4 cm"}, {"loop", "thigh.L:0.5"}, {"anchor", "hip"}});
  const Target stays = small().length({{"by", "4 cm"}, {"loop", "thigh.L:0.5"}, {"anchor", "hip"}, {"stay", "hem"}});
  double followed = 0, stayed = 0;
  for (int v = 29 * 48; v < 30 * 48; ++v) {
    followed += (follows.source(1, v) - follows.positions(1, v)) / 48;
    stayed += std::abs(stays.source(1, v) - stays.positions(1, v)) / 48;
  }
  EXPECT_NEAR(followed, 0.04, 0.01);
  EXPECT_LT(stayed, 0.005);
  EXPECT_GT(stays.before.proportion + stays.after.proportion, 0);
}

TEST(Length, MovesTheWaistUpAgainstTheHip) {
  const Target target = small().length({{"by", "3 cm"}, {"loop", "waist"}, {"anchor", "hip"}});
  for (const int v : target.held) EXPECT_NEAR(target.positions(1, v) - target.source(1, v), 0.03, 1e-3);
  for (int v = 20 * 48; v < 30 * 48; ++v) EXPECT_EQ(target.positions.col(v), target.source.col(v));
}

TEST(Length, RefusesToPassTheAnchorAndSaysWhatIsPossible) {
  const Finding finding = small().finding({{"by", "-42 cm"}, {"anchor", "hip"}});
  EXPECT_EQ(finding.code, "edit.past-anchor");
  EXPECT_NE(finding.remedy.find("at most 3"), std::string::npos) << finding.remedy;
}

TEST(Length, RefusesToCutOffWhatHoldsTheGarment) {
  const Finding finding = small().finding({{"by", "-60 cm"}, {"anchor", "waist"}});
  EXPECT_EQ(finding.code, "edit.slips-off");
  EXPECT_NE(finding.remedy.find("mm"), std::string::npos);
}

TEST(Length, RefusesToGoBelowTheFloor) {
  const Finding finding = small().finding({{"by", "45 cm"}});
  EXPECT_EQ(finding.code, "edit.below-floor");
  EXPECT_NE(finding.remedy.find("400 mm"), std::string::npos) << finding.remedy;
}

TEST(Length, RefusesAnAnchorThatBoundsNothing) {
  EXPECT_EQ(small().finding({{"by", "5 cm"}, {"anchor", "hem"}}).code, "edit.anchor-elsewhere");
}

TEST(Length, RefusesLengthsWithoutUnitAndUnknownLoops) {
  EXPECT_EQ(small().finding({{"by", "10"}}).code, "edit.bad-length");
  EXPECT_EQ(small().finding({{"by", "5 cm"}, {"loop", "cuff"}}).code, "edit.unknown-loop");
  EXPECT_EQ(small().finding({{"by", "5 cm"}, {"anchor", "elbow"}}).code, "edit.unknown-loop");
}

}  // namespace
}  // namespace toile
