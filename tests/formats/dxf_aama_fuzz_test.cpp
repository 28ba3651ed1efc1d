// Broken files are refused or read, never crash. ASan and UBSan run these too.

#include <gtest/gtest.h>

#include <random>

#include "formats/aama_pieces.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_text.h"

namespace toile {
namespace {

std::string small_file() {
  CutSheet sheet = sheet_of({band(), disc()});
  return dxf_aama_bytes(sheet);
}

void expect_sound(const Loaded<Pattern>& loaded) {
  ASSERT_EQ(loaded.value.has_value(), loaded.report.ok());
  if (!loaded.value) return;
  ASSERT_FALSE(loaded.value->pieces.empty());
  for (const Piece& piece : loaded.value->pieces) {
    ASSERT_FALSE(piece.outline.empty());
    ASSERT_GT(signed_area(piece), 0);
    for (std::size_t i = 0; i < piece.outline.size(); ++i) {
      ASSERT_GE(piece.outline[i].points.size(), 2u);
      ASSERT_EQ(piece.outline[i].points.back().at, piece.outline[(i + 1) % piece.outline.size()].points.front().at);
    }
    for (const Notch& notch : piece.notches) ASSERT_TRUE(find_edge(piece, notch.edge) && notch.at >= 0 && notch.at <= 1);
  }
}

TEST(DxfAamaFuzz, EveryTruncationIsReported) {
  const std::string whole = small_file();
  const std::size_t complete = whole.rfind("  0\nEOF");
  for (std::size_t length = 0; length < whole.size(); length += length + 400 < whole.size() ? 7 : 1) {
    const Loaded<Pattern> loaded = read_dxf_aama_bytes(std::string_view(whole).substr(0, length), "cut.dxf");
    expect_sound(loaded);
    if (length < complete - 1) {
      EXPECT_FALSE(loaded.value) << length;
    }
  }
  EXPECT_TRUE(read_dxf_aama_bytes(whole, "whole.dxf").value);
}

TEST(DxfAamaFuzz, RandomDamageNeverCrashes) {
  const std::string whole = small_file();
  std::mt19937 random(20160711);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int refused = 0;
  for (int round = 0; round < 1500; ++round) {
    std::string bytes = whole;
    const std::size_t flips = 1 + below(6);
    for (std::size_t i = 0; i < flips; ++i)
      bytes[below(bytes.size())] = round % 2 ? static_cast<char>(random()) : "0123456789.-\n "[below(14)];
    if (round % 5 == 0) bytes.erase(below(bytes.size() - 200), below(200));
    const Loaded<Pattern> loaded = read_dxf_aama_bytes(bytes, "damaged.dxf");
    expect_sound(loaded);
    refused += !loaded.value;
  }
  EXPECT_GT(refused, 100);
  EXPECT_LT(refused, 1500);
}

TEST(DxfAamaFuzz, AnyBytesAreNoPattern) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    std::string bytes(1 + random() % 300, ' ');
    for (char& c : bytes) c = static_cast<char>(random());
    EXPECT_FALSE(read_dxf_aama_bytes(bytes, "noise.dxf").value);
  }
}

}  // namespace
}  // namespace toile
