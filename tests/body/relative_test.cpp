#include "body/relative.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "body/figure.h"
#include "body/tubes.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

const Body& body() {
  static const Body made = make_body(test::figure());
  return made;
}

int limb(const std::string& name) {
  const auto axes = limb_axes(body().form);
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i].name == name) return static_cast<int>(i);
  return -1;
}

const std::string& name_of(int limb) {
  static const auto axes = limb_axes(body().form);
  return axes[static_cast<std::size_t>(limb)].name;
}

RelativePlace on(const std::string& name, const Vec& at) {
  return relative_place(body(), limb_axes(body().form)[static_cast<std::size_t>(limb(name))], limb(name), at);
}

TEST(MakeBody, LeavesGivenLandmarksAlone) {
  EXPECT_EQ(body().form.landmarks.at("waist"), 1.05);
  EXPECT_EQ(body().form.landmarks.at("crotch"), .78);
  EXPECT_EQ(body().form.landmarks.count("bust"), 1u);
}

TEST(LimbAxes, RunFromTheHeadToTheFloorAndOutTheLimbs) {
  const auto axes = limb_axes(body().form);
  ASSERT_EQ(axes.size(), 5u);
  EXPECT_EQ(axes[0].name, "trunk");
  EXPECT_EQ(axes[0].points.front(), Vec(0, 1.7, 0));
  EXPECT_EQ(axes[0].points.back(), Vec(0, 0, 0));
  EXPECT_NEAR(axes[0].body_end, 1.7 - .82, 1e-12);
  for (std::size_t i = 1; i < axes[0].points.size(); ++i) EXPECT_LT(axes[0].points[i][1], axes[0].points[i - 1][1]);
  EXPECT_EQ(axes[static_cast<std::size_t>(limb("leg.L"))].points.front(), Vec(.09, .82, 0));
  EXPECT_EQ(axes[static_cast<std::size_t>(limb("arm.R"))].points.back(), Vec(-.50, 1.01, 0));
}

TEST(LimbAxes, FallBackOnEveryBoneAndOnTheUprightLine) {
  Mannequin form = test::figure();
  for (Bone& bone : form.bones) bone.name = "rig_" + bone.name;
  EXPECT_EQ(limb_axes(form).size(), form.bones.size());
  form.bones.clear();
  const auto axes = limb_axes(form);
  ASSERT_EQ(axes.size(), 1u);
  EXPECT_LT(axes[0].points.front().cwiseProduct(Vec(1, 0, 1)).norm(), 1e-3);
}

TEST(RelativePlace, HasAClosedFormBesideACylinder) {
  for (const double angle : {0., .7, 2., 4.}) {
    const Vec out(std::sin(angle), 0, std::cos(angle));
    const RelativePlace place = on("trunk", Vec(0, 1.0, 0) + .20 * out);
    EXPECT_LT((place.on_axis - Vec(0, 1.0, 0)).norm(), 1e-9);
    EXPECT_LT((place.outward - out).norm(), 1e-9);
    EXPECT_EQ(place.axis, Vec(0, -1, 0));
    EXPECT_NEAR(place.along, .7, 1e-12);
    EXPECT_NEAR(place.beyond, 0, 1e-12);
    EXPECT_NEAR(place.offset, .05, 4e-4);  // the cylinder has 48 sides
    EXPECT_LT((place.on_skin - Vec(0, 1.0, 0) - .15 * out).norm(), 4e-4);
    EXPECT_TRUE(place.through_skin);
  }
}

TEST(RelativePlace, IsNegativeInsideTheSkin) {
  const RelativePlace place = on("trunk", {0, 1.0, .14});
  EXPECT_NEAR(place.offset, -.01, 4e-4);
  EXPECT_NEAR(place.on_skin[2], .15, 4e-4);
}

TEST(RelativePlace, PassesOverWallsInsideTheBody) {
  // The leg's top lies inside the trunk: its wall is no skin there.
  const RelativePlace outside = on("trunk", {.20, .80, 0}), inside = on("trunk", {.03, .80, 0});
  EXPECT_NEAR(outside.on_skin[0], .16, 4e-4);  // the leg stands out of the trunk by a centimetre
  EXPECT_NEAR(inside.on_skin[0], .16, 4e-4);
}

TEST(RelativePlace, GoesPastTheEndOfAnAxis) {
  const RelativePlace place = on("arm.L", Vec(.50, 1.01, 0) + .03 * Vec(1, -1, 0).normalized() + Vec(0, 0, .01));
  EXPECT_NEAR(place.beyond, .03, 1e-9);
  EXPECT_LT((place.axis - Vec(1, -1, 0).normalized()).norm(), 1e-9);
}

