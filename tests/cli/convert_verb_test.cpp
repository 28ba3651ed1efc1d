#include <gtest/gtest.h>

#include "cli/program.h"
#include "formats/formats.h"

namespace toile {
namespace {

using test::contents;
using test::run_program;
using test::Workplace;

const std::string skirt = std::string(TOILE_SOURCE_DIR) + "/samples/gored_skirt/gored_skirt.dxf";

TEST(Convert, WritesEveryFormatAndReadsItBack) {
  const Workplace work;
  for (const char* name : {"a.dxf", "a.json", "a.svg", "a.obj"}) {
    const auto ended = run_program({"convert", skirt, (work / name).string()});
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_NE(ended.out.find("2 pieces"), std::string::npos) << ended.out;
  }
  EXPECT_TRUE(std::filesystem::exists(work / "a.seams.toml"));
  const auto before = read_pattern(skirt), after = read_pattern(work / "a.dxf");
  ASSERT_TRUE(before.value && after.value);
  EXPECT_EQ(after.value->seams.size(), before.value->seams.size());
  for (const Piece& piece : before.value->pieces) {
    const Piece* same = find_piece(*after.value, piece.name);
    ASSERT_TRUE(same) << piece.name;
    EXPECT_EQ(copies(*same), copies(piece));
    EXPECT_NEAR(signed_area(*same), signed_area(piece), 1e-7);
    EXPECT_EQ(same->notches.size(), piece.notches.size());
  }
  std::filesystem::rename(work / "a.seams.toml", work / "gone");  // it belongs to the DXF
  const auto json = read_pattern(work / "a.json");
  ASSERT_TRUE(json.value);
  EXPECT_EQ(json.value->pieces.size(), 9u);  // eight gores and a band
}

TEST(Convert, SaysWhatAFormatCannotHold) {
  const Workplace work;
  const auto ended = run_program({"convert", skirt, (work / "a.json").string()});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.err.find("garmentcode.copies"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("garmentcode.no-placement"), std::string::npos) << ended.err;
  EXPECT_EQ(run_program({"convert", "--quiet", "--force", skirt, (work / "a.json").string()}).err, "");
}

TEST(Convert, WritesAPdfOnThePaperAskedFor) {
  const Workplace work;
  const auto pages = [&](const std::string& name, std::vector<std::string> options) {
    options.insert(options.begin(), {"convert", "--quiet", "--allowance", "1 cm", skirt, (work / name).string()});
    const auto ended = run_program(options);
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(contents(work / name).compare(0, 5, "%PDF-"), 0);
    return std::filesystem::file_size(work / name);
  };
  const auto roll = pages("roll.pdf", {}), a4 = pages("a4.pdf", {"--paper", "A4", "--overlap", "15 mm"});
  EXPECT_LT(roll, a4);
  EXPECT_LT(a4, 200'000u);
  pages("none.pdf", {"--paper", "none"});
  EXPECT_EQ(contents(work / "none.pdf"), contents(work / "roll.pdf"));
  pages("wide.pdf", {"--width", "60 in"});
  EXPECT_NE(contents(work / "wide.pdf"), contents(work / "roll.pdf"));
}

TEST(Convert, RefusesAPdfThatCannotBePrintedOrRead) {
  const Workplace work;
  const std::string out = (work / "a.pdf").string();
  const auto unknown = run_program({"convert", skirt, out, "--paper", "a9"});
  EXPECT_EQ(unknown.status, 64);
  EXPECT_NE(unknown.err.find("no paper 'a9': they are a4, letter"), std::string::npos) << unknown.err;
  EXPECT_EQ(run_program({"convert", skirt, out, "--paper", "a4", "--margin", "1 mm"}).status, 65);
  EXPECT_EQ(run_program({"convert", skirt, out, "--paper", "a4", "--overlap", "wide"}).status, 65);
  const auto narrow = run_program({"convert", skirt, out, "--width", "5 cm"});
  EXPECT_EQ(narrow.status, 65);
  EXPECT_NE(narrow.err.find("cut.page-too-narrow"), std::string::npos) << narrow.err;
  EXPECT_TRUE(work.everything().empty());
  work.write("a.pdf", "%PDF-1.7\n");
  const auto read = run_program({"convert", out, (work / "a.svg").string()});
  EXPECT_EQ(read.status, 65);
  EXPECT_NE(read.err.find("format.pdf"), std::string::npos) << read.err;
}

TEST(Convert, RefusesWhatItCannotDoAndLeavesNothingBehind) {
  const Workplace work;
  EXPECT_EQ(run_program({"convert", skirt, (work / "a.doc").string()}).status, 73);
  EXPECT_EQ(run_program({"convert", skirt, (work / "a.dxf").string(), "--profile", "word"}).status, 65);
  EXPECT_EQ(run_program({"convert", (work / "none.dxf").string(), (work / "a.svg").string()}).status, 66);
  EXPECT_EQ(run_program({"convert", skirt}).status, 64);
  EXPECT_TRUE(work.everything().empty());
  work.write("a.svg", "mine");
  EXPECT_EQ(run_program({"convert", skirt, (work / "a.svg").string()}).status, 73);
  EXPECT_EQ(contents(work / "a.svg"), "mine");
}

}  // namespace
}  // namespace toile
