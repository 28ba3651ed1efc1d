#include <gtest/gtest.h>

#include "cli/program.h"

namespace toile {
namespace {

const std::string sample = std::string(TOILE_SOURCE_DIR) + "/samples/gored_skirt/gored_skirt.dxf";

// One square of 30 units, in the words of a DXF.
std::string small_square(const std::string& style) {
  std::string vertices;
  for (const char* at : {"10\n0\n20\n0\n", "10\n30\n20\n0\n", "10\n30\n20\n30\n", "10\n0\n20\n30\n"})
    vertices += std::string("0\nVERTEX\n8\n1\n") + at;
  return "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n0\n2\nA\n70\n64\n10\n0\n20\n0\n0\nPOLYLINE\n8\n1\n66\n1\n70\n1\n" + vertices +
         "0\nSEQEND\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + style + "0\nENDSEC\n0\nEOF\n";
}

TEST(InspectVerb, PrintsATableAndSeams) {
  const test::Ended ended = test::run_program({"inspect", sample});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("DXF, AAMA"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("sew line"), std::string::npos);
}

TEST(InspectVerb, PrintsJsonAndAPicture) {
  const test::Workplace place;
  const std::string picture = (place / "pieces.png").string();
  const test::Ended ended = test::run_program({"inspect", sample, "--json", "--png", picture});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.out.rfind("{\n  \"schema\": 1,", 0), 0u) << ended.out.substr(0, 60);
  EXPECT_EQ(test::contents(picture).substr(1, 3), "PNG");
}

TEST(InspectVerb, AsksForTheUnitWithExitCode12UnlessItIsGiven) {
  const test::Workplace place;
  place.write("square.dxf", small_square(""));
  const std::string file = (place / "square.dxf").string();
  const test::Ended asked = test::run_program({"inspect", file, "--json"});
  EXPECT_EQ(asked.status, 12);
  EXPECT_NE(asked.out.find("\"aama.units-ambiguous\""), std::string::npos) << asked.out;
  const test::Ended told = test::run_program({"inspect", file, "--json", "--units", "cm"});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_NE(told.out.find("\"width_mm\": 300.0"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("\"decided_by\": \"override\""), std::string::npos);
  EXPECT_EQ(test::run_program({"inspect", file, "--units", "furlong"}).status, 65);
}

TEST(InspectVerb, ExplainsWhatItCannotRead) {
  const test::Workplace place;
  place.write("cut.dxf", small_square("").substr(0, 200));
  const test::Ended cut = test::run_program({"inspect", (place / "cut.dxf").string(), "--json"});
  EXPECT_EQ(cut.status, 65);
  EXPECT_NE(cut.out.find("\"dxf.truncated\""), std::string::npos) << cut.out;
  EXPECT_EQ(test::run_program({"inspect", (place / "none.dxf").string(), "--json"}).status, 66);
  EXPECT_EQ(test::run_program({"inspect"}).status, 64);
}

}  // namespace
}  // namespace toile
