#include "workbench/replica.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "formats/formats.h"
#include "style/synthetic_skirt.h"

namespace toile {
namespace {

TEST(Replica, EveryLengthOfAPatternIsScaled) {
  const Pattern pattern = value_or_throw(read_pattern(std::string(TOILE_SOURCE_DIR) + "/samples/gored_skirt/gored_skirt.dxf"));
  const Pattern half = scaled(pattern, .5);
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    EXPECT_NEAR(signed_area(half.pieces[p]), signed_area(pattern.pieces[p]) / 4, 1e-12);
    for (std::size_t n = 0; n < pattern.pieces[p].notches.size(); ++n) {
      EXPECT_EQ(half.pieces[p].notches[n].at, pattern.pieces[p].notches[n].at);
      EXPECT_EQ(half.pieces[p].notches[n].depth, pattern.pieces[p].notches[n].depth / 2);
    }
  }
  EXPECT_EQ(scaled(half, 2), pattern);
}

TEST(Replica, GarmentTargetAndBodyAreScaledTogether) {
  const testing::SyntheticSkirt skirt = testing::synthetic_skirt({.columns = 24, .rows = 10});
  const Body body = make_body(skirt.form);
  Target target;
  target.garment = skirt.garment;
  target.source = target.positions = skirt.drape;
  const double factor = .3 / body.form.height;
  const Target small = replica(target, skirt.pattern, body, .3);
  EXPECT_NEAR(small.body->form.height, .3, 1e-12);
  EXPECT_TRUE(small.positions.isApprox(factor * target.positions));
  EXPECT_TRUE(small.source.isApprox(factor * target.source));
  EXPECT_TRUE(small.garment.panels[0].rest.isApprox(factor * target.garment.panels[0].rest));
  EXPECT_EQ(small.garment.triangles, target.garment.triangles);
  EXPECT_EQ(small.pattern->seams, skirt.pattern.seams);
  for (const auto& [name, level] : body.form.landmarks) EXPECT_NEAR(small.body->form.landmarks.at(name), factor * level, 1e-12);
  // As far from the body as before, by the same factor.
  for (int v = 0; v < 50; ++v)
    EXPECT_NEAR(small.body->distance.distance(small.positions.col(v)), factor * body.distance.distance(target.positions.col(v)),
                1e-4);
  EXPECT_THROW(replica(target, skirt.pattern, body, .02), BadInput);
}

TEST(Replica, AllowancesCanStillBeSewn) {
  EXPECT_DOUBLE_EQ(replica_allowance(30e-3, .5), 15e-3);
  EXPECT_DOUBLE_EQ(replica_allowance(10e-3, .1), 4e-3);
  EXPECT_DOUBLE_EQ(replica_allowance(2e-3, .1), 2e-3);  // narrower than can be sewn before
  EXPECT_DOUBLE_EQ(replica_allowance(0, .1), 0);        // a fold
}

}  // namespace
}  // namespace toile