TEST(RelativePlace, FindsNoSkinBetweenTheLegs) {
  const RelativePlace place = on("trunk", {0, .4, .20});
  EXPECT_FALSE(place.through_skin);
  EXPECT_LT((place.outward - Vec::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(place.offset, std::hypot(.09, .20) - .07, 1e-3);
  EXPECT_TRUE(on("trunk", {.2, .4, 0}).through_skin);
}

TEST(RelativePlace, HasADirectionOnTheAxisItself) {
  const RelativePlace place = on("trunk", {0, 1.0, 0});
  EXPECT_NEAR(place.outward.norm(), 1, 1e-12);
  EXPECT_NEAR(place.outward.dot(place.axis), 0, 1e-12);
}

TEST(RelativePlace, TurnsTheAxisSmoothlyRoundABend) {
  LimbAxis bent;
  bent.points = {{0, 1, 0}, {0, .5, 0}, {.3, .2, 0}};
  bent.body_end = .5 + std::hypot(.3, .3);
  Vec before = -Vec::UnitY();
  for (double angle = 0; angle <= .8;
       angle += .02) {  // on the outer side of the bend, from square to one bone to square to the other
    const Vec at = Vec(0, .5, 0) - .1 * Vec(std::cos(angle), std::sin(angle), 0);
    const RelativePlace place = relative_place(body(), bent, 0, at);
    EXPECT_LT((place.axis - before).norm(), .05);
    EXPECT_NEAR(place.beyond, 0, 2e-3);
    before = place.axis;
  }
  EXPECT_LT((before - Vec(1, -1, 0).normalized()).norm(), .05);
}

TEST(RelativePlace, ChoosesTheLimbThatAPointHangsOn) {
  EXPECT_EQ(name_of(relative_place(body(), {0, 1.1, .17}).limb), "trunk");
  EXPECT_EQ(name_of(relative_place(body(), {.10, .4, .09}).limb), "leg.L");
  EXPECT_EQ(name_of(relative_place(body(), {-.10, .4, .09}).limb), "leg.R");
  EXPECT_EQ(name_of(relative_place(body(), Vec(.4, 1.11, .06)).limb), "arm.L");
  EXPECT_EQ(name_of(relative_place(body(), Vec(-.36, 1.20, 0)).limb), "arm.R");  // on its outer side, with the trunk behind it
}

TEST(RelativePlaces, GiveASkirtOneAxis) {
  const auto skirt = test::tube({0, 1.05, 0}, {0, .40, 0}, .16, .30);
  const auto places = relative_places(body(), skirt.positions, skirt.triangles);
  ASSERT_EQ(places.size(), static_cast<std::size_t>(skirt.positions.cols()));
  for (std::size_t v = 0; v < places.size(); ++v) {
    EXPECT_EQ(name_of(places[v].limb), "trunk");
    EXPECT_NEAR(places[v].along, 1.7 - skirt.positions(1, static_cast<Eigen::Index>(v)), 1e-9);
  }
}

TEST(RelativePlaces, GiveASlitSkirtOneAxisToo) {
  auto skirt = test::tube({0, 1.05, 0}, {0, .40, 0}, .16, .30);
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < skirt.triangles.cols(); ++t) {
    bool in_slit = true;
    for (int c = 0; c < 3; ++c) {
      const Vec at = skirt.positions.col(skirt.triangles(c, t));
      in_slit = in_slit && at[1] < .8 && at[0] > 0 && std::abs(at[2]) < .5 * at[0];
    }
    if (!in_slit) skirt.triangles.col(kept++) = skirt.triangles.col(t);
  }
  ASSERT_LT(kept, skirt.triangles.cols());
  skirt.triangles.conservativeResize(3, kept);
  Eigen::VectorXi used = Eigen::VectorXi::Zero(skirt.positions.cols());
  for (Eigen::Index t = 0; t < kept; ++t)
    for (int c = 0; c < 3; ++c) used[skirt.triangles(c, t)] = 1;
  const auto places = relative_places(body(), skirt.positions, skirt.triangles);
  for (std::size_t v = 0; v < places.size(); ++v)
    if (used[static_cast<Eigen::Index>(v)] == 1) {
      EXPECT_EQ(name_of(places[v].limb), "trunk");
    }
}

TEST(RelativePlaces, GiveEachTrouserLegItsOwnAxis) {
  // Wide legs: on their inner sides the other leg is as near.
  const auto legs =
      test::both(test::tube({.11, .76, 0}, {.11, .10, 0}, .10, .10), test::tube({-.11, .76, 0}, {-.11, .10, 0}, .10, .10));
  const auto places = relative_places(body(), legs.positions, legs.triangles);
  for (std::size_t v = 0; v < places.size(); ++v) EXPECT_EQ(name_of(places[v].limb), v < places.size() / 2 ? "leg.L" : "leg.R");
}

TEST(RelativePlaces, GiveASleeveTheArmAndACapeTheTrunk) {
  const Vec shoulder(.16, 1.35, 0), wrist(.50, 1.01, 0);
  const auto sleeve = test::tube(shoulder + .3 * (wrist - shoulder), wrist, .06, .06);
  for (const RelativePlace& place : relative_places(body(), sleeve.positions, sleeve.triangles))
    EXPECT_EQ(name_of(place.limb), "arm.L");
  auto cape = test::tube({0, 1.27, 0}, {0, .9, 0}, .45, .75, 80);
  cape.positions.row(2) *= .4;
  for (const RelativePlace& place : relative_places(body(), cape.positions, cape.triangles))
    EXPECT_EQ(name_of(place.limb), "trunk");
}

// One mesh: both joined by triangles where they are near each other, as at an underarm seam.
test::Closed joined(const test::Closed& bodice, const test::Closed& sleeve) {
  auto garment = test::both(bodice, sleeve);
  const auto count = static_cast<int>(bodice.positions.cols());
  for (int b = 0; b < count; ++b)
    for (int s = count; s + 1 < static_cast<int>(garment.positions.cols()); s += 7)
      if ((garment.positions.col(b) - garment.positions.col(s)).norm() < .03) {
        garment.triangles.conservativeResize(3, garment.triangles.cols() + 1);
        garment.triangles.rightCols(1) << b, s, s + 1;
      }
  return garment;
}

TEST(RelativePlaces, KeepASleeveWholeWhereItJoinsTheBodice) {
  const Vec shoulder(.16, 1.35, 0), wrist(.50, 1.01, 0);
  const auto bodice = test::tube({0, 1.27, 0}, {0, .9, 0}, .16, .17);
  const auto sleeve = test::tube(shoulder + .15 * (wrist - shoulder), wrist, .06, .06);
  const auto garment = joined(bodice, sleeve);
  const auto count = static_cast<int>(bodice.positions.cols());
  ASSERT_GT(garment.triangles.cols(), bodice.triangles.cols() + sleeve.triangles.cols());
  const auto places = relative_places(body(), garment.positions, garment.triangles);
  // But for a few vertices where the two touch.
  int elsewhere = 0;
  for (int v = 0; v < static_cast<int>(places.size()); ++v)
    elsewhere += name_of(places[static_cast<std::size_t>(v)].limb) != (v < count ? "trunk" : "arm.L");
  EXPECT_LE(elsewhere, static_cast<int>(places.size()) / 50);
}

TEST(RelativePlaces, KeepAShortWideSleeveWhoseHemIsNotSquareToTheArm) {
  // Its lowest corner is cut by levels that the rest of it does not reach round the arm, as the bodice is.
  const Vec shoulder(.16, 1.35, 0), wrist(.50, 1.01, 0), way = (wrist - shoulder).normalized();
  const auto bodice = test::tube({0, 1.27, 0}, {0, .9, 0}, .16, .17);
  auto sleeve = test::tube(shoulder + .15 * (wrist - shoulder), shoulder + .5 * (wrist - shoulder), .06, .10);
  for (Eigen::Index v = 0; v < sleeve.positions.cols(); ++v) {
    const double along = std::clamp((sleeve.positions.col(v) - shoulder).dot(way) / .24 - .3, 0.0, 1.0);
    sleeve.positions.col(v) -= along * .6 * sleeve.positions(2, v) * way;
  }
  const auto garment = joined(bodice, sleeve);
  const auto count = static_cast<int>(bodice.positions.cols());
  const auto places = relative_places(body(), garment.positions, garment.triangles);
  for (std::size_t v = static_cast<std::size_t>(count); v < places.size(); ++v)
    EXPECT_EQ(name_of(places[v].limb), "arm.L") << garment.positions.col(static_cast<Eigen::Index>(v)).transpose();
}

TEST(RelativePlaces, NeedNoTriangles) {
  Eigen::Matrix3Xd points(3, 2);
  points << 0, .1, 1.1, .4, .2, .1;
  const auto places = relative_places(body(), points, Eigen::Matrix3Xi(3, 0));
  EXPECT_EQ(name_of(places[0].limb), "trunk");
  EXPECT_EQ(name_of(places[1].limb), "leg.L");
  EXPECT_THROW(relative_places(body(), points, Eigen::Matrix3Xi(Eigen::Vector3i(0, 1, 2))), std::invalid_argument);
}

}  // namespace
}  // namespace toile
