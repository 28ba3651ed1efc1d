#include "body/body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "body/figure.h"
#include "body/landmarks.h"
#include "body/tubes.h"

namespace toile {
namespace {

Mannequin of(const test::Closed& shape) {
  Mannequin form;
  form.name = "test";
  form.positions = shape.positions;
  form.triangles = shape.triangles;
  return form;
}

// A plain standing form 1.6 m tall, narrowest a little above the middle of its trunk.
Mannequin standing() {
  test::Closed shape = test::cylinder({0, 0, 0}, {0, 1.6, 0}, 1, 48, 160);
  for (Eigen::Index v = 0; v < shape.positions.cols(); ++v) {
    const double y = shape.positions(1, v),
                 radius = .08 - .02 * std::exp(-std::pow((y - 1.0) / .08, 2)) + .02 * std::exp(-std::pow((y - 1.14) / .06, 2));
    shape.positions(0, v) *= radius;
    shape.positions(2, v) *= radius;
  }
  return of(shape);
}

const Finding* find(const Report& report, const std::string& code) {
  for (const Finding& finding : report.findings)
    if (finding.code == code) return &finding;
  return nullptr;
}

std::string thrown_code(const Mannequin& form) {
  try {
    make_body(form);
  } catch (const BadInput& bad) {
    return bad.finding().code;
  }
  return "none";
}

TEST(CheckBody, HasNothingAgainstAClosedUprightForm) {
  const Report report = check_body(standing(), "form.obj");
  EXPECT_TRUE(report.ok());
  EXPECT_NE(find(report, "body.no-skeleton"), nullptr);
  EXPECT_NE(find(report, "body.no-landmarks"), nullptr);
  EXPECT_EQ(report.findings.size(), 2u);
}

TEST(CheckBody, SaysWhereTheHoleIs) {
  const Mannequin whole = standing();
  Mannequin form = whole;
  // Triangles round the point (0, .8, radius) on one side are taken out.
  const Eigen::Vector3d at(whole.positions.col(48 * 80 + 7));
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < whole.triangles.cols(); ++t)
    if ((whole.triangles.col(t).array() != 48 * 80 + 7).all()) form.triangles.col(kept++) = whole.triangles.col(t);
  form.triangles.conservativeResize(3, kept);
  const Report report = check_body(form, "form.obj");
  const Finding* hole = find(report, "body.not-closed");
  ASSERT_NE(hole, nullptr);
  EXPECT_EQ(hole->place, "form.obj");
  EXPECT_FALSE(hole->remedy.empty());
  double x = 0, y = 0, z = 0;
  ASSERT_EQ(std::sscanf(hole->text.c_str() + hole->text.find('('), "(%lf, %lf, %lf)", &x, &y, &z), 3) << hole->text;
  EXPECT_LT((Eigen::Vector3d(x, y, z) - at).norm(), 3e-3) << hole->text;
  EXPECT_NE(hole->text.find("6 edges"), std::string::npos) << hole->text;
  EXPECT_EQ(thrown_code(form), "body.not-closed");
}

TEST(CheckBody, TellsTwoHolesApart) {
  const auto shape = test::without_triangle(test::without_triangle(test::sphere({0, .5, 0}, .5, 3), 400), 0);
  const Report report = check_body(of(shape), "ball.obj");
  EXPECT_EQ(std::count_if(report.findings.begin(), report.findings.end(),
                          [](const Finding& f) { return f.code == "body.not-closed"; }),
            2);
}

TEST(CheckBody, NoticesABodyInsideOut) {
  Mannequin form = standing();
  form.triangles.row(0).swap(form.triangles.row(1));
  const Report report = check_body(form, "form.obj");
  const Finding* found = find(report, "body.not-oriented");
  ASSERT_NE(found, nullptr);
  EXPECT_NE(found->text.find("inside out"), std::string::npos);
  EXPECT_NE(found->remedy.find("flip"), std::string::npos);
  EXPECT_EQ(thrown_code(form), "body.not-oriented");
}

TEST(CheckBody, NoticesOneTriangleTurnedOver) {
  Mannequin form = standing();
  std::swap(form.triangles(0, 100), form.triangles(1, 100));
  EXPECT_NE(find(check_body(form, "form.obj"), "body.not-oriented"), nullptr);
}

TEST(CheckBody, NoticesAPartInsideOut) {
  const auto shape = test::both(test::box({0, .5, 0}, {.2, .5, .2}), test::turned_over(test::box({0, 1.2, 0}, {.1, .1, .1})));
  const Report report = check_body(of(shape), "form.obj");
  const Finding* found = find(report, "body.not-oriented");
  ASSERT_NE(found, nullptr);
  EXPECT_NE(found->text.find("1.200"), std::string::npos) << found->text;
}

TEST(CheckBody, SaysWhichUnitABodySeemsToBeIn) {
  const auto unit_named = [](double scale) {
    Mannequin form = standing();
    form.positions *= scale;
    const Report report = check_body(form, "form.obj");
    const Finding* found = find(report, "body.not-in-metres");
    return found ? found->text : "none";
  };
  EXPECT_NE(unit_named(100).find("centimetres"), std::string::npos);
  EXPECT_NE(unit_named(1000).find("millimetres"), std::string::npos);
  EXPECT_NE(unit_named(1 / .0254).find("inches"), std::string::npos);
  EXPECT_EQ(unit_named(1e-3).find("seems"), std::string::npos);
  EXPECT_EQ(unit_named(.3 / 1.6), "none");  // a replica mannequin
  EXPECT_EQ(unit_named(1), "none");
}

TEST(CheckBody, NoticesZUp) {
  Mannequin form = standing();
  form.positions.row(1).swap(form.positions.row(2));
  form.triangles.row(0).swap(form.triangles.row(1));
  const Report report = check_body(form, "form.obj");
  const Finding* found = find(report, "body.not-upright");
  ASSERT_NE(found, nullptr);
  EXPECT_NE(found->remedy.find("Z up"), std::string::npos);
}

TEST(CheckBody, NoticesWhatIsNotFinite) {
  Mannequin form = standing();
  form.positions(2, 41) = std::nan("");
  const Report report = check_body(form, "form.obj");
  ASSERT_NE(find(report, "body.not-finite"), nullptr);
  EXPECT_NE(find(report, "body.not-finite")->text.find("42"), std::string::npos);
  EXPECT_EQ(thrown_code(form), "body.not-finite");
}

TEST(CheckBody, NoticesIndicesAndEmptyBodies) {
  Mannequin form = standing();
  form.triangles(1, 3) = static_cast<int>(form.positions.cols());
  EXPECT_NE(find(check_body(form, "form.obj"), "body.no-such-vertex"), nullptr);
  EXPECT_NE(find(check_body(Mannequin{}, "form.obj"), "body.empty"), nullptr);
}

TEST(CheckBody, WarnsOfSelfIntersectionOnly) {
  const Mannequin form = test::figure();  // its limbs run into its trunk
  const Report report = check_body(form, "form.obj");
  EXPECT_TRUE(report.ok());
  ASSERT_NE(find(report, "body.self-intersects"), nullptr);
  EXPECT_EQ(find(report, "body.self-intersects")->severity, Severity::warning);
  EXPECT_EQ(find(check_body(form, "form.obj", SelfIntersections::not_looked_for), "body.self-intersects"), nullptr);
}

TEST(CheckBody, NoticesASkeletonOfAnotherBody) {
  Mannequin form = test::figure();
  form.bones[3].to *= 100;
  EXPECT_NE(find(check_body(form, "form.obj"), "body.skeleton-elsewhere"), nullptr);
  form = test::figure();
  for (Bone& bone : form.bones) bone.from[0] *= -1, bone.to[0] *= -1;
  EXPECT_NE(find(check_body(form, "form.obj"), "body.faces-away"), nullptr);
}

TEST(MakeBody, MeasuresLandmarksThatNobodyGave) {
  const Body body = make_body(standing());
  EXPECT_NEAR(body.form.height, 1.6, 1e-12);
  EXPECT_NEAR(body.form.landmarks.at("waist"), 1.0, 5e-3);
  EXPECT_NEAR(body.form.landmarks.at("bust"), 1.14, 5e-3);
  for (const char* name : {"hip", "high_hip", "underbust", "crotch", "nape", "knee", "ankle"})
    EXPECT_EQ(body.form.landmarks.count(name), 1u) << name;
  EXPECT_NEAR(body.distance.distance({.11, .4, 0}), .03, 1e-4);
  EXPECT_NEAR(body.skin.nearest({.11, .4, 0}).distance, .03, 1e-4);
  EXPECT_EQ(body.form.name, "test");
}

TEST(MakeBody, FindsTheCrotchWhereLegsPart) {
  Mannequin form = test::figure();
  form.landmarks.clear();
  EXPECT_NEAR(measured_landmarks(form).at("crotch"), .78, 3e-3);
}

TEST(MakeBody, ResolvesASmallMannequinAsWellAsALargeOne) {
  Mannequin form = standing();
  form.positions *= .2;
  const Body small = make_body(form);
  EXPECT_LT(small.distance.band(), 10e-3);
  for (const double away : {-2e-3, .5e-3, 2e-3})
    EXPECT_NEAR(small.distance.distance({.2 * .08 + away, .2 * .4, 0}), away, .03e-3);
}

TEST(LevelHeight, IsALandmarkOrAPlaceOnABone) {
  const Mannequin form = test::figure();
  EXPECT_EQ(level_height(form, "hip"), .85);
  EXPECT_NEAR(level_height(form, "thigh.L:0.5"), .635, 1e-12);
  EXPECT_NEAR(level_height(form, "shin.R:1"), .05, 1e-12);
}

TEST(LevelHeight, ListsWhatThereIsWhenThereIsNoSuchLevel) {
  const Mannequin form = test::figure();
  for (const char* name : {"wast", "thigh.L:1.5", "thigh.L:", "thigh.L:0.4x", "tail:0.4", "thigh.L:nan"}) try {
      level_height(form, name);
      ADD_FAILURE() << name;
    } catch (const BadInput& bad) {
      EXPECT_EQ(bad.finding().code, "body.no-such-level");
      EXPECT_NE(bad.finding().remedy.find("armpit, crotch, hip, waist"), std::string::npos) << bad.finding().remedy;
    }
}

}  // namespace
}  // namespace toile
