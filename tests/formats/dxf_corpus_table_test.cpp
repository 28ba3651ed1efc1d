// What each real DXF holds, and that nothing of it is lost without a word.

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_text.h"
#include "formats/formats.h"

namespace toile {
namespace {

struct Expected {
  const char* file;
  const char* dialect;
  const char* unit;
  const char* decided_by;
  std::size_t pieces, sizes;
  int largest_mm;
  std::size_t notches;
};
const Expected table[] = {
    {"accumark/GMH1006F18_AAMA.DXF", "AAMA", "mm", "text", 6, 15, 759, 15},
    {"accumark/GMH1006F18_ASTM.DXF", "ASTM", "mm", "text", 6, 15, 759, 15},
    {"accumark/GMH2446F17_INCLALLOWANCE_AAMA.DXF", "AAMA", "mm", "text", 10, 15, 950, 22},
    {"accumark/ORILEGWB_AAMA.DXF", "AAMA", "mm", "text", 2, 14, 910, 9},
    {"accumark/ORILEGWB_ASTM.DXF", "ASTM", "mm", "text", 2, 14, 910, 9},
    {"accumark/drill-holes.DXF", "AAMA", "mm", "text", 8, 15, 769, 26},
    {"accumark/mirrored.DXF", "AAMA", "mm", "text", 17, 15, 786, 58},
    {"accumark/simple.DXF", "AAMA", "inch", "text", 4, 14, 808, 4},
    {"clo/clo-box.dxf", "AAMA", "inch", "text", 1, 1, 3002, 0},
    {"clo/clo-pattern.dxf", "AAMA", "mm", "text", 9, 1, 729, 18},
    {"clo/clo2-pattern.dxf", "AAMA", "cm", "plausibility", 9, 1, 729, 18},
    {"valentina/basicblock_AAMA_R12_1.dxf", "AAMA", "mm", "plausibility", 4, 0, 1119, 0},
    {"valentina/basicblock_ASTM_R12_1.dxf", "ASTM", "mm", "plausibility", 4, 0, 1119, 0},
    {"valentina/maleshirt_AAMA_2000_1.dxf", "AAMA", "mm", "$INSUNITS", 17, 0, 744, 0},
    {"valentina/maleshirt_AAMA_R10_1.dxf", "AAMA", "mm", "plausibility", 17, 0, 744, 0},
    {"valentina/maleshirt_AAMA_R12_1.dxf", "AAMA", "mm", "plausibility", 17, 0, 744, 0},
    {"valentina/maleshirt_ASTM_2000_1.dxf", "ASTM", "mm", "$INSUNITS", 17, 0, 744, 0},
    {"valentina/maleshirt_ASTM_R12_1.dxf", "ASTM", "mm", "plausibility", 17, 0, 744, 0},
    {"valentina/maleshirt_ASTM_R13_1.dxf", "ASTM", "mm", "$MEASUREMENT", 17, 0, 744, 0},
    {"valentina/maleshirt_flat_2000_1.dxf", "AutoCAD drawing", "mm", "$INSUNITS", 17, 0, 744, 0},
    {"valentina/maleshirt_flat_R12_1.dxf", "AutoCAD drawing", "mm", "plausibility", 17, 0, 744, 0},
};

// Another reader's view: blocks with lines on layer 1, the longer side of each, and points on the notch layer.
struct Witness : DL_CreationAdapter {
  void addBlock(const DL_BlockData& data) override { block = data.name; }
  void endBlock() override { block.clear(); }
  void addPolyline(const DL_PolylineData&) override { on_1 = attributes.getLayer() == "1"; }
  void addVertex(const DL_VertexData& v) override {
    if (on_1 && !block.empty()) boxes[block].extend(Eigen::Vector2d(v.x, v.y));
  }
  void addPoint(const DL_PointData&) override { notch_points += attributes.getLayer() == "4"; }
  std::string block;
  bool on_1 = false;
  std::map<std::string, Eigen::AlignedBox2d> boxes;
  std::size_t notch_points = 0;
};

class DxfCorpusTable : public testing::Test {
 protected:
  void SetUp() override {
    const char* corpus = std::getenv("TOILE_CORPUS");
    if (!corpus) GTEST_SKIP() << "TOILE_CORPUS is not set";
    patterns_ = std::filesystem::path(corpus) / "patterns";
    if (!std::filesystem::exists(patterns_)) GTEST_SKIP() << "no patterns in TOILE_CORPUS";
  }
  std::filesystem::path patterns_;
};

TEST_F(DxfCorpusTable, HoldsForEveryFile) {
  for (const Expected& expected : table) {
    const Loaded<PatternFile> loaded = read_dxf_pattern(patterns_ / expected.file, {});
    ASSERT_TRUE(loaded.value) << expected.file << "\n" << all_words(loaded.report);
    const PatternFile& file = *loaded.value;
    EXPECT_EQ(file.dialect, expected.dialect) << expected.file;
    EXPECT_EQ(file.units.name, expected.unit) << expected.file;
    EXPECT_EQ(file.units.decided_by, expected.decided_by) << expected.file;
    EXPECT_EQ(file.pattern.pieces.size(), expected.pieces) << expected.file;
    EXPECT_EQ(file.facts.size(), expected.pieces) << expected.file;
    EXPECT_EQ(file.sizes.size(), expected.sizes) << expected.file;
    EXPECT_EQ(file.graded.size(), expected.sizes > 1 ? expected.sizes : 0) << expected.file;
    std::size_t notches = 0;
    double largest = 0;
    for (const Piece& piece : file.pattern.pieces) {
      notches += piece.notches.size();
      Eigen::AlignedBox2d box;
      for (const Edge& edge : piece.outline)
        for (const OutlinePoint& point : edge.points) box.extend(point.at);
      largest = std::max(largest, box.sizes().maxCoeff() * 1e3);
    }
    EXPECT_EQ(notches, expected.notches) << expected.file;
    EXPECT_NEAR(largest, expected.largest_mm, 1) << expected.file;
  }
}

TEST_F(DxfCorpusTable, AgreesWithDxflib) {
  for (const Expected& expected : table) {
    if (std::string(expected.dialect) == "AutoCAD drawing") continue;
    Witness witness;
    DL_Dxf reader;
    ASSERT_TRUE(reader.in((patterns_ / expected.file).string(), &witness)) << expected.file;
    const Loaded<PatternFile> loaded = read_dxf_pattern(patterns_ / expected.file, {});
    ASSERT_TRUE(loaded.value) << expected.file;
    const PatternFile& file = *loaded.value;
    EXPECT_EQ(witness.boxes.size(), expected.pieces * std::max<std::size_t>(1, expected.sizes)) << expected.file;
    // Pieces read as drawn have in every size the very size dxflib measures there.
    for (std::size_t i = 0; i < file.pattern.pieces.size(); ++i) {
      if (file.facts[i].unfolded || file.facts[i].has_sew_line) continue;
      for (std::size_t s = 0; s < std::max<std::size_t>(1, file.graded.size()); ++s) {
        const Piece& piece = file.graded.empty() ? file.pattern.pieces[i] : file.graded[s].pieces[i];
        const auto box = witness.boxes.find(file.sizes.empty() ? piece.name : piece.name + "_" + file.sizes[s]);
        if (box == witness.boxes.end()) continue;
        Eigen::AlignedBox2d own;
        for (const Edge& edge : piece.outline)
          for (const OutlinePoint& point : edge.points) own.extend(point.at);
        // Dense curves (layer 84) may bulge beyond the vertices of layer 1.
        const double off = (own.sizes() - file.units.in_metres * box->second.sizes()).cwiseAbs().maxCoeff();
        EXPECT_LT(off, std::string(expected.dialect) == "ASTM" ? 3e-3 : 2e-5) << expected.file << " " << piece.name << " " << s;
      }
    }
  }
}

// A file with one of its entities turned into a comment; no line moves.
std::string without(const std::vector<std::string>& lines, std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += (i >= begin && i < end && (i - begin) % 2 == 0 ? std::string("999") : lines[i]) + "\n";
  return text;
}

TEST_F(DxfCorpusTable, NothingInABlockIsLostWithoutAWord) {
  for (const char* name : {"accumark/GMH1006F18_ASTM.DXF", "accumark/ORILEGWB_AAMA.DXF", "accumark/drill-holes.DXF",
                           "clo/clo-pattern.dxf", "valentina/basicblock_AAMA_R12_1.dxf"}) {
    const std::string bytes = *read_whole_file(patterns_ / name).value;
    std::vector<std::string> lines;
    std::istringstream in(bytes);
    for (std::string line; std::getline(in, line);) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      lines.push_back(line);
    }
    const auto words = [](const std::string& line) {
      const std::size_t first = line.find_first_not_of(' ');
      return first == std::string::npos ? std::string() : line.substr(first, line.find_last_not_of(' ') - first + 1);
    };
    const auto read = [&](const std::string& text) { return read_dxf_pattern_bytes(text, "x.dxf", {}); };
    const Loaded<PatternFile> whole = read(without(lines, 0, 0));
    ASSERT_TRUE(whole.value);
    // The first of every kind and layer in the blocks of the sample size.
    std::map<std::string, int> seen;
    bool blocks = false, sample = false;
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
      if (words(lines[i]) == "2" && words(lines[i + 1]) == "BLOCKS") blocks = true;
      if (words(lines[i]) != "0") continue;
      const std::string type = words(lines[i + 1]);
      if (type == "ENDSEC") blocks = false;
      if (!blocks) continue;
      std::size_t end = i + 2;
      const auto ends = [&](std::size_t at) {
        const std::string next = words(lines[at + 1]);
        return words(lines[at]) == "0" && !(type == "POLYLINE" && (next == "VERTEX" || next == "SEQEND"));
      };
      while (end + 1 < lines.size() && !ends(end)) end += 2;
      std::string layer, text;
      for (std::size_t k = i; k < end; k += 2) {
        if (words(lines[k]) == "8" && layer.empty()) layer = words(lines[k + 1]);
        if (words(lines[k]) == "1") text = words(lines[k + 1]);
        if (type == "BLOCK" && words(lines[k]) == "2") {
          const std::string& size = whole.value->sample_size;
          const std::string block = words(lines[k + 1]);
          sample = size.empty() || (block.size() > size.size() && block.substr(block.size() - size.size() - 1) == "_" + size);
        }
      }
      if (!sample || type == "BLOCK" || type == "ENDBLK" || type == "VERTEX" || type == "SEQEND") continue;
      if (layer.size() == 2 && layer[0] == '8') continue;  // 84 to 87 are copies of 1, 8, 11 and 14
      if (!text.empty() && text.back() == ':') continue;   // says nothing
      const std::string key = text.substr(0, text.find(':'));
      if (key == "Quantity" || key == "QUANTITY" || key == "SIZE") continue;  // 1, and what the other pieces say as well
      if (type == "POLYLINE" && layer == "1" && std::string(name).substr(0, 3) == "clo") continue;  // again on 84
      if (++seen[type + " " + layer] > 1) continue;
      const Loaded<PatternFile> less = read(without(lines, i, end));
      const bool same = less.value && less.value->pattern == whole.value->pattern && less.value->facts == whole.value->facts &&
                        less.report.findings == whole.report.findings;
      EXPECT_FALSE(same) << name << ":" << i + 1 << " " << type << " on layer " << layer << " " << text;
    }
    EXPECT_GE(seen.size(), 3u);
  }
}

}  // namespace
}  // namespace toile
