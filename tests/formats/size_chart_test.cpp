#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "formats/formats.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

const fs::path charts = fs::path(TOILE_SOURCE_DIR) / "templates" / "mannequins";

class SizeChart : public ::testing::Test {
 protected:
  fs::path written(const std::string& text) {
    file_ = fs::temp_directory_path() /
            ("toile_size_chart_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
    std::ofstream(file_, std::ios::binary) << text;
    return file_;
  }
  void TearDown() override {
    std::error_code ignored;
    if (!file_.empty()) fs::remove(file_, ignored);
  }

 private:
  fs::path file_;
};

Finding only_error(const Loaded<SizeChartRow>& loaded) {
  EXPECT_FALSE(loaded.value);
  EXPECT_EQ(loaded.report.findings.size(), 1u);
  return loaded.report.findings.empty() ? Finding{} : loaded.report.findings.front();
}

TEST_F(SizeChart, RowOfSize38IsInMetres) {
  const auto row = read_size_chart_row(charts / "women.csv", "38");
  ASSERT_TRUE(row.value) << in_words(row.report.findings.front());
  EXPECT_EQ(row.value->chart, "women");
  EXPECT_EQ(row.value->size, "38");
  EXPECT_TRUE(row.value->female);
  EXPECT_DOUBLE_EQ(row.value->height, 1.68);
  EXPECT_DOUBLE_EQ(row.value->bust, .88);
  EXPECT_DOUBLE_EQ(row.value->waist, .70);
  EXPECT_DOUBLE_EQ(row.value->hip, .94);
  EXPECT_DOUBLE_EQ(row.value->others.at("upper_arm"), .28);
}

TEST_F(SizeChart, HasEveryWomensAndMensSizeInAscendingOrder) {
  const auto climb = [](const char* chart, int first, int last, bool female) {
    double waist = 0;
    for (int size = first; size <= last; size += 2) {
      const auto row = read_size_chart_row(charts / chart, std::to_string(size));
      ASSERT_TRUE(row.value) << chart << " " << size;
      EXPECT_EQ(row.value->female, female);
      EXPECT_GT(row.value->waist, waist);
      waist = row.value->waist;
    }
  };
  climb("women.csv", 32, 52, true);
  climb("men.csv", 44, 56, false);
}

TEST_F(SizeChart, UnknownSizeListsTheSizesThereAre) {
  const Finding error = only_error(read_size_chart_row(charts / "men.csv", "38"));
  EXPECT_EQ(error.code, "chart.unknown-size");
  EXPECT_EQ(error.fault, Fault::missing);
  EXPECT_NE(error.remedy.find("44, 46, 48, 50, 52, 54, 56"), std::string::npos) << error.remedy;
}

TEST_F(SizeChart, MissingFileIsSaid) {
  EXPECT_EQ(only_error(read_size_chart_row(charts / "no_such_chart.csv", "38")).code, "file.missing");
}

TEST_F(SizeChart, BadNumberNamesLineAndColumn) {
  const fs::path file = written("# ours\nsize,sex,height,bust,waist,hip\n36,F,168,84,66,90\n38,F,168,88,7O,94\n");
  const Finding error = only_error(read_size_chart_row(file, "38"));
  EXPECT_EQ(error.code, "chart.bad-number");
  EXPECT_NE(error.place.find(":4"), std::string::npos) << error.place;
  EXPECT_NE(error.text.find("waist"), std::string::npos);
  EXPECT_NE(error.text.find("7O"), std::string::npos);
  EXPECT_TRUE(read_size_chart_row(file, "36").value) << "other rows do not suffer";
}

TEST_F(SizeChart, NoLengthIsRefused) {
  for (const char* cell : {"", "nan", "inf", "-88", "0", "88cm", "8 8"}) {
    const fs::path file = written(std::string("size,sex,height,bust,waist,hip\nx,F,168,") + cell + ",70,94\n");
    EXPECT_EQ(only_error(read_size_chart_row(file, "x")).code, "chart.bad-number") << cell;
  }
}

TEST_F(SizeChart, ColumnsMayBeInAnyOrderAndOthersEmpty) {
  const auto row = read_size_chart_row(written("waist,neck,size,hip,sex,bust,thigh,height\n70,,M,94,M,88,56.5,168\n"), "M");
  ASSERT_TRUE(row.value);
  EXPECT_FALSE(row.value->female);
  EXPECT_DOUBLE_EQ(row.value->waist, .70);
  EXPECT_EQ(row.value->others, (std::map<std::string, double>{{"thigh", .565}}));
}

TEST_F(SizeChart, SpreadsheetsWithSemicolonsDecimalCommasQuotesAndByteOrderMarkAreRead) {
  const auto row =
      read_size_chart_row(written("\xEF\xBB\xBFsize;sex;height;bust;waist;hip\r\n\"38\";F;168;88,5;70;94\r\n"), "38");
  ASSERT_TRUE(row.value);
  EXPECT_DOUBLE_EQ(row.value->bust, .885);
}

TEST_F(SizeChart, MissingColumnAndEmptyFileAreSaid) {
  EXPECT_EQ(only_error(read_size_chart_row(written("size,sex,height,bust,waist\n38,F,168,88,70\n"), "38")).code,
            "chart.missing-column");
  EXPECT_EQ(only_error(read_size_chart_row(written("\n# nothing\n"), "38")).code, "chart.empty");
  EXPECT_EQ(only_error(read_size_chart_row(written("size,sex,height,bust,waist,hip\n38,W,168,88,70,94\n"), "38")).code,
            "chart.bad-sex");
}

}  // namespace
}  // namespace toile
