// What every format that is written owes: a real pattern, written and read again, is the same to its precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "cut/cut.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_aama/profiles.h"
#include "formats/formats.h"
#include "formats/garmentcode/garmentcode.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

struct Read {
  std::string name;
  Pattern pattern;
};

// Every pattern of the corpus that can be read, the largest files left out.
std::vector<Read> corpus() {
  std::vector<Read> all;
  const char* folder = std::getenv("TOILE_CORPUS");
  if (!folder) return all;
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(folder) / "patterns"))
    if (entry.is_regular_file() && entry.file_size() < 300'000) files.insert(entry.path());
  for (const fs::path& file : files) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension != ".dxf" && extension != ".json") continue;
    Loaded<Pattern> read = read_pattern(file);
    if (read.value) all.push_back({file.filename().string(), std::move(*read.value)});
  }
  return all;
}

// The outlines as lines: farthest departure of a point of one from the other.
double departure(const Piece& a, const Piece& b) {
  Points<2> line;
  for (const Edge& edge : b.outline)
    for (const OutlinePoint& point : edge.points) line.push_back(point.at);
  line.push_back(line.front());
  double far = 0;
  for (const Edge& edge : a.outline)
    for (const OutlinePoint& point : edge.points) far = std::max(far, nearest_on<2>(line, point.at).distance);
  return far;
}

TEST(FormatContract, RealPatternsComeBackFromDxf) {
  const std::vector<Read> files = corpus();
  if (files.empty()) GTEST_SKIP() << "TOILE_CORPUS is not set";
  for (const auto& [name, pattern] : files) {
    SCOPED_TRACE(name);
    CutSheet sheet;
    sheet.title = pattern.name;
    AllowanceRules net;
    net.allowance = net.hem = 0;
    try {
      for (const Piece& piece : pattern.pieces) {
        Piece bare = piece;
        for (Edge& edge : bare.outline) edge.seam_allowance = 0;
        PlacedPiece placed;
        placed.cut = add_allowance(bare, net);
        placed.cut.size = pattern.sample_size;
        sheet.placed.push_back(placed);
      }
    } catch (const BadInput& bad) {
      continue;  // an outline that cannot be cut
    }
    const Pattern named = as_named_in_dxf(pattern, sheet);
    const auto read = read_dxf_aama_bytes(dxf_aama_bytes(sheet), name);
    ASSERT_TRUE(read.value) << in_words(read.report.findings.front());
    EXPECT_EQ(read.value->pieces.size(), named.pieces.size());
    for (const Piece& piece : named.pieces) {
      const Piece* same = find_piece(*read.value, piece.name);
      ASSERT_TRUE(same) << piece.name;
      EXPECT_LE(departure(piece, *same), 2e-7) << piece.name;
      EXPECT_EQ(same->outline.size(), piece.outline.size()) << piece.name;
      EXPECT_EQ(same->notches.size(), piece.notches.size()) << piece.name;
      EXPECT_EQ(same->drill_holes.size(), piece.drill_holes.size()) << piece.name;
      EXPECT_EQ(same->internal_lines.size(), piece.internal_lines.size()) << piece.name;
      EXPECT_EQ(copies(*same), copies(piece)) << piece.name;
    }
  }
}

TEST(FormatContract, RealPatternsComeBackFromGarmentCode) {
  const std::vector<Read> files = corpus();
  if (files.empty()) GTEST_SKIP() << "TOILE_CORPUS is not set";
  for (const auto& [name, pattern] : files) {
    SCOPED_TRACE(name);
    const auto [text, losses] = garmentcode_text(pattern);
    const auto read = read_garmentcode_text(text, name);
    ASSERT_TRUE(read.value) << in_words(read.report.findings.front());
    std::size_t panel = 0;
    for (const Piece& piece : pattern.pieces)
      for (int copy = 1; copy <= copies(piece); ++copy, ++panel) {
        ASSERT_LT(panel, read.value->pattern.pieces.size());
        const Piece& same = read.value->pattern.pieces[panel];
        double round = 0;
        for (const Edge& edge : piece.outline) round += length(edge);
        EXPECT_NEAR(signed_area(same), signed_area(piece), .1e-3 * round) << piece.name;
        if (!is_mirrored(piece, copy)) {
          EXPECT_LE(departure(same, piece), .3e-3) << piece.name;
        }
      }
    EXPECT_EQ(read.value->pattern.pieces.size(), panel);
    EXPECT_GE(read.value->pattern.seams.size(), pattern.seams.size());
  }
}

}  // namespace
}  // namespace toile
