#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "formats/svg_drawn.h"
#include "formats/svg_read/element.h"

namespace toile {
namespace {

using test::has_finding;
using test::read_text;
using test::svg_mm;

std::string error_of(const std::string& text) {
  const Loaded<PatternFile> loaded = read_svg_bytes(text, "bad.svg");
  EXPECT_FALSE(loaded.value);
  for (const Finding& finding : loaded.report.findings)
    if (finding.severity == Severity::error) {
      EXPECT_EQ(finding.place.compare(0, 7, "bad.svg"), 0) << finding.place;
      EXPECT_FALSE(finding.remedy.empty());
      return finding.code;
    }
  return "none";
}

std::string gzipped(const std::string& text) {
  std::string packed(compressBound(text.size()) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

const std::string piece = "<path d='M100,100 h200 v400 h-200 z'/>";

TEST(SvgHostile, BadFilesHaveNamedErrors) {
  EXPECT_EQ(error_of(""), "svg.not-well-formed");
  EXPECT_EQ(error_of("<svg><g></svg>"), "svg.not-well-formed");
  EXPECT_EQ(error_of("<html/>"), "svg.no-svg");
  EXPECT_EQ(error_of(svg_mm("")), "svg.no-piece");
  EXPECT_EQ(error_of(svg_mm("<path d='M0 0 L1e308 1e308 L 1e309 0'/>")), "svg.bad-number");
  EXPECT_EQ(error_of(svg_mm("<path d='M0 0 H 1e12 V 1 z'/>")), "svg.bad-number");
  EXPECT_EQ(error_of(svg_mm("<g transform='scale(1e200)'><g transform='scale(1e200)'>" + piece + "</g></g>")),
            "svg.bad-number");
  EXPECT_EQ(error_of("\x1f\x8b garbage"), "svg.broken-gzip");
  EXPECT_EQ(error_of(gzipped(svg_mm(piece)).substr(0, 60)), "svg.broken-gzip");
}

TEST(SvgHostile, DepthUsesAndElementsAreBounded) {
  std::string deep;
  for (int i = 0; i < 2000; ++i) deep += "<g>";
  for (int i = 0; i < 2000; ++i) deep += "</g>";
  EXPECT_EQ(error_of(svg_mm(deep)), "svg.too-deep");
  EXPECT_EQ(error_of(svg_mm("<g id='a'><use href='#a'/></g>")), "svg.use-too-deep");
  std::string bomb = "<defs><g id='a0'><path d='M0 0h9v9z'/></g>";
  for (int i = 1; i < 12; ++i) {
    bomb += "<g id='a" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) bomb += "<use href='#a" + std::to_string(i - 1) + "'/>";
    bomb += "</g>";
  }
  EXPECT_EQ(error_of(svg_mm(bomb + "</defs><use href='#a11'/>")), "svg.too-many-elements");
}

TEST(SvgHostile, OutlinesOfTooManyPointsAreRefused) {
  std::string path = "<path d='M100,100";
  for (int i = 1; i < 12000; ++i) path += " " + std::to_string(100 + i * .01) + "," + std::to_string(100 + (i % 2) * .5);
  EXPECT_EQ(error_of(svg_mm(path + " V500 H100 z'/>")), "svg.too-many-points");
}

TEST(SvgHostile, EntitiesAreNotExpandedAndNothingIsFetched) {
  const std::string outside = "<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/passwd'><!ENTITY y 'front'>]>" +
                              svg_mm(piece + "<text x='150' y='200'>&x;&y;</text>");
  const Loaded<PatternFile> loaded = read_text(outside);
  ASSERT_TRUE(loaded.value);
  EXPECT_TRUE(has_finding(loaded.report, "svg.entity"));
  EXPECT_EQ(loaded.value->pattern.pieces[0].annotations.size(), 0u);
  std::string laughs = "<!DOCTYPE svg [<!ENTITY a0 'ha'>";
  for (int i = 1; i < 40; ++i)
    laughs += "<!ENTITY a" + std::to_string(i) + " '&a" + std::to_string(i - 1) + ";&a" + std::to_string(i - 1) + ";'>";
  const Loaded<PatternFile> bomb = read_text(laughs + "]>" + svg_mm(piece + "<text>&a39;</text>"));  // ends, whatever it says
  EXPECT_TRUE(bomb.value || !bomb.report.ok());
}

TEST(SvgHostile, CompressedFilesAreReadAndBounded) {
  const Loaded<PatternFile> loaded = read_svg_bytes(gzipped(svg_mm(piece)), "a.svgz");
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->pattern.pieces.size(), 1u);
  const Loaded<std::string> bomb = svg::unzipped(gzipped(std::string(3 << 20, ' ')), "a.svgz", 1 << 20);
  ASSERT_FALSE(bomb.value);
  EXPECT_EQ(bomb.report.findings[0].code, "svg.too-large");
}

TEST(SvgHostile, BrokenPartsAreSaidAndTheRestIsRead) {
  const Loaded<PatternFile> loaded =
      read_text(svg_mm(piece + "<path stroke='black' d='M150,150 L250,250 L oops'/><g transform='rotate(a)'><path "
                               "stroke='black' d='M150,300 h40'/></g>"));
  ASSERT_TRUE(loaded.value);
  EXPECT_TRUE(has_finding(loaded.report, "svg.bad-path"));
  EXPECT_TRUE(has_finding(loaded.report, "svg.bad-transform"));
  EXPECT_EQ(loaded.value->pattern.pieces[0].internal_lines.size(), 2u);
}

// Whatever is done to a file, reading it ends, and gives a value or an error.
TEST(SvgHostile, DamagedFilesNeverStopTheReader) {
  const std::string whole = svg_mm(
      "<style>.sa{stroke-dasharray:1,2} g>path{fill:none;stroke:black}</style><defs><g id='notch'><circle r='2'/></g></defs>"
      "<g id='front' transform='translate(10,10)'><path d='M100,100 C150,90 250,90 300,100 L320,700 80,700z'/><path class='sa' "
      "d='M90,90 Q200,80 310,90 T330,710 H70z'/>"
      "<path marker-start='url(#grainlineFrom)' d='M200,200 V600'/><path d='M100,100 a5,5 0 01 5 5' /><use href='#notch' "
      "x='110' y='300'/>"
      "<text x='150' y='200'>Front<tspan x='150' dy='10'>Cut 2 on fold, 1 cm seam allowance included</tspan></text></g><rect "
      "x='5' y='5' width='50' height='50' rx='3'/>");
  std::mt19937 random(7);
  const std::string alphabet = "<>'/=\"0123456789.-eMLCQAZz #&;:,gpathrectuse \n\x01\xc3";
  for (int round = 0; round < 500; ++round) {
    std::string text = whole;
    for (unsigned i = 0; i < 1 + random() % 6; ++i) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text[at] = alphabet[random() % alphabet.size()];
          break;
        case 1:
          text.erase(at, random() % 20);
          break;
        case 2:
          text.insert(at, text.substr(random() % text.size(), random() % 30));
          break;
        default:
          text.insert(at, std::string(1 + random() % 3, alphabet[random() % alphabet.size()]));
      }
    }
    const Loaded<PatternFile> loaded = read_text(text);
    ASSERT_EQ(loaded.value.has_value(), loaded.report.ok()) << text;
    if (!loaded.value) continue;
    ASSERT_FALSE(loaded.value->pattern.pieces.empty());
    for (const Piece& one : loaded.value->pattern.pieces)
      for (const Edge& edge : one.outline) {
        ASSERT_GE(edge.points.size(), 2u);
        for (const OutlinePoint& p : edge.points) ASSERT_TRUE(p.at.allFinite());
      }
  }
}

TEST(SvgHostile, WhatAClipHidesIsReadAndSaid) {
  const auto loaded = read_text(
      svg_mm("<clipPath id='c'><rect width='10' height='10'/></clipPath><style>.m{mask:url(#m)}</style>"
             "<g clip-path='url(#c)'><rect x='10' y='10' width='300' height='400' fill='none' stroke='black'/></g>"
             "<path class='m' d='M 500 10 h 300 v 400 h -300 z' fill='none' stroke='black' style='clip-path:none'/>"));
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->pattern.pieces.size(), 2u);
  const auto said = std::find_if(loaded.report.findings.begin(), loaded.report.findings.end(),
                                 [](const Finding& f) { return f.code == "svg.clip-path"; });
  ASSERT_NE(said, loaded.report.findings.end());
  EXPECT_NE(said->text.find("2 elements"), std::string::npos) << said->text;
}

}  // namespace
}  // namespace toile
