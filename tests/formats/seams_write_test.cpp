#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "formats/garmentcode/garmentcode.h"
#include "formats/seams/seams.h"
#include "formats/seams_skirt.h"

namespace toile {
namespace {

// The pattern as a reader finds it in a DXF: edges numbered, outlines beginning elsewhere, nothing else known.
Pattern stripped(Pattern pattern, const Eigen::Vector2d& shift, std::size_t begin_later_by) {
  for (Piece& piece : pattern.pieces) {
    std::rotate(piece.outline.begin(),
                piece.outline.begin() + static_cast<std::ptrdiff_t>(begin_later_by % piece.outline.size()),
                piece.outline.end());
    for (std::size_t k = 0; k < piece.outline.size(); ++k) {
      Edge& edge = piece.outline[k];
      for (Notch& notch : piece.notches)
        if (notch.edge == edge.id) notch.edge = "n" + std::to_string(k);
      edge.id = "n" + std::to_string(k);
      edge.hem = false;
      edge.seam_allowance.reset();
      for (OutlinePoint& point : edge.points) point.at += shift;
    }
    piece.body_part.clear();
    piece.placement.clear();
    piece.quantity = 1;
    piece.mirrored_quantity = 0;
    piece.sewn = true;
  }
  pattern.seams.clear();
  return pattern;
}

void expect_same_sewing(const Pattern& got, const Pattern& wanted) {
  EXPECT_EQ(got.seams, wanted.seams);
  ASSERT_EQ(got.pieces.size(), wanted.pieces.size());
  for (std::size_t i = 0; i < got.pieces.size(); ++i) {
    const Piece &a = got.pieces[i], &b = wanted.pieces[i];
    SCOPED_TRACE(b.name);
    EXPECT_EQ(a.quantity, b.quantity);
    EXPECT_EQ(a.mirrored_quantity, b.mirrored_quantity);
    EXPECT_EQ(a.sewn, b.sewn);
    EXPECT_EQ(a.notches, b.notches);
    ASSERT_EQ(a.outline.size(), b.outline.size());
    for (const Edge& edge : b.outline) {
      const Edge* same = find_edge(a, edge.id);
      ASSERT_TRUE(same) << edge.id;
      EXPECT_EQ(same->hem, edge.hem);
      EXPECT_NEAR(same->seam_allowance.value_or(-1), edge.seam_allowance.value_or(-1), 1e-12);
      EXPECT_NEAR(length(*same), length(edge), 1e-12);
    }
    ASSERT_EQ(a.body_part.size(), b.body_part.size());
    for (std::size_t k = 0; k < a.body_part.size(); ++k) {
      ASSERT_EQ(a.body_part[k].has_value(), b.body_part[k].has_value());
      if (!a.body_part[k]) continue;
      EXPECT_EQ(a.body_part[k]->part, b.body_part[k]->part);
      EXPECT_EQ(a.body_part[k]->level, b.body_part[k]->level);
      EXPECT_NEAR(a.body_part[k]->angle, b.body_part[k]->angle, 1e-14);
      EXPECT_NEAR(a.body_part[k]->drop, b.body_part[k]->drop, 1e-14);
    }
    ASSERT_EQ(a.placement.size(), b.placement.size());
    for (std::size_t k = 0; k < a.placement.size(); ++k) {
      ASSERT_EQ(a.placement[k].has_value(), b.placement[k].has_value());
      if (!a.placement[k]) continue;
      EXPECT_LT((a.placement[k]->rotation - b.placement[k]->rotation).norm(), 1e-12);
      EXPECT_LT((a.placement[k]->translation - b.placement[k]->translation).norm(), 1e-12);
    }
  }
}

TEST(WriteSeams, ReadsBackAsTheSame) {
  Pattern pattern =
      applied(one_seam("ring = \"gore\"\nfrom = \"right\"\nto = \"left\"\nname = \"gore\"\n"
                       "[[seam]]\nalong = \"band.bottom\"\neach = \"gore.top\"\nstart = \"37 mm\"\nname = \"waist\"\n"
                       "[[seam]]\nname = \"back \\\"\"\na = \"band.left\"\nb = \"band.right\"\nreversed = true\n"
                       "right_to_wrong = true\n[[piece]]\nname = \"FRONT 1.5\"\nallowance = \"7 mm\"\nhems = [\"e0\"]\n"
                       "on = { part = \"leg.R\", level = \"hip\", drop = \"33 mm\", angle = \"12.3 deg\" }\n"
                       "[[seam]]\nname = \"cf\"\na = \"FRONT 1.5:1.e1[1/3..1/2]\"\nb = \"FRONT 1.5:2.e1\"\n"),
              [] {
                Pattern p = skirt();
                p.pieces.push_back(polygon("FRONT 1.5", {{0, 0}, {.2, 0}, {.2, .5}, {.05, .45}}, 1, 1));
                p.pieces.push_back(polygon("POCKET", {{0, 0}, {.1, 0}, {.1, .1}}));
                p.pieces.back().sewn = false;
                return p;
              }());
  pattern.pieces[0].placement = {
      std::nullopt,
      Placement{Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, .5).normalized()).toRotationMatrix(), {.1, 1.2, -.3}},
      Placement{Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()).toRotationMatrix(), {0, 1, 0}}, std::nullopt};
  for (std::size_t later = 0; later < 4; ++later) {
    Pattern back = stripped(pattern, {.3, -.2}, later);
    const Report report = apply_seams(back, seams_text(pattern), "skirt.seams.toml");
    for (const Finding& f : report.findings) ADD_FAILURE() << in_words(f) << "\n" << seams_text(pattern);
    expect_same_sewing(back, pattern);
  }
}

TEST(WriteSeams, RealGarmentsReadBackAsTheSame) {
  const char* corpus = std::getenv("TOILE_CORPUS");
  if (!corpus) GTEST_SKIP() << "TOILE_CORPUS is not set";
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(corpus) / "patterns/garmentcode/mh_f38")) {
    SCOPED_TRACE(entry.path().filename());
    const Pattern pattern = *read_garmentcode(entry.path()).value;
    Pattern back = stripped(pattern, {0, 0}, 2);
    const Report report = apply_seams(back, seams_text(pattern), "x.seams.toml");
    for (const Finding& f : report.findings) ADD_FAILURE() << in_words(f);
    expect_same_sewing(back, pattern);
  }
}

}  // namespace
}  // namespace toile
