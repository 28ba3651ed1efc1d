#include "formats/svg/sheet_style.h"

#include <gtest/gtest.h>

#include "formats/folder.h"
#include "formats/formats.h"

namespace toile {
namespace {

TEST(SheetStyle, TemplatesAreReadAndPlotterIsTheDefault) {
  const std::string folder = TOILE_SOURCE_DIR "/templates/cut_sheets/";
  EXPECT_EQ(value_or_throw(read_sheet_style(folder + "plotter.toml")), SheetStyle{});
  const SheetStyle projector = value_or_throw(read_sheet_style(folder + "projector.toml"));
  EXPECT_DOUBLE_EQ(projector.cut.width, .002);
  EXPECT_TRUE(projector.sew.dash.empty());
}

TEST(SheetStyle, SaysWhereItIsWrong) {
  const test::Folder folder;
  const auto error = [&](const std::string& text) {
    write_whole_file(folder / "s.toml", text);
    const auto loaded = read_sheet_style(folder / "s.toml");
    EXPECT_FALSE(loaded.value);
    return loaded.report.findings.empty() ? ""
                                          : loaded.report.findings.front().code + "@" + loaded.report.findings.front().place;
  };
  const std::string place = (folder / "s.toml").string() + ":2";
  EXPECT_EQ(error("[cut]\nwidth = 0.5\n"), "sheet-style.bad-value@" + place);
  EXPECT_EQ(error("[cut]\nwidth = \"5 furlongs\"\n"), "sheet-style.bad-value@" + place);
  EXPECT_EQ(error("[cut]\ncolour = \"black\"\n"), "sheet-style.bad-value@" + place);
  EXPECT_EQ(error("[sew]\ndash = [\"1 mm\", 2]\n"), "sheet-style.bad-value@" + place);
  EXPECT_EQ(error("[sew]\nshown = \"no\"\n"), "sheet-style.bad-value@" + place);
  EXPECT_EQ(error("[sew]\ncolor = \"#000000\"\n"), "sheet-style.unknown-key@" + place);
  EXPECT_FALSE(read_sheet_style(folder / "none.toml").value);
}

}  // namespace
}  // namespace toile
