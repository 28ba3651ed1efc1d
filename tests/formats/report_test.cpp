#include "formats/html/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "formats/folder.h"
#include "formats/formats.h"
#include "formats/html/base64.h"
#include "formats/html/page.h"
#include "formats/xml_tree.h"

namespace toile {
namespace {

const std::string page_file = TOILE_SOURCE_DIR "/templates/reports/report.html";

RunReport full() {
  RunReport report;
  report.title = "Skirt <8> & \"more\"";
  report.verdict = "re-drape within 5.9 mm (0.35 %)";
  report.height = 1.68;
  report.inputs = {{"pattern", "skirt.dxf"}, {"fabric", "jersey"}};
  report.drape = {{"residual", "8e-5"}};
  report.distances = {{"plain flattening", .010, .0336, .9}, {"adjusted", .0008, .0042, .9971}};
  AdjustStep step;
  step.mean = .01;
  report.steps = {step, step};
  report.best = 1;
  report.stop = "agreed";
  report.seams = {{"side", .5, .5, .4, .4004, .0004}, {"waist", .7, .7, .7, .702, .002}, {"yoke", .3, .3, .3, .305, .005}};
  report.edges = {{"gore", "hem", .22, .21, true, 2}, {"gore", "side", .6, .6, false, 9}};
  report.findings = {{"drape.penetrates", Severity::warning, "source drape", "0.6 mm deep", "look at it", Fault::bad_input}};
  report.pictures = {{"source", "PNGBYTES"}};
  report.girths = {{"waist", 1.05, .72, true, .75, .76, .03}, {"bust", 1.22, .88, false, 0, 0, 0}};
  report.maps = {{"ease in mm", "MAPBYTES"}};
  report.files = {"skirt.dxf", "skirt.svg"};
  report.recipe = "[pattern]\nfile = \"a<b\"";
  return report;
}

std::string page() { return html::read_page(page_file); }

bool has(const std::string& html, const std::string& words) { return html.find(words) != std::string::npos; }

TEST(Base64, AsInTheStandard) {
  const char* plain[] = {"", "f", "fo", "foo", "foob", "fooba", "foobar"};  // RFC 4648, section 10
  const char* coded[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (int i = 0; i < 7; ++i) EXPECT_EQ(base64(plain[i]), coded[i]);
  EXPECT_EQ(base64(std::string_view("\xff\x00\xfe", 3)), "/wD+");
}

TEST(RunReport, TellsTheFigures) {
  const std::string html = report_html(full(), page());
  EXPECT_TRUE(has(html, "Skirt &lt;8&gt; &amp; &quot;more&quot;"));
  EXPECT_TRUE(has(html, "verdict good"));
  EXPECT_TRUE(has(html, ">33.60<") && has(html, ">2.00<"));  // 33.6 mm of 1.68 m
  EXPECT_TRUE(has(html, ">4.20<") && has(html, ">0.25<") && has(html, ">0.9971<"));
  EXPECT_TRUE(has(html, "<td class=\"good\">matches</td>"));
  EXPECT_TRUE(has(html, "<td class=\"warning\">check</td>"));
  EXPECT_TRUE(has(html, "<td class=\"error\">does not match</td>"));
  EXPECT_TRUE(has(html, ">-10.00<") && has(html, "straight"));
  EXPECT_TRUE(has(html, "drape.penetrates") && has(html, "look at it"));
  EXPECT_TRUE(has(html, "data:image/png;base64,UE5HQllURVM="));
  EXPECT_TRUE(has(html, ">72.0<") && has(html, ">75.0<") && has(html, ">76.0<") && has(html, ">3.0<"));  // cm
  EXPECT_TRUE(
      has(html,
          ">bust</td><td class=\"n\">122.0</td><td class=\"n\">88.0</td><td class=\"n\" colspan=\"3\">not covered all round<"));
  EXPECT_TRUE(has(html, "ease in mm") && has(html, "data:image/png;base64,TUFQQllURVM="));
  EXPECT_TRUE(has(html, "<h2>First drape</h2>"));
  EXPECT_TRUE(has(html, "<tr class=\"best\"><td>1</td>"));
  EXPECT_TRUE(has(html, "a&lt;b"));
  EXPECT_FALSE(has(html, "{{"));
}

TEST(RunReport, NeedsNothingFromOutside) {
  const std::string html = report_html(full(), page());
  for (const char* outside : {"http:", "https:", "<script", "<link", "@import", "url("})
    EXPECT_FALSE(has(html, outside)) << outside;
}

TEST(RunReport, IsWellNested) {
  std::string html = report_html(full(), page());
  for (const std::string empty :
       {"<meta charset=\"utf-8\">", "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"})
    html.erase(html.find(empty), empty.size());
  html.erase(0, html.find("<html"));
  for (std::size_t at = html.find("<img"); at != std::string::npos; at = html.find("<img", at + 1))
    html.insert(html.find('>', at), "/");
  EXPECT_EQ(test::parse_xml(html).name, "html");
}

TEST(RunReport, LeavesOutWhatIsNotThere) {
  RunReport bare;
  bare.title = "bare";
  bare.height = 1.7;
  const std::string html = report_html(bare, page());
  EXPECT_FALSE(has(html, "<h2>"));
  EXPECT_FALSE(has(html, "<table>"));
}

TEST(RunReport, TheSameTwice) { EXPECT_EQ(report_html(full(), page()), report_html(full(), page())); }

TEST(RunReport, RefusesWhatIsNoFigure) {
  RunReport report = full();
  report.distances[0].mean = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(report_html(report, page()), std::invalid_argument);
  report = full();
  report.height = 0;
  EXPECT_THROW(report_html(report, page()), std::invalid_argument);
}

TEST(RunReport, NamesABrokenTemplate) {
  const test::Folder folder;
  write_whole_file(folder / "mine.html", "<html>{{#steps}}</html>");
  try {
    write_report(folder / "report.html", full(), folder / "mine.html");
    FAIL() << "written";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "report.bad-template");
    EXPECT_EQ(bad.finding().place, (folder / "mine.html").string());
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "report.html"));
  write_report(folder / "report.html", full(), page_file);
  EXPECT_EQ(test::contents(folder / "report.html"), report_html(full(), page()));
}

}  // namespace
}  // namespace toile
