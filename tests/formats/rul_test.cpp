#include "formats/rul/rul.h"

#include <gtest/gtest.h>

#include "formats/dxf_text.h"

namespace toile {
namespace {

const std::string heading =
    "ASTM/D13Proposal 1 Version: D 6673-04\r\nAUTHOR: us\r\nUNITS: METRIC\r\nGRADE RULE TABLE: skirt\r\nNUMBER OF SIZES: 3\r\n"
    "SIZE LIST: 36 38 40\r\nSAMPLE SIZE: 38\r\n";

GradeTable table(const std::string& text) {
  const Loaded<GradeTable> loaded = read_rul_bytes(text, "skirt.rul");
  EXPECT_TRUE(loaded.value) << all_words(loaded.report);
  return loaded.value.value_or(GradeTable{});
}
std::string error(const std::string& text) {
  const Loaded<GradeTable> loaded = read_rul_bytes(text, "skirt.rul");
  EXPECT_FALSE(loaded.value) << text;
  for (const Finding& finding : loaded.report.findings)
    if (finding.severity == Severity::error) {
      EXPECT_FALSE(finding.remedy.empty());
      return finding.code;
    }
  return "none";
}
const std::vector<Eigen::Vector2d> seven{{-10.5, 2}, {0, 0}, {10.25, -3}};

TEST(Rul, ReadsWhateverTheBreaksBetweenPairs) {
  for (const char* rule :
       {"RULE: DELTA 7\n-10.5,2\n0,0\n10.25,-3\nEND\n", "RULE: DELTA 7\n  -10.5, 2.0   0.000, -0.000   10.25, -3.\nEND",
        "RULE: DELTA 7\n -10.5,\t2  0,0\n\n10.25,-3\nEND\n", "RULE: DELTA 7 = (-10.5,2)(0,0)(+10.25,-3)\nEND\n",
        "rule: delta 7\n-10.5 2 0 0\n10.25 -3\nend\n"}) {
    const GradeTable read = table(heading + rule);
    EXPECT_EQ(read.name, "skirt");
    EXPECT_EQ(read.units, "METRIC");
    EXPECT_EQ(read.sizes, (std::vector<std::string>{"36", "38", "40"}));
    EXPECT_EQ(read.sample_size, "38");
    ASSERT_EQ(read.rules.size(), 1u) << rule;
    EXPECT_EQ(read.rules.at(7), seven) << rule;
  }
}

TEST(Rul, TakesHeadingsInAnyOrderAndABlankFirstLine) {
  const GradeTable read = table(
      "\r\nANSI/AAMA VERSION: 1.0.0\r\nSAMPLE SIZE:M\r\nSIZE LIST:S M L\r\nCREATION DATE: 1-1-2001\r\nPRODUCT: x\r\n"
      "RULE: DELTA 1\r\n0 0 0 0 0 0\r\nRULE: DELTA 2\r\n1 0 0 0 2 0\r\nEND\r\n");
  EXPECT_EQ(read.sizes.size(), 3u);
  EXPECT_EQ(read.rules.size(), 2u);
  EXPECT_EQ(read.rules.at(2).at(2), Eigen::Vector2d(2, 0));
}

TEST(Rul, RefusesWhatIsNone) {
  EXPECT_EQ(error(""), "rul.not-rul");
  EXPECT_EQ(error("0\nSECTION\n"), "rul.not-rul");
  EXPECT_EQ(error("RULE: DELTA 1\n0,0\n"), "rul.not-rul");
  EXPECT_EQ(error(heading + "RULE: DELTA 7\n1,2 0,0\nEND\n"), "rul.rule");
  EXPECT_EQ(error(heading + "RULE: DELTA 7\n1,2 0,0 1,2 3\nEND\n"), "rul.rule");
  EXPECT_EQ(error(heading + "RULE: DELTA 7\n1,2 0,0 1,nan\nEND\n"), "rul.rule");
  EXPECT_EQ(error(heading + "RULE: DELTA 7\n1,2 0,0 1,1e300\nEND\n"), "rul.rule");
  EXPECT_EQ(error(heading + "RULE: DELTA x\n1,2 0,0 1,2\nEND\n"), "rul.rule");
  EXPECT_EQ(error(heading + "RULE: FACTOR 7\n1,2 0,0 1,2\nEND\n"), "rul.rule");
  EXPECT_EQ(error("SIZE LIST: 36 38\nSAMPLE SIZE: 40\nEND\n"), "rul.sizes");
  EXPECT_EQ(error("NUMBER OF SIZES: 3\nSIZE LIST: 36 38\nSAMPLE SIZE: 38\nEND\n"), "rul.sizes");
  EXPECT_EQ(error("SIZE LIST: 36 36\nSAMPLE SIZE: 36\nEND\n"), "rul.sizes");
}

TEST(Rul, SaysWhatIsOddAndReadsOn) {
  const Loaded<GradeTable> twice =
      read_rul_bytes(heading + "RULE: DELTA 7\n1 0 0 0 1 0\nRULE: DELTA 7\n2 0 0 0 2 0\n", "x.rul");
  ASSERT_TRUE(twice.value);
  EXPECT_EQ(twice.value->rules.at(7).front(), Eigen::Vector2d(1, 0));
  EXPECT_TRUE(find(twice.report, "rul.duplicate-rule"));
  EXPECT_TRUE(find(twice.report, "rul.no-end"));
  const Loaded<GradeTable> moving = read_rul_bytes(heading + "RULE: DELTA 7\n1 0 2 0 4 0\nEND\n", "x.rul");
  ASSERT_TRUE(moving.value);
  EXPECT_EQ(moving.value->rules.at(7), (std::vector<Eigen::Vector2d>{{-1, 0}, {0, 0}, {2, 0}}));
  EXPECT_TRUE(find(moving.report, "rul.sample-moves"));
}

TEST(Rul, NeverCrashesOnItsOwnTruncations) {
  const std::string whole = heading + "RULE: DELTA 7\n-10.5,2\n0,0\n10.25,-3\nRULE: DELTA 8\n0 0 0 0 0 0\nEND\n";
  for (std::size_t n = 0; n < whole.size(); ++n) {
    const Loaded<GradeTable> loaded = read_rul_bytes(whole.substr(0, n), "cut.rul");
    EXPECT_EQ(loaded.value.has_value(), loaded.report.ok());
  }
}

}  // namespace
}  // namespace toile
