#include "formats/html/grading.h"

#include <gtest/gtest.h>

#include "formats/folder.h"
#include "formats/formats.h"
#include "formats/html/base64.h"

namespace toile {
namespace {

const std::string page_file = TOILE_SOURCE_DIR "/templates/reports/grading.html";

GradingReport two_sizes() {
  GradingReport report;
  report.title = "Skirt & sizes";
  report.base = "36";
  report.sizes = {
      {"36", "36", "women 36", 1.68, .6e-3, 5e-3, .998, .1e-3, true, "", {{"waist", 1.05, .68, true, .70, .71, .02}}, "PNG36"},
      {"38", "38", "women 38", 1.68, .7e-3, 20e-3, .99, .2e-3, false, "far <off>", {}, "PNG38"}};
  report.pieces = {{"GORE", {.2, .21}, {.6, .605}}};
  report.points = {{"GORE", "hem", {0, 2.5e-3}, {0, -1e-3}}};
  return report;
}

TEST(Grading, ThePageShowsEverySizeAndWhatCornersMove) {
  const test::Folder here;
  write_grading(here / "grading.html", two_sizes(), page_file);
  const std::string page = value_or_throw(read_whole_file(here / "grading.html"));
  for (const std::string& words : {std::string("Skirt &amp; sizes"), std::string("36/report.html"), std::string("women 38"),
                                   std::string("far &lt;off&gt;"), std::string("200.0 x 600.0"), std::string("210.0 x 605.0"),
                                   std::string("+2.50 / -1.00"), std::string("70.0 = 68.0 + 2.0"),
                                   std::string("corners from size 36"), base64("PNG36"), base64("PNG38"), std::string("1.19")})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  EXPECT_EQ(page.find("{{"), std::string::npos);
}

TEST(Grading, ABrokenTemplateIsNamed) {
  const test::Folder here;
  write_whole_file(here / "page.html", "{{#sizes}}");
  try {
    write_grading(here / "grading.html", two_sizes(), here / "page.html");
    ADD_FAILURE() << "was accepted";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "report.bad-template");
    EXPECT_NE(bad.finding().place.find("page.html"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(here / "grading.html"));
}

}  // namespace
}  // namespace toile
