#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "pieces.h"

namespace toile {
namespace {

using namespace testing;
using Eigen::Vector2d;

// A star-shaped piece of 3 to 12 edges, some of them curved, some without allowance, with the first one a hem.
Piece star(std::mt19937& random) {
  const auto pick = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 5) / (1U << 27U));
  };
  const int corners = 3 + static_cast<int>(pick(0, 10));
  Points around;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + pick(-.3, .3)) / corners;
    around.push_back(pick(.12, .35) * Vector2d(std::cos(angle), std::sin(angle)));
  }
  std::vector<Edge> edges;
  for (int i = 0; i < corners; ++i) {
    const Vector2d a = around[static_cast<std::size_t>(i)], b = around[static_cast<std::size_t>((i + 1) % corners)];
    Points points{a};
    const double bulge = pick(0, 1) < .5 ? 0 : pick(-.12, .12);
    const Vector2d out = turned_right(b - a);
    for (int k = 1; k < 12 && bulge != 0; ++k) {
      const double t = k / 12.0;
      points.push_back(a + t * (b - a) + bulge * 4 * t * (1 - t) * out);
    }
    points.push_back(b);
    const double kind = pick(0, 1);
    edges.push_back(edge("e" + std::to_string(i), points, kind < .15 ? 0 : pick(.004, .025)));
  }
  edges.front().hem = true;
  edges.front().seam_allowance = .03;
  return piece(std::move(edges));
}

TEST(RandomPieces, KeepTheGuarantees) {
  std::mt19937 random(1607);
  int cut_pieces = 0, refused = 0;
  for (int trial = 0; trial < 600; ++trial) {
    Piece made = star(random);
    const Polygon net = net_line(made);
    if (first_self_crossing(net, touching) || signed_area(net) <= 0) continue;
    for (const Edge& e : made.outline)
      for (const double at : {0., .3, .9}) {
        Notch notch;
        notch.edge = e.id;
        notch.at = at;
        made.notches.push_back(notch);
      }
    CutPiece cut;
    try {
      cut = add_allowance(made);
    } catch (const BadInput& bad) {
      EXPECT_EQ(bad.finding().code, "cut.allowance-crosses");
      ++refused;
      continue;
    }
    ++cut_pieces;
    const Polygon line = places(cut.cut_line);
    SCOPED_TRACE(trial);
    EXPECT_FALSE(first_self_crossing(line, touching));
    EXPECT_GT(signed_area(line), signed_area(net) * (1 - 1e-12));
    EXPECT_EQ(cut.notches.size(), made.notches.size());
    for (const CutNotch& notch : cut.notches) EXPECT_LT(distance_to(line, notch.at), 1e-9);

    const std::size_t n = made.outline.size();
    for (std::size_t e = 0; e < n; ++e) {
      const double least = std::min({*made.outline[e].seam_allowance, *made.outline[(e + 1) % n].seam_allowance,
                                     *made.outline[(e + n - 1) % n].seam_allowance});
      const double own = *made.outline[e].seam_allowance;
      const std::vector<Vector2d> sew = positions(made.outline[e]);
      for (std::size_t i = 1; i < sew.size(); ++i)
        for (const double t : {0., .25, .5, .75, 1.}) {
          const Vector2d p = (1 - t) * sew[i - 1] + t * sew[i];
          EXPECT_GE(distance_to(line, p), least - 1e-6) << made.outline[e].id;
          EXPECT_TRUE(contains(line, p) || distance_to(line, p) < (own > 0 ? 1e-6 : 1e-9));
        }
    }
    // No point of the cut line wanders off: tips are cut off square at the mitre limit.
    for (const Vector2d& p : line) EXPECT_LE(distance_to(net, p), std::hypot(1, 2.5) * .03 + 1e-9);
  }
  EXPECT_GT(cut_pieces, 300);
  EXPECT_LT(refused, cut_pieces / 5);
}

TEST(RandomPieces, CutTwiceAreTheSame) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Piece made = star(random);
    if (first_self_crossing(net_line(made), touching) || signed_area(made) <= 0) continue;
    try {
      EXPECT_EQ(add_allowance(made), add_allowance(made));
    } catch (const BadInput&) {
    }
  }
}

}  // namespace
}  // namespace toile
