#include "formats/garmentcode/garmentcode.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cstdlib>
#include <numbers>

#include "formats/garmentcode/curves.h"

namespace toile {
namespace {

// Two panels 40 x 60 cm, the back given clockwise, sewn at both sides.
std::string two_panels(const std::string& units = "100") {
  return R"({"pattern": {"panels": {
      "front": {"vertices": [[0,0],[40,0],[40,60],[0,60]], "translation": [-20, 40, 25], "rotation": [0,0,0],
        "edges": [{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,3],"label":"waist"},{"endpoints":[3,0]}]},
      "back": {"vertices": [[0,0],[0,60],[40,60],[40,0]], "translation": [-20, 40, -20], "rotation": [0,0,0],
        "edges": [{"endpoints":[0,1],"label":"side"},{"endpoints":[1,2]},{"endpoints":[2,3],"label":"side"},
                  {"endpoints":[3,0]}]}},
    "stitches": [[{"panel":"front","edge":3},{"panel":"back","edge":0}],
                 [{"panel":"front","edge":1},{"panel":"back","edge":2}, "right_wrong"]],
    "panel_order": ["front","back"]},
    "properties": {"curvature_coords": "relative", "units_in_meter": )" +
         units + "}}";
}

Loaded<Pattern> read(const std::string& text) { return read_garmentcode(text, "skirt_specification.json"); }

