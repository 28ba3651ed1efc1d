#include "pairing/pairing.h"

#include <gtest/gtest.h>

#include <set>

#include "pairing/pieces.h"

namespace toile {
namespace {

using Sewn = std::set<std::set<std::string>>;

Sewn sewn(const Proposal& proposal) {
  Sewn out;
  for (const ProposedSeam& seam : proposal.seams) {
    std::set<std::string> both;
    for (const EdgeSpan& span : {seam.seam.a, seam.seam.b})
      both.insert(span.piece + ":" + std::to_string(span.copy) + "." + span.edge);
    out.insert(both);
  }
  return out;
}

TEST(Pairing, SewsTwoSkirtHalvesAtTheirSidesAndLeavesWaistAndHemOpen) {
  Pattern pattern;
  pattern.pieces = {test::skirt_half("front"), test::skirt_half("back")};
  const Proposal named = propose_seams(pattern, test::templates());
  EXPECT_EQ(sewn(named), (Sewn{{"front:1.e1", "back:1.e3"}, {"front:1.e3", "back:1.e1"}}));
  ASSERT_EQ(named.pattern.pieces[1].body_part.size(), 1u);
  ASSERT_TRUE(named.pattern.pieces[1].body_part[0]);
  EXPECT_EQ(named.pattern.pieces[1].body_part[0]->part, "trunk");
}

TEST(Pairing, JoinsSeamsFromTheSameEnd) {
  Pattern pattern;
  pattern.pieces = {test::skirt_half("front"), test::skirt_half("back")};
  for (const ProposedSeam& seam : propose_seams(pattern, test::templates()).seams) {
    const auto place = [&](const EdgeSpan& span, double at) {
      const Edge& edge = *find_edge(*find_piece(pattern, span.piece), span.edge);
      return (edge.points[0].at + at * (edge.points[1].at - edge.points[0].at)).y();
    };
    EXPECT_NEAR(place(seam.seam.a, seam.seam.a.begin), place(seam.seam.b, seam.seam.b.begin), 1e-9);
  }
}

TEST(Pairing, ClosesADart) {
  Pattern pattern;
  pattern.pieces = {test::polygon("front", {{-.3, 0}, {.3, 0}, {.2, .6}, {.01, .6}, {0, .48}, {-.01, .6}, {-.2, .6}}),
                    test::skirt_half("back")};
  const Sewn found = sewn(propose_seams(pattern, test::templates()));
  EXPECT_TRUE(found.count({"front:1.e3", "front:1.e4"}));
  EXPECT_EQ(found.size(), 3u);
}

TEST(Pairing, SharesABandOutAmongThePiecesBelowIt) {
  Pattern pattern;
  pattern.pieces = {test::skirt_half("front"), test::skirt_half("back"),
                    test::polygon("waistband", {{0, 0}, {.72, 0}, {.72, .04}, {0, .04}})};
  const Proposal found = propose_seams(pattern, test::templates());
  EXPECT_EQ(found.garment, "skirt");
  double along = 0;
  for (const ProposedSeam& seam : found.seams)
    for (const EdgeSpan& span : {seam.seam.a, seam.seam.b})
      if (span.piece == "waistband" && span.edge == "e0") along += std::abs(span.end - span.begin);
  EXPECT_NEAR(along, 1, 1e-9);
  EXPECT_TRUE(sewn(found).count({"waistband:1.e1", "waistband:1.e3"}));
  EXPECT_TRUE(found.apart.empty());
}

// The band's middle is in front and its ends meet behind; its left half, seen from outside, is on the wearer's right.
TEST(Pairing, HangsGoresBelowTheRunOfTheBandThatTheyAreSewnTo) {
  Pattern pattern;
  pattern.pieces = {test::polygon("gore", {{-.1, 0}, {.1, 0}, {.06, .6}, {-.06, .6}}),
                    test::polygon("waistband", {{0, 0}, {.72, 0}, {.72, .04}, {0, .04}})};
  pattern.pieces[0].quantity = 6;
  const Proposal found = propose_seams(pattern, test::templates());
  int held = 0;
  for (const ProposedSeam& seam : found.seams)
    for (const auto& [band, gore] : {std::pair{seam.seam.a, seam.seam.b}, std::pair{seam.seam.b, seam.seam.a}}) {
      if (band.piece != "waistband" || band.edge != "e0" || gore.piece != "gore") continue;
      const auto& at = find_piece(found.pattern, "gore")->body_part[static_cast<std::size_t>(gore.copy - 1)];
      ASSERT_TRUE(at);
      const double turn = 2 * M_PI, wanted = turn * ((band.begin + band.end) / 2 - .5);
      EXPECT_NEAR(std::remainder(at->angle - wanted, turn), 0, 1e-6) << "gore " << gore.copy;
      ++held;
    }
  EXPECT_EQ(held, 6);
}

TEST(Pairing, IsLessSureWithoutNames) {
  Pattern pattern, blank;
  pattern.pieces = {test::skirt_half("front"), test::skirt_half("back")};
  blank.pieces = {test::skirt_half("x"), test::skirt_half("y")};
  const Proposal named = propose_seams(pattern, test::templates()), shapes = propose_seams(blank, test::templates());
  EXPECT_TRUE(shapes.garment.empty());
  EXPECT_EQ(shapes.seams.size(), 2u);
  EXPECT_LT(shapes.least_confidence, named.least_confidence);
}

TEST(Pairing, IsTheSameEveryTime) {
  Pattern pattern;
  pattern.pieces = {test::skirt_half("front"), test::skirt_half("back", .34)};
  const Proposal once = propose_seams(pattern, test::templates()), again = propose_seams(pattern, test::templates());
  EXPECT_EQ(once.pattern, again.pattern);
}

TEST(Pairing, LeavesPocketsAlone) {
  Pattern pattern;
  pattern.pieces = {test::skirt_half("front"), test::skirt_half("back"),
                    test::polygon("pocket", {{0, 0}, {.15, 0}, {.15, .6}, {0, .6}})};
  const Proposal found = propose_seams(pattern, test::templates());
  EXPECT_EQ(found.extras, std::vector<std::string>{"pocket"});
  EXPECT_TRUE(found.apart.empty());
  EXPECT_EQ(found.seams.size(), 2u);
}

}  // namespace
}  // namespace toile
