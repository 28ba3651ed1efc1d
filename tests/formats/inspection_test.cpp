#include "formats/inspection/inspection.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace toile {
namespace {

Piece square(const std::string& name, double side) {
  Piece piece;
  piece.name = name;
  piece.mirrored_quantity = 1;
  piece.material = "denim";
  const Eigen::Vector2d corners[] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  for (int i = 0; i < 4; ++i) {
    Edge edge;
    edge.id = "e" + std::to_string(i);
    edge.points = {{corners[i], true, {}}, {corners[(i + 1) % 4], true, {}}};
    if (i == 0) edge.points.insert(edge.points.begin() + 1, {{side / 2, 0}, false, {}});
    piece.outline.push_back(edge);
  }
  piece.notches.push_back({"e1", .5});
  piece.drill_holes.push_back({{side / 2, side / 2}, 0});
  piece.internal_lines.push_back({{{0, 0}, {side, side}}, false});
  piece.grainline = Grainline{{0, side}, {0, 0}};  // downwards
  return piece;
}

PatternFile nest() {
  PatternFile file;
  file.format = "DXF";
  file.dialect = "AAMA";
  file.author = "us";
  file.units = {"mm", 1e-3, "text"};
  file.sizes = {"38", "40"};
  file.sample_size = "38";
  file.graded_by = "nest";
  for (const double side : {.1, .11}) {
    Pattern pattern;
    pattern.sample_size = file.sizes[file.graded.size()];
    pattern.pieces = {square("pocket", side)};
    file.graded.push_back(pattern);
  }
  file.pattern = file.graded[0];
  file.facts = {{"pocket", true, "layer 14", true, 4}};
  file.pattern.seams.push_back({"side", {"pocket", 1, "e1"}, {"pocket", 2, "e3", 1, 0}, false});
  return file;
}

TEST(Inspection, ListsEveryPieceInEverySize) {
  const std::vector<PieceRow> rows = piece_rows(nest());
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].size, "38");
  EXPECT_NEAR(rows[1].width_mm, 110, 1e-9);
  EXPECT_NEAR(rows[1].area_mm2, 12100, 1e-6);
  EXPECT_EQ(rows[0].outline_points, 5);
  EXPECT_EQ(rows[0].turn_points, 4);
  EXPECT_EQ(rows[0].curve_points, 1);
  ASSERT_TRUE(rows[0].grainline_deg);
  EXPECT_NEAR(*rows[0].grainline_deg, 90, 1e-9);
  EXPECT_EQ(piece_rows(nest(), true).size(), 1u);
}

TEST(Inspection, SpeaksSchemaOne) {
  Loaded<PatternFile> loaded;
  loaded.value = nest();
  loaded.report.warn("aama.no-grain-line", "x.dxf:3", "no \"grain\"", "draw one");
  const auto json = nlohmann::json::parse(inspection_json(loaded, piece_rows(*loaded.value)));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["format"], "DXF");
  EXPECT_EQ(json["dialect"], "AAMA");
  EXPECT_EQ(json["author"], "us");
  EXPECT_EQ(json["units"]["name"], "mm");
  EXPECT_EQ(json["units"]["decided_by"], "text");
  EXPECT_EQ(json["sizes"], (std::vector<std::string>{"38", "40"}));
  EXPECT_EQ(json["sample_size"], "38");
  ASSERT_EQ(json["pieces"].size(), 2u);
  const auto& piece = json["pieces"][1];
  EXPECT_EQ(piece["name"], "pocket");
  EXPECT_EQ(piece["size"], "40");
  EXPECT_EQ(piece["quantity"], 2);
  EXPECT_EQ(piece["quantity_mirrored"], 1);
  EXPECT_EQ(piece["material"], "denim");
  EXPECT_EQ(piece["width_mm"], 110);
  EXPECT_EQ(piece["area_mm2"], 12100);
  for (const char* count : {"notches", "drill_holes", "internal_lines"}) EXPECT_EQ(piece[count], 1) << count;
  EXPECT_EQ(piece["has_sew_line"], true);
  EXPECT_EQ(piece["sew_line_source"], "layer 14");
  EXPECT_EQ(piece["mirrored"], true);
  EXPECT_EQ(piece["grainline_deg"], 90);
  EXPECT_EQ(piece["graded_points"], 4);
  EXPECT_EQ(json["seams"][0]["b"]["begin"], 1);
  EXPECT_EQ(json["findings"][0]["code"], "aama.no-grain-line");
  EXPECT_EQ(json["findings"][0]["severity"], "warning");
  EXPECT_EQ(json["findings"][0]["remedy"], "draw one");
}

TEST(Inspection, OfAFileThatCannotBeReadSaysWhy) {
  Loaded<PatternFile> loaded;
  loaded.report.error("aama.units-ambiguous", "x.dxf", "mm or inches?", "say so", Fault::ambiguous);
  const auto json = nlohmann::json::parse(inspection_json(loaded, {}));
  EXPECT_TRUE(json["format"].is_null());
  EXPECT_TRUE(json["pieces"].empty());
  EXPECT_EQ(json["findings"][0]["severity"], "error");
  const std::string table = inspection_table("x.dxf", loaded, {});
  EXPECT_NE(table.find("aama.units-ambiguous"), std::string::npos);
}

TEST(Inspection, ReadsAsATable) {
  Loaded<PatternFile> loaded;
  loaded.value = nest();
  const std::string table = inspection_table("nest.dxf", loaded, piece_rows(*loaded.value));
  for (const char* words : {"nest.dxf\n", "DXF, AAMA", "mm (by text)", "[38] 40, a nest", "1+1", "100.0 x 100.0", "3.94 x 3.94",
                            "layer 14, unfolded", "90\xC2\xB0"})
    EXPECT_NE(table.find(words), std::string::npos) << words << "\n" << table;
}

}  // namespace
}  // namespace toile