Finding first_error(const std::string& text) {
  const auto loaded = read(text);
  EXPECT_FALSE(loaded.value);
  for (const Finding& f : loaded.report.findings)
    if (f.severity == Severity::error) return f;
  ADD_FAILURE() << "no error";
  return {};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Eigen::Vector3d hung(const Piece& piece, const Eigen::Vector2d& at) {
  return piece.placement[0]->rotation * Eigen::Vector3d(at.x(), at.y(), 0) + piece.placement[0]->translation;
}

TEST(GarmentCode, ReadsPanelsInTheFilesOrderInMetres) {
  const Pattern pattern = *read(two_panels()).value;
  EXPECT_EQ(pattern.name, "skirt");
  ASSERT_EQ(pattern.pieces.size(), 2u);
  EXPECT_EQ(pattern.pieces[0].name, "front");
  EXPECT_EQ(pattern.pieces[1].name, "back");
  EXPECT_NEAR(signed_area(pattern.pieces[0]), .24, 1e-12);
  EXPECT_TRUE(hung(pattern.pieces[0], {0, 0}).isApprox(Eigen::Vector3d(-.2, .4, .25), 1e-12));
  EXPECT_FALSE(pattern.pieces[0].grainline);
}

TEST(GarmentCode, TakesTheUnitOfTheFile) { EXPECT_NEAR(signed_area(read(two_panels("300")).value->pieces[0]), .24 / 9, 1e-12); }

TEST(GarmentCode, NamesEdgesByLabelOnlyWhereItIsTheirsAlone) {
  const Pattern pattern = *read(two_panels()).value;
  EXPECT_EQ(pattern.pieces[0].outline[2].id, "waist");
  EXPECT_EQ(pattern.pieces[0].outline[3].id, "e3");
  EXPECT_EQ(pattern.pieces[1].outline[0].id, "e0");
  EXPECT_EQ(pattern.pieces[1].outline[2].id, "e2");
}

TEST(GarmentCode, DrawsAClockwisePanelMirroredAndLeavesItWhereItHangs) {
  const Pattern pattern = *read(two_panels()).value;
  const Piece& back = pattern.pieces[1];
  EXPECT_GT(signed_area(back), 0);
  EXPECT_NEAR(back.placement[0]->rotation.determinant(), 1, 1e-12);
  // Front and back both show their outside away from the body.
  EXPECT_TRUE((pattern.pieces[0].placement[0]->rotation * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_TRUE((back.placement[0]->rotation * Eigen::Vector3d::UnitZ()).isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
  const Eigen::Vector3d file[] = {{-.2, .4, -.2}, {-.2, 1, -.2}, {.2, 1, -.2}, {.2, .4, -.2}};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(hung(back, back.outline[k].points.front().at).isApprox(file[k], 1e-12)) << k;
}

TEST(GarmentCode, HangsAPanelAsRzRyRx) {
  const Pattern pattern = *read(replaced(two_panels(), R"("rotation": [0,0,0])", R"("rotation": [90,90,0])")).value;
  // (x, y, 0): about x to (x, 0, y), then about y to (y, 0, -x).
  EXPECT_TRUE(hung(pattern.pieces[0], {.1, .2}).isApprox(Eigen::Vector3d(-.2 + .2, .4, .25 - .1), 1e-12));
}

TEST(GarmentCode, StitchesBeginningToEndUnlessRightToWrong) {
  const Pattern pattern = *read(two_panels()).value;
  ASSERT_EQ(pattern.seams.size(), 2u);
  EXPECT_EQ(pattern.seams[0].a, (EdgeSpan{"front", 1, "e3", 0, 1}));
  EXPECT_EQ(pattern.seams[0].b, (EdgeSpan{"back", 1, "e0", 1, 0}));
  EXPECT_FALSE(pattern.seams[0].right_to_wrong);
  EXPECT_EQ(pattern.seams[1].b, (EdgeSpan{"back", 1, "e2", 0, 1}));
  EXPECT_TRUE(pattern.seams[1].right_to_wrong);
}

TEST(GarmentCode, CirclesKeepTheirRadiusSideAndTolerance) {
  const Eigen::Vector2d from(0, 0), to(.3, 0);
  for (const bool large : {false, true})
    for (const bool right : {false, true}) {
      const double r = .2;
      std::vector<Eigen::Vector2d> points{from};
      for (const auto& p : arc_between(from, to, r, large, right, .05e-3)) points.push_back(p);
      points.push_back(to);
      const Eigen::Vector2d middle = points[points.size() / 2];
      EXPECT_EQ(middle.y() < 0, right);  // right of travelling along +x is -y
      const double rise = std::sqrt(r * r - .15 * .15);
      const Eigen::Vector2d centre(.15, (right != large ? 1 : -1) * rise);
      double total = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR((points[i] - centre).norm(), r, 1e-12);
        if (i == 0) continue;
        EXPECT_LT(r - ((points[i] + points[i - 1]) / 2 - centre).norm(), .05e-3 + 1e-9);
        total += (points[i] - points[i - 1]).norm();
      }
      const double short_way = 2 * std::asin(.75);
      EXPECT_NEAR(total, r * (large ? 2 * std::numbers::pi - short_way : short_way), 1e-3);
    }
}

TEST(GarmentCode, HalfCircleOfASlightlySmallRadiusStillCloses) {
  for (const auto& p : arc_between({0, 0}, {.2, 0}, .1 * (1 - 1e-9), false, true, .05e-3))
    EXPECT_NEAR((p - Eigen::Vector2d(.1, 0)).norm(), .1, 1e-12);
}

TEST(GarmentCode, CurvesAreSampledWithinTheTolerance) {
  const std::vector<Eigen::Vector2d> control{{0, 0}, {.1, .3}, {.35, -.2}, {.4, .1}};
  std::vector<Eigen::Vector2d> points{control.front()};
  for (const auto& p : bezier_between(control, .05e-3)) points.push_back(p);
  points.push_back(control.back());
  const double steps = static_cast<double>(points.size() - 1);
  double worst = 0;
  for (int i = 0; i <= 20000; ++i) {
    const double t = i / 20000.0, s = 1 - t;
    const Eigen::Vector2d on =
        s * s * s * control[0] + 3 * s * s * t * control[1] + 3 * s * t * t * control[2] + t * t * t * control[3];
    const auto k = std::min(static_cast<std::size_t>(t * steps), points.size() - 2);
    const Eigen::Vector2d chord = points[k + 1] - points[k], d = on - points[k];
    const double along = std::clamp(d.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    worst = std::max(worst, (d - along * chord).norm());
  }
  EXPECT_LT(worst, .05e-3);
  EXPECT_GT(worst, .005e-3);  // no more points than needed
}

TEST(GarmentCode, ReadsControlPointsRelativeToTheEdgeAndTheOldSpelling) {
  // Halfway along and a tenth of the length to the left: the curve's middle is half of that away.
  for (const std::string curve : {R"({"type":"quadratic","params":[[0.5,0.1]]})", "[0.5,0.1]"}) {
    const auto loaded =
        read(replaced(two_panels(), R"({"endpoints":[1,2]})", R"({"endpoints":[1,2],"curvature":)" + curve + "}"));
    ASSERT_TRUE(loaded.value);
    const Edge& edge = loaded.value->pieces[0].outline[1];
    double least = 1;
    for (const OutlinePoint& p : edge.points) least = std::min(least, p.at.x());
    EXPECT_NEAR(least, .4 - .03, 1e-4);
    EXPECT_TRUE(edge.points.front().turn && edge.points.back().turn);
    EXPECT_FALSE(edge.points[1].turn);
  }
}

TEST(GarmentCode, ReadsControlPointsInPanelCoordinates) {
  auto text = replaced(two_panels(), R"({"endpoints":[1,2]})",
                       R"({"endpoints":[1,2],"curvature":{"type":"quadratic","params":[[34,30]]}})");
  text = replaced(text, "relative", "absolute");
  const Edge edge = read(text).value->pieces[0].outline[1];
  double least = 1;
  for (const OutlinePoint& p : edge.points) least = std::min(least, p.at.x());
  EXPECT_NEAR(least, .37, 1e-4);
}

TEST(GarmentCode, BadInputIsNamedWithItsPlace) {
  const std::string good = two_panels();
  const Finding cut_off = first_error(good.substr(0, good.size() / 2));
  EXPECT_EQ(cut_off.code, "json.syntax");
  EXPECT_NE(cut_off.place.find("skirt_specification.json:5:"), std::string::npos) << cut_off.place;
  EXPECT_EQ(first_error("").code, "json.syntax");
  EXPECT_EQ(first_error("[1, 1e999]").code, "json.syntax");
  EXPECT_EQ(first_error("{}").code, "garmentcode.missing");
  EXPECT_EQ(first_error(two_panels("0")).code, "garmentcode.units");
  EXPECT_EQ(first_error(replaced(good, "units_in_meter", "units")).fault, Fault::ambiguous);
  EXPECT_EQ(first_error(replaced(good, "[1,2]", "[0,2]")).code, "garmentcode.open-outline");
  EXPECT_EQ(first_error(replaced(good, "[1,2]", "[1,9]")).code, "garmentcode.unknown-vertex");
  EXPECT_EQ(first_error(replaced(good, "[40,0]", "[0,0]")).code, "garmentcode.short-edge");
  EXPECT_EQ(first_error(replaced(good, "[40,0]", "[\"x\",0]")).code, "garmentcode.bad-value");
  EXPECT_EQ(first_error(replaced(good, "\"vertices\"", "\"corners\"")).code, "garmentcode.missing");
  EXPECT_EQ(
      first_error(replaced(good, R"("endpoints":[1,2])", R"("endpoints":[1,2],"curvature":{"type":"spiral","params":[]})"))
          .code,
      "garmentcode.bad-curve");
  EXPECT_EQ(first_error(
                replaced(good, R"("endpoints":[1,2])", R"("endpoints":[1,2],"curvature":{"type":"circle","params":[10,0,1]})"))
                .code,
            "garmentcode.bad-curve");
}

TEST(GarmentCode, NumbersBeyondAnyGarmentAreErrors) {
  const std::string good = two_panels();
  EXPECT_EQ(first_error(replaced(good, "[40,0]", "[1e308,0]")).code, "garmentcode.too-large");
  EXPECT_EQ(first_error(replaced(good, "[-20, 40, 25]", "[1e308, 40, 25]")).code, "garmentcode.too-large");
  EXPECT_EQ(first_error(two_panels("1e-300")).code, "garmentcode.too-large");
  const auto curved = [&](const std::string& type, const std::string& params) {
    return replaced(good, R"("endpoints":[1,2])",
                    R"("endpoints":[1,2],"curvature":{"type":")" + type + R"(","params":[)" + params + "]}");
  };
  EXPECT_EQ(first_error(curved("quadratic", "[0.5,1e200]")).code, "garmentcode.too-large");
  EXPECT_EQ(first_error(curved("circle", "1e300,0,1")).code, "garmentcode.bad-curve");
  EXPECT_EQ(first_error(curved("circle", "1e9,0,1")).code, "garmentcode.bad-curve");
  EXPECT_TRUE(read(curved("circle", "1e5,0,1")).value);
}

TEST(GarmentCode, StitchesThatNameNothingAreErrors) {
  const std::string good = two_panels();
  const Finding piece = first_error(replaced(good, R"({"panel":"back","edge":0})", R"({"panel":"sleeve","edge":0})"));
  EXPECT_EQ(piece.code, "seam.unknown-piece");
  EXPECT_EQ(piece.place, "skirt_specification.json, stitch 0");
  EXPECT_NE(piece.remedy.find("front, back"), std::string::npos);
  EXPECT_EQ(first_error(replaced(good, R"({"panel":"back","edge":0})", R"({"panel":"back","edge":4})")).code,
            "seam.unknown-edge");
  EXPECT_EQ(first_error(replaced(good, R"("edge":2}, "right_wrong")", R"("edge":2}, "wrong")")).code, "garmentcode.bad-stitch");
}

TEST(GarmentCode, AMissingFileIsAFinding) {
  const auto loaded = read_garmentcode(std::filesystem::path("/nonexistent/skirt.json"));
  EXPECT_FALSE(loaded.value);
  EXPECT_EQ(loaded.report.findings.at(0).fault, Fault::missing);
}

struct RealFile {
  const char* name;
  std::size_t pieces, seams;
};

TEST(GarmentCode, ReadsGarmentsThatNobodyHereDrew) {
  const char* corpus = std::getenv("TOILE_CORPUS");
  if (!corpus) GTEST_SKIP() << "TOILE_CORPUS is not set";
  for (const auto& [name, pieces, seams] : std::initializer_list<RealFile>{{"bodice_fitted_sleeveless", 4, 16},
                                                                           {"dress_fitted_pencil_sleeve", 10, 46},
                                                                           {"dress_shirt_loose_sleeve", 8, 16},
                                                                           {"pants_straight", 6, 28},
                                                                           {"shirt_long_sleeve", 12, 24},
                                                                           {"shorts", 6, 28},
                                                                           {"skirt_2panel", 4, 6},
                                                                           {"skirt_6panel", 8, 15},
                                                                           {"skirt_circle_half", 4, 6},
                                                                           {"skirt_pencil", 4, 20},
                                                                           {"tank_sleeveless", 4, 6},
                                                                           {"tshirt", 8, 16}}) {
    SCOPED_TRACE(name);
    const auto loaded =
        read_garmentcode(std::filesystem::path(corpus) / "patterns/garmentcode/mh_f38" / (std::string(name) + ".json"));
    ASSERT_TRUE(loaded.value) << (loaded.report.findings.empty() ? "" : in_words(loaded.report.findings[0]));
    const Pattern& pattern = *loaded.value;
    EXPECT_EQ(pattern.pieces.size(), pieces);
    EXPECT_EQ(pattern.seams.size(), seams);
    for (const Piece& piece : pattern.pieces) {
      EXPECT_GT(signed_area(piece), 1e-3) << piece.name;
      EXPECT_NEAR(piece.placement[0]->rotation.determinant(), 1, 1e-9);
      Eigen::Vector2d middle = Eigen::Vector2d::Zero();
      for (const Edge& edge : piece.outline) middle += edge.points.front().at / static_cast<double>(piece.outline.size());
      Eigen::Vector3d from_axis = hung(piece, middle);
      from_axis.y() = 0;
      EXPECT_GT(from_axis.dot(piece.placement[0]->rotation * Eigen::Vector3d::UnitZ()), 0) << piece.name << " faces the body";
      for (std::size_t k = 0; k < piece.outline.size(); ++k)
        EXPECT_EQ(piece.outline[k].points.back().at, piece.outline[(k + 1) % piece.outline.size()].points.front().at);
    }
    double gap = 0, crossed_gap = 0;
    for (const Seam& seam : pattern.seams) {
      const double ratio = span_length(pattern, seam.a) / span_length(pattern, seam.b);
      EXPECT_GT(ratio, 1 / 2.3) << seam.name;
      EXPECT_LT(ratio, 2.3) << seam.name;
      const auto end_of = [&](const EdgeSpan& span, double at) {
        const Piece& piece = *find_piece(pattern, span.piece);
        const Edge& edge = *find_edge(piece, span.edge);
        return hung(piece, (at == 0 ? edge.points.front() : edge.points.back()).at);
      };
      gap += (end_of(seam.a, seam.a.begin) - end_of(seam.b, seam.b.begin)).norm() +
             (end_of(seam.a, seam.a.end) - end_of(seam.b, seam.b.end)).norm();
      crossed_gap += (end_of(seam.a, seam.a.begin) - end_of(seam.b, seam.b.end)).norm() +
                     (end_of(seam.a, seam.a.end) - end_of(seam.b, seam.b.begin)).norm();
    }
    gap /= 2 * static_cast<double>(seams);
    crossed_gap /= 2 * static_cast<double>(seams);
    EXPECT_LT(gap, .40);
    EXPECT_LT(gap, .8 * crossed_gap);  // the ends that meet are the ends that hang nearer each other
  }
}

}  // namespace
}  // namespace toile
