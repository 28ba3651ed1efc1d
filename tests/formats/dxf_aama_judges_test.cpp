// Independent readers of what we write: dxflib, and ezdxf where it is installed.

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <map>

#include "formats/aama_pieces.h"
#include "formats/formats.h"

namespace toile {
namespace {

// A file of its own for each test; removed with it.
class DxfJudges : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::temp_directory_path() /
            (std::string("toile-judge-") + test->name() + "-" + std::to_string(getpid()) + ".dxf");
    sheet_ = sheet_of({gore(), band(), disc()});
    write_dxf_aama(file_, sheet_);
  }
  void TearDown() override { std::filesystem::remove(file_); }

  std::filesystem::path file_;
  CutSheet sheet_;
};

using Counts = std::map<std::pair<std::string, std::string>, int>;  // (type, layer) -> how many

struct DxflibCounter : DL_CreationAdapter {
  void addLine(const DL_LineData&) override { add("LINE"); }
  void addPoint(const DL_PointData&) override { add("POINT"); }
  void addText(const DL_TextData&) override { add("TEXT"); }
  void addInsert(const DL_InsertData&) override { add("INSERT"); }
  void addPolyline(const DL_PolylineData& data) override {
    add("POLYLINE");
    closed += data.flags & 1;
  }
  void addVertex(const DL_VertexData&) override { ++vertices; }
  void addBlock(const DL_BlockData& data) override { blocks.push_back(data.name); }
  void add(const char* type) { ++counts[{type, attributes.getLayer()}]; }

  Counts counts;
  int closed = 0, vertices = 0;
  std::vector<std::string> blocks;
};

Counts expected(const CutSheet& sheet, int& vertices) {
  Counts counts;
  vertices = 0;
  for (const PlacedPiece& placed : sheet.placed) {
    const CutPiece& cut = placed.cut;
    int turns = 0, curves = 0;
    for (const Edge& edge : cut.piece.outline) {
      ++turns;
      curves += static_cast<int>(edge.points.size()) - 2;
    }
    vertices += turns + curves + static_cast<int>(cut.cut_line.size());
    for (const OutlinePoint& point : cut.cut_line) ++(point.turn ? turns : curves);
    ++counts[{"POLYLINE", "1"}];
    ++counts[{"POLYLINE", "14"}];
    counts[{"POINT", "2"}] += turns;
    if (curves > 0) counts[{"POINT", "3"}] += curves;
    const std::map<NotchKind, const char*> layers{{NotchKind::slit, "4"},    {NotchKind::v, "4"},      {NotchKind::t, "80"},
                                                  {NotchKind::castle, "81"}, {NotchKind::check, "82"}, {NotchKind::u, "83"}};
    for (const CutNotch& notch : cut.notches) ++counts[{"POINT", layers.at(notch.notch.kind)}];
    for (std::size_t i = 0; i < cut.piece.drill_holes.size(); ++i) ++counts[{"POINT", "13"}];
    ++counts[{"LINE", "7"}];
    for (const InternalLine& line : cut.piece.internal_lines) {
      ++counts[{line.points.size() == 2 ? "LINE" : "POLYLINE", line.cut_out ? "11" : "8"}];
      if (line.points.size() > 2)
        vertices += static_cast<int>(line.points.size()) - (line.points.front() == line.points.back());
    }
    counts[{"TEXT", "1"}] += 3 + static_cast<int>(cut.piece.annotations.size()) + !cut.piece.material.empty();
    ++counts[{"INSERT", "1"}];
  }
  counts[{"TEXT", "1"}] += 5 + static_cast<int>(sheet.notes.size());
  return counts;
}

TEST_F(DxfJudges, DxflibCountsWhatWasWritten) {
  DxflibCounter counter;
  DL_Dxf reader;
  ASSERT_TRUE(reader.in(file_.string(), &counter));
  int vertices = 0;
  EXPECT_EQ(counter.counts, expected(sheet_, vertices));
  EXPECT_EQ(counter.vertices, vertices);
  EXPECT_EQ(counter.closed, 7);
  EXPECT_EQ(counter.blocks, (std::vector<std::string>{"GORE_38", "WAIST_BAND_38", "DISC_38"}));
}

// What `command` prints, and whether it succeeded.
std::pair<std::string, bool> output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return {text, false};
  std::array<char, 4096> buffer{};
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  return {text, pclose(pipe) == 0};
}

TEST_F(DxfJudges, EzdxfAuditsItWithoutErrors) {
  std::string python;
  for (const char* candidate : {"/usr/bin/python3", "python3"})
    if (python.empty() && output_of(std::string(candidate) + " -c 'import ezdxf'").second) python = candidate;
  if (python.empty()) GTEST_SKIP() << "python3-ezdxf is not installed";
  // 202, "Deleted SEQEND", is ezdxf's own about any R12 polyline.
  const std::string script =
      "import ezdxf, sys\n"
      "doc = ezdxf.readfile(sys.argv[1])\n"
      "auditor = doc.audit()\n"
      "bad = [e for e in auditor.errors + auditor.fixes if int(e.code) != 202]\n"
      "print([e.message for e in bad])\n"
      "blocks = [b for b in doc.blocks if not b.name.startswith(('*', '$'))]\n"
      "print(doc.dxfversion, len(blocks), sum(len(b.query('POINT[layer==\"2\"]')) for b in blocks))\n"
      "for i in doc.modelspace().query('INSERT'): list(i.virtual_entities())\n"
      "b = doc.blocks.get('WAIST_BAND_38')\n"
      "ring = [p for p in b.query('POLYLINE') if p.dxf.layer == '14'][0]\n"
      "print(ring.is_closed, [(round(v.dxf.location.x, 4), round(v.dxf.location.y, 4)) for v in ring.vertices])\n"
      "sys.exit(1 if bad else 0)\n";
  const auto script_file = std::filesystem::path(file_).replace_extension(".py");
  write_whole_file(script_file, script);
  const auto [text, succeeded] = output_of(python + " '" + script_file.string() + "' '" + file_.string() + "'");
  std::filesystem::remove(script_file);
  EXPECT_TRUE(succeeded) << text;
  EXPECT_NE(text.find("AC1009 3 18"), std::string::npos) << text;
  EXPECT_NE(text.find("True [(0.0, 0.0), (700.0, 0.0), (700.0, 40.0), (0.0, 40.0)]"), std::string::npos) << text;
}

}  // namespace
}  // namespace toile
