#include <gtest/gtest.h>

#include <cmath>

#include "cut/cut.h"
#include "formats/svg/write_svg.h"
#include "formats/svg_drawn.h"

namespace toile {
namespace {

using Eigen::Vector2d;

Pattern pattern() {
  Pattern all;
  all.name = "skirt";
  all.sample_size = "38";
  Piece front;
  front.name = "Ärmel <A&B>";
  front.quantity = 2;
  front.mirrored_quantity = 1;
  front.material = "lining";
  front.annotations = {"ease in", "press \"open\""};
  const std::vector<Vector2d> corners{{-.2, 0}, {.2, 0}, {.15, .5}, {-.15, .5}};
  const char* ids[] = {"hem", "right", "waist", "left"};
  for (std::size_t i = 0; i < 4; ++i) {
    Edge edge;
    edge.id = ids[i];
    const Vector2d a = corners[i], b = corners[(i + 1) % 4];
    edge.points.push_back({a, true, {}});
    // A curve, and a vertex on a straight line that is to stay.
    if (i == 1)
      for (int k = 1; k < 12; ++k)
        edge.points.push_back({a + k / 12.0 * (b - a) + Vector2d(.02 * std::sin(3.14159 * k / 12), 0), false, {}});
    if (i == 2) edge.points.push_back({(a + b) / 2, false, {}});
    edge.points.push_back({b, true, {}});
    if (i == 0) edge.hem = true;
    if (i != 3) edge.seam_allowance = .008 + .001 * static_cast<double>(i);
    front.outline.push_back(edge);
  }
  for (const NotchKind kind :
       {NotchKind::slit, NotchKind::v, NotchKind::t, NotchKind::castle, NotchKind::check, NotchKind::u}) {
    Notch notch;
    notch.edge = "right";
    notch.at = 1.0 / 7 + .1 * static_cast<double>(front.notches.size());
    notch.kind = kind;
    notch.depth = .005;
    notch.width = kind == NotchKind::slit ? 0 : .003;
    front.notches.push_back(notch);
  }
  front.grainline = Grainline{{0, .1}, {.01, .4}};
  front.drill_holes = {{{.05, .3}, .004}, {{.05, .2}, 0}};
  front.internal_lines = {{{{-.1, .2}, {-.05, .2}, {-.05, .25}}, false}, {{{0, .2}, {.02, .2}, {.02, .22}, {0, .2}}, true}};
  Piece band;
  band.name = "band";
  band.sewn = false;
  const std::vector<Vector2d> frame{{0, 0}, {.04, 0}, {.04, .6}, {0, .6}};
  for (std::size_t i = 0; i < 4; ++i)
    band.outline.push_back({"e" + std::to_string(i), {{frame[i], true, {}}, {frame[(i + 1) % 4], true, {}}}, {}, false});
  all.pieces = {front, band};
  return all;
}

void expect_near(const Vector2d& a, const Vector2d& b) { EXPECT_LT((a - b).norm(), 1.5e-6); }  // three digits of a millimetre

TEST(SvgOwn, WhatIsWrittenIsReadBack) {
  CutSheet sheet = lay_out(pattern());
  ASSERT_FALSE(sheet.placed.empty());
  sheet.placed[0].turn = .3;
  const Loaded<PatternFile> loaded = read_svg_bytes(svg_text(sheet), "own.svg");
  ASSERT_TRUE(loaded.value);
  const PatternFile& file = *loaded.value;
  EXPECT_EQ(file.dialect, "Toile");
  ASSERT_EQ(file.pattern.pieces.size(), sheet.placed.size());
  for (const PlacedPiece& placed : sheet.placed) {
    const Piece& piece = placed.cut.piece;
    const Piece* read = find_piece(file.pattern, piece.name);
    ASSERT_TRUE(read) << piece.name;
    EXPECT_EQ(read->quantity, piece.quantity);
    EXPECT_EQ(read->mirrored_quantity, piece.mirrored_quantity);
    EXPECT_EQ(read->material, piece.material);
    EXPECT_EQ(read->sewn, piece.sewn);
    EXPECT_EQ(read->annotations, piece.annotations);
    ASSERT_EQ(read->outline.size(), piece.outline.size());
    for (std::size_t i = 0; i < piece.outline.size(); ++i) {
      const Edge &a = piece.outline[i], &b = read->outline[i];
      EXPECT_EQ(a.id, b.id);
      EXPECT_EQ(a.hem, b.hem);
      EXPECT_EQ(a.seam_allowance.has_value(), b.seam_allowance.has_value());
      EXPECT_NEAR(a.seam_allowance.value_or(0), b.seam_allowance.value_or(0), 1e-6);
      ASSERT_EQ(a.points.size(), b.points.size()) << a.id;
      for (std::size_t k = 0; k < a.points.size(); ++k) {
        expect_near(a.points[k].at, b.points[k].at);
        EXPECT_EQ(a.points[k].turn, b.points[k].turn);
      }
    }
    ASSERT_EQ(read->notches.size(), piece.notches.size());
    for (std::size_t i = 0; i < piece.notches.size(); ++i) {
      const Notch &a = piece.notches[i], &b = read->notches[i];
      EXPECT_EQ(a.edge, b.edge);
      EXPECT_EQ(a.at, b.at);
      EXPECT_EQ(a.kind, b.kind);
      EXPECT_NEAR(a.depth, b.depth, 1e-6);
      EXPECT_NEAR(a.width, b.width, 1e-6);
    }
    ASSERT_EQ(read->drill_holes.size(), piece.drill_holes.size());
    for (std::size_t i = 0; i < piece.drill_holes.size(); ++i) {
      expect_near(piece.drill_holes[i].at, read->drill_holes[i].at);
      EXPECT_NEAR(piece.drill_holes[i].diameter, read->drill_holes[i].diameter, 1e-6);
    }
    ASSERT_EQ(read->internal_lines.size(), piece.internal_lines.size());
    for (std::size_t i = 0; i < piece.internal_lines.size(); ++i) {
      EXPECT_EQ(piece.internal_lines[i].cut_out, read->internal_lines[i].cut_out);
      ASSERT_EQ(piece.internal_lines[i].points.size(), read->internal_lines[i].points.size());
      for (std::size_t k = 0; k < piece.internal_lines[i].points.size(); ++k)
        expect_near(piece.internal_lines[i].points[k], read->internal_lines[i].points[k]);
    }
    ASSERT_EQ(read->grainline.has_value(), piece.grainline.has_value());
    if (piece.grainline) {
      expect_near(piece.grainline->from, read->grainline->from);
      expect_near(piece.grainline->to, read->grainline->to);
    }
  }
}

}  // namespace
}  // namespace toile
