#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "body/parametric.h"
#include "edit/grade/limb_map.h"
#include "edit/grade/transfer.h"
#include "edit/operation.h"
#include "style/synthetic_skirt.h"

namespace toile {
namespace {

using testing::synthetic_skirt;
using testing::SyntheticSkirt;

constexpr double degree = std::numbers::pi / 180;
constexpr int columns = 48, rows = 30;

struct Scene {
  SyntheticSkirt skirt = synthetic_skirt({.columns = columns, .rows = rows});
  Body body = make_body(skirt.form);
  Target grade(const std::shared_ptr<const Body>& to) const {
    const FindBody find = [&](const BodyName&, const std::string&) { return to; };
    return find_operation("grade").apply({skirt.pattern, skirt.garment, skirt.drape, body, find}, {{"size", "other"}});
  }
};

const Scene& scene() {
  static const Scene one;
  return one;
}

// Wider by `wide` about the upright axis, taller by `tall`; with other triangles when `other_topology`.
std::shared_ptr<const Body> scaled(double wide, double tall, bool other_topology = false) {
  static std::map<std::tuple<double, double, bool>, std::shared_ptr<const Body>> made;
  auto& body = made[{wide, tall, other_topology}];
  if (body) return body;
  Mannequin form = scene().skirt.form;
  const Eigen::Vector3d by(wide, tall, wide);
  form.positions = by.asDiagonal() * form.positions;
  for (Bone& bone : form.bones) {
    bone.from = by.asDiagonal() * bone.from;
    bone.to = by.asDiagonal() * bone.to;
  }
  for (auto& [name, height] : form.landmarks) height *= tall;
  form.height *= tall;
  if (other_topology) form.triangles = Eigen::Matrix3Xi(form.triangles.rowwise().reverse());
  return body = std::make_shared<const Body>(make_body(form));
}

double radius(const Eigen::Matrix3Xd& x, int v) { return std::hypot(x(0, v), x(2, v)); }
double greatest(const Eigen::Matrix3Xd& difference) { return difference.colwise().norm().maxCoeff(); }

TEST(Grade, ToTheSameBodyGivesTheSourceBack) {
  const Target target = scene().grade(scaled(1, 1));
  EXPECT_LT(greatest(target.positions - target.source), 1e-6);
  EXPECT_LT(target.normal_deviation_max, 1e-4);
}

TEST(Grade, ToTheSameBodyWithOtherTrianglesGivesTheSourceBack) {
  EXPECT_LT(greatest(scene().grade(scaled(1, 1, true)).positions - scene().skirt.drape), 1e-6);
}

TEST(Grade, ToAWiderBodyKeepsEaseAndNormals) {
  for (const bool other_topology : {false, true}) {
    const auto wider = scaled(1.1, 1, other_topology);
    const Target target = scene().grade(wider);
    EXPECT_EQ(target.body, wider);
    EXPECT_LT(target.normal_deviation_mean, 1.5 * degree);
    double worst = 0, lift = 0;
    for (int v = 0; v < 8 * columns; ++v) {
      worst = std::max(worst, std::abs(wider->distance.distance(target.positions.col(v)) -
                                       scene().body.distance.distance(target.source.col(v))));
      lift = std::max(lift, std::abs(target.positions(1, v) - target.source(1, v)));
    }
    EXPECT_LT(worst, 2e-3) << "ease of the tight part";
    EXPECT_LT(lift, 3e-3);
    for (int v = (rows - 1) * columns; v < rows * columns; ++v) {
      EXPECT_NEAR(target.positions(1, v), target.source(1, v), 5e-3) << "hem";
      const double wide = radius(target.positions, v) - radius(target.source, v);
      EXPECT_GT(wide, 0.005);
      EXPECT_LT(wide, 0.03);
    }
  }
}

TEST(Grade, ToATallerBodyKeepsItsShareOfTheLegs) {
  const Target target = scene().grade(scaled(1.1, 1.06));
  double hem = 0, waist = 0;
  for (int v = 0; v < columns; ++v) {
    waist += target.positions(1, v) / columns;
    hem += target.positions(1, (rows - 1) * columns + v) / columns;
  }
  EXPECT_NEAR(waist, 1.06 * 1.05, 2e-3);
  EXPECT_NEAR(hem, 1.06 * 0.40, 4e-3);
}

TEST(Grade, StaysOutOfTheNewBody) {
  const auto wider = scaled(1.1, 1.06);
  const Target target = scene().grade(wider);
  for (Eigen::Index v = 0; v < target.positions.cols(); ++v)
    EXPECT_GT(wider->distance.distance(target.positions.col(v)), 0) << "vertex " << v;
}

TEST(Grade, ThereAndBackIsTheSource) {
  const auto wider = scaled(1.1, 1);
  const Target there = scene().grade(wider);
  const FindBody find = [&](const BodyName&, const std::string&) { return std::make_shared<const Body>(scene().body); };
  const Target back = find_operation("grade").apply(
      {scene().skirt.pattern, scene().skirt.garment, there.positions, *wider, find}, {{"size", "first"}});
  EXPECT_LT((back.positions - scene().skirt.drape).colwise().norm().mean(), 3e-3);
}

TEST(Grade, RefusesABodyOfOtherBones) {
  Mannequin form = scene().skirt.form;
  for (Bone& bone : form.bones) bone.name += ".x";
  for (Bone& bone : form.bones) bone.parent += bone.parent.empty() ? "" : ".x";
  try {
    scene().grade(std::make_shared<const Body>(make_body(form)));
    FAIL();
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "edit.other-skeleton");
  }
}

TEST(Grade, RefusesWithoutABodyToGradeTo) {
  const auto code = [](const EditArguments& arguments, const FindBody& find) -> std::string {
    const Scene& s = scene();
    try {
      find_operation("grade").apply({s.skirt.pattern, s.skirt.garment, s.skirt.drape, s.body, find}, arguments);
    } catch (const BadInput& bad) {
      return bad.finding().code;
    }
    return "";
  };
  const FindBody find = [](const BodyName&, const std::string&) { return scaled(1, 1); };
  EXPECT_EQ(code({{"size", "42"}}, {}), "edit.no-bodies");
  EXPECT_EQ(code({}, find), "edit.missing-parameter");
  EXPECT_EQ(code({{"size", "42"}, {"body", "other.obj"}}, find), "edit.two-parameters");
  EXPECT_EQ(code({{"size", "42"}, {"skeleton", "other.json"}}, find), "edit.two-parameters");
}

TEST(LimbMap, KeepsSharesOfTheLimbs) {
  const Mannequin small = build_mannequin({"women", "38", true, 1.68, .88, .72, .97, {}}, {.edge_length = 18e-3});
  const Mannequin large = build_mannequin({"women", "46", true, 1.72, 1.04, .88, 1.11, {}}, {.edge_length = 18e-3});
  EXPECT_TRUE(same_topology(small, large));
  const LimbMap map(small, large);
  for (const char* level : {"waist", "hip", "bust", "knee"})
    EXPECT_NEAR(map.height(small.landmarks.at(level)), large.landmarks.at(level), 1e-9) << level;
  EXPECT_LT(map.largest_turn(), 5 * degree);
  const auto axes = limb_axes(small), there = limb_axes(large);
  for (std::size_t limb = 0; limb < axes.size(); ++limb) {
    if (axes[limb].by_level) continue;
    RelativePlace place;
    place.limb = static_cast<int>(limb);
    place.along = (axes[limb].points[1] - axes[limb].points[0]).norm();
    EXPECT_LT((map.at(place).on_axis - there[limb].points[1]).norm(), 1e-9) << axes[limb].name << ": joint to joint";
  }
}

}  // namespace
}  // namespace toile
