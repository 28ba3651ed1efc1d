// Nests and grade rules: every size of every piece, point by point.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_text.h"
#include "formats/folder.h"
#include "formats/formats.h"

namespace toile {
namespace {

const std::string name = text_on("1", "Piece Name: front");

Loaded<PatternFile> read(const std::string& bytes, const std::string& size = {}, const GradeTable* rules = nullptr) {
  PatternReadOptions options;
  options.size = size;
  return read_dxf_pattern_bytes(bytes, "skirt.dxf", options, [=](const std::string&, Report&) {
    return rules ? std::optional<GradeTable>(*rules) : std::nullopt;
  });
}
PatternFile file_of(const std::string& bytes, const GradeTable* rules = nullptr) {
  Loaded<PatternFile> loaded = read(bytes, {}, rules);
  EXPECT_TRUE(loaded.value) << all_words(loaded.report);
  return loaded.value.value_or(PatternFile{});
}
std::string sized(const std::string& size, const std::string& entities) {
  return block("F_" + size, name + text_on("1", "Size: " + size) + entities);
}
const std::vector<std::string> style{"Units: METRIC", "Sample Size: 38"};
Eigen::Vector2d corner(const Piece& piece, std::size_t edge) { return piece.outline.at(edge).points.front().at * 1e3; }

// The skirt front of size 38 + 2 k: a rectangle with one point on its left side.
Xy front(double k) { return {{0, 0}, {400 + 10 * k, 0}, {400 + 10 * k, 600 + 5 * k}, {0, 600 + 5 * k}, {0, 300}}; }
std::string front_on_1(double k) { return polyline_on("1", front(k), true); }

GradeTable table() {
  GradeTable rules;
  rules.sizes = {"36", "38", "40"};
  rules.sample_size = "38";
  rules.units = "METRIC";
  const auto rule = [](double x, double y) { return std::vector<Eigen::Vector2d>{{-x, -y}, {0, 0}, {x, y}}; };
  rules.rules = {{1, rule(0, 0)}, {2, rule(10, 0)}, {3, rule(10, 5)}, {4, rule(0, 5)}};
  return rules;
}
std::string marks(const Xy& at, const std::vector<int>& rules) {
  std::string out;
  for (std::size_t i = 0; i < at.size(); ++i)
    out += point_on("2", at[i]) + text_on("2", "# " + std::to_string(rules[i]), at[i]);
  return out;
}

TEST(DxfGraded, ANestAndGradeRulesGiveTheSamePieces) {
  const std::string mark = marks({{0, 0}, {400, 0}, {400, 600}, {0, 600}, {0, 300}}, {1, 2, 3, 4, 1});
  const PatternFile nest = file_of(
      pattern_file(sized("36", front_on_1(-1)) + sized("38", front_on_1(0) + mark) + sized("40", front_on_1(1)), style));
  const GradeTable rules = table();
  const PatternFile ruled = file_of(pattern_file(sized("38", front_on_1(0) + mark), style), &rules);
  EXPECT_EQ(nest.graded_by, "nest");
  EXPECT_EQ(ruled.graded_by, "rules");
  EXPECT_EQ(nest.facts.at(0).graded_points, 5);
  for (const PatternFile* file : {&nest, &ruled}) {
    EXPECT_EQ(file->sizes, (std::vector<std::string>{"36", "38", "40"}));
    EXPECT_EQ(file->sample_size, "38");
    ASSERT_EQ(file->graded.size(), 3u);
    EXPECT_EQ(file->graded[1].pieces, file->pattern.pieces);
    EXPECT_EQ(file->graded[2].sample_size, "40");
  }
  for (std::size_t s = 0; s < 3; ++s) {
    const Piece &a = nest.graded[s].pieces[0], &b = ruled.graded[s].pieces[0];
    ASSERT_EQ(a.outline.size(), b.outline.size());
    for (std::size_t e = 0; e < a.outline.size(); ++e) {
      ASSERT_EQ(a.outline[e].points.size(), b.outline[e].points.size());
      for (std::size_t i = 0; i < a.outline[e].points.size(); ++i)
        EXPECT_LT((a.outline[e].points[i].at - b.outline[e].points[i].at).norm(), 1e-9) << s << " " << e;
    }
    EXPECT_LT((corner(a, 2) - front(static_cast<double>(s) - 1)[2]).norm(), 1e-6);
  }
}

TEST(DxfGraded, PointsWithoutARuleAreInterpolatedAlongTheOutline) {
  const GradeTable rules = table();
  const PatternFile file = file_of(
      pattern_file(sized("38", front_on_1(0) + marks({{0, 0}, {400, 0}, {400, 600}, {0, 600}}, {1, 2, 3, 4})), style), &rules);
  // Half way down the left side, between a move of 5 mm and none.
  bool found = false;
  for (const Edge& edge : file.graded[2].pieces[0].outline)
    for (const OutlinePoint& point : edge.points) found = found || (point.at * 1e3 - Eigen::Vector2d(0, 302.5)).norm() < 1e-6;
  EXPECT_TRUE(found);
}

TEST(DxfGraded, TheAxisOfTheRulesIsTheGradeReferenceLine) {
  const GradeTable rules = table();
  const PatternFile file = file_of(pattern_file(sized("38", front_on_1(0) + line_on("5", {10, 10}, {10, 500}) +
                                                                marks({{0, 0}, {400, 0}, {400, 600}, {0, 600}}, {1, 1, 2, 1})),
                                                style),
                                   &rules);
  EXPECT_LT((corner(file.graded[2].pieces[0], 2) - Eigen::Vector2d(400, 610)).norm(), 1e-6);
}

TEST(DxfGraded, HalvesMoveOnBothSidesOfTheFoldOfTheirSize) {
  const auto half = [](double k) {  // fold on x = 0, which itself moves
    return polyline_on("1", {{-k, 0}, {200 + 10 * k, 0}, {200 + 10 * k, 600}, {-k, 600}}, true) +
           line_on("6", {-k, 0}, {-k, 600}) + polyline_on("8", {{50 + k, 100}, {100 + k, 100}}, false);
  };
  const PatternFile file = file_of(pattern_file(sized("38", half(0)) + sized("40", half(1)), style));
  const Piece& graded = file.graded.at(1).pieces.at(0);
  EXPECT_TRUE(file.facts.at(0).unfolded);
  double low = 1e9, high = -1e9;
  for (const Edge& edge : graded.outline)
    for (const OutlinePoint& p : edge.points) low = std::min(low, p.at.x() * 1e3), high = std::max(high, p.at.x() * 1e3);
  EXPECT_NEAR(high, 210, 1e-6);
  EXPECT_NEAR(low, -212, 1e-6);  // mirrored in x = -1
  ASSERT_EQ(graded.internal_lines.size(), 2u);
  EXPECT_LT((graded.internal_lines[0].points[0] * 1e3 - Eigen::Vector2d(51, 100)).norm(), 1e-6);
  EXPECT_LT((graded.internal_lines[1].points[0] * 1e3 - Eigen::Vector2d(-53, 100)).norm(), 1e-6);
}

TEST(DxfGraded, NotchesStayBetweenTheirPointsUnlessTheyHaveARule) {
  const GradeTable rules = table();
  const std::string corners = marks({{0, 0}, {400, 0}, {400, 600}, {0, 600}}, {1, 2, 3, 4});
  const auto notch_x = [&](const std::string& more) {  // on the hem, 100 mm from the left; the hem grows from 400 to 410 mm
    const PatternFile file =
        file_of(pattern_file(sized("38", front_on_1(0) + corners + point_on("4", {100, 0}) + more), style), &rules);
    const Piece& piece = file.graded.at(2).pieces.at(0);
    const Notch& notch = piece.notches.at(0);
    return notch.at * length(*find_edge(piece, notch.edge)) * 1e3;
  };
  EXPECT_NEAR(notch_x(""), 102.5, 1e-6);
  EXPECT_NEAR(notch_x(text_on("4", "# 2", {100, 0})), 110, 1e-6);
}

TEST(DxfGraded, SizesDrawnWithOtherVerticesAreMatchedFromCornerToCorner) {
  Xy other{{410, 0}, {410, 605}, {205, 605}, {0, 605}, {0, 0}};  // begins elsewhere, has another point
  const Loaded<PatternFile> loaded =
      read(pattern_file(sized("38", polyline_on("1", front(0), true)) + sized("40", polyline_on("1", other, true)), style));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_TRUE(find(loaded.report, "aama.nest-along"));
  const Piece& graded = loaded.value->graded.at(1).pieces.at(0);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d wanted(i == 1 || i == 2 ? 410 : 0, i > 1 ? 605 : 0);
    EXPECT_LT((corner(graded, i) - wanted).norm(), 1e-6) << i;
  }
}

TEST(DxfGraded, TheSizeAskedForIsThePattern) {
  const std::string nest =
      pattern_file(sized("36", front_on_1(-1)) + sized("38", front_on_1(0)) + sized("40", front_on_1(1)), style);
  const Loaded<PatternFile> forty = read(nest, "40");
  ASSERT_TRUE(forty.value);
  EXPECT_EQ(forty.value->pattern, forty.value->graded[2]);
  EXPECT_EQ(forty.value->sample_size, "38");
  const Loaded<PatternFile> none = read(nest, "52");
  EXPECT_FALSE(none.value);
  ASSERT_TRUE(find(none.report, "aama.size-unknown"));
  EXPECT_NE(find(none.report, "aama.size-unknown")->text.find("36, 38, 40"), std::string::npos);
}

TEST(DxfGraded, TheRuleTableIsFoundBesideTheFile) {
  const test::Folder folder;
  const std::string mark = marks({{0, 0}, {400, 0}, {400, 600}, {0, 600}}, {1, 2, 3, 4});
  std::ofstream(folder / "skirt.dxf") << pattern_file(sized("38", front_on_1(0) + mark), style);
  const Loaded<PatternFile> alone = read_pattern_file(folder / "skirt.dxf");
  ASSERT_TRUE(alone.value) << all_words(alone.report);
  EXPECT_TRUE(find(alone.report, "aama.no-rule-table"));
  EXPECT_EQ(alone.value->graded.size(), 0u);
  std::ofstream(folder / "SKIRT.RUL") << "UNITS: METRIC\nSIZE LIST: 38 40\nSAMPLE SIZE: 38\nRULE: DELTA 3\n0 0 10 5\nEND\n";
  const Loaded<PatternFile> both = read_pattern_file(folder / "skirt.dxf");
  ASSERT_TRUE(both.value) << all_words(both.report);
  EXPECT_EQ(both.value->graded_by, "rules");
  EXPECT_TRUE(find(both.report, "aama.rule-missing"));
  std::ofstream(folder / "SKIRT.RUL") << "nonsense\n";
  const Loaded<PatternFile> broken = read_pattern_file(folder / "skirt.dxf");
  ASSERT_TRUE(broken.value);
  EXPECT_EQ(find(broken.report, "rul.not-rul")->severity, Severity::warning);
}

}  // namespace
}  // namespace toile
