#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "draft/hand_made.h"
#include "draft/places.h"
#include "draft/redraw.h"
#include "garment/welds.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

double worst_difference(const RestShape& a, const RestShape& b) {
  double worst = 0;
  for (std::size_t p = 0; p < a.size(); ++p) worst = std::max(worst, (a[p] - b[p]).colwise().norm().maxCoeff());
  return worst;
}

double smallest_area(const GarmentMesh& garment, const RestShape& rest) {
  double least = 1;
  for (const Eigen::Matrix2d& triangle : rest_triangles(with_rest(garment, rest)))
    least = std::min(least, triangle.determinant() / 2);
  return least;
}

// Largest distance of a boundary vertex from the outline of its piece.
double off_outline(const Pattern& pattern, const GarmentMesh& garment, const RestShape& rest) {
  double worst = 0;
  for (std::size_t p = 0; p < rest.size(); ++p)
    for (const BoundaryVertex& vertex : garment.panels[p].boundary) {
      Eigen::Vector2d at = rest[p].col(vertex.vertex);
      if (garment.panels[p].mirrored) at.x() *= -1;
      const Piece& piece = pattern.pieces[static_cast<std::size_t>(garment.panels[p].piece)];
      worst = std::max(worst, nearest_on<2>(positions(piece.outline[static_cast<std::size_t>(vertex.edge)]), at).distance);
    }
  return worst;
}

TEST(RestOnOutlines, IsTheRestShapeItselfOnTheOriginal) {
  for (const HandMade& made : {gored_skirt(.01), gores_one_by_one(), curved_bodice()}) {
    const RestShape rest = rest_shape(made.garment);
    EXPECT_LT(worst_difference(rest_on_outlines(made.pattern, made.garment, rest), rest), 1e-9);
  }
}

// Strips along one line, divided alike; the third is sewn to the middle of it only.
TEST(PlacesOnOutline, OfSeveralPiecesInOneSeamAreWhereTheyWereMeshed) {
  GarmentMesh garment;
  const auto strip = [](int piece, int first, int last, bool up) {
    PanelMesh panel;
    panel.piece = piece;
    panel.name = std::to_string(piece);
    const int n = last - first;
    panel.rest.resize(2, 2 * n + 2);
    for (int i = 0; i <= n; ++i) {
      panel.rest.col(i) << .02 * (first + i), (up ? 0 : -.1);
      panel.rest.col(2 * n + 1 - i) << .02 * (first + i), (up ? .1 : 0);
    }
    panel.triangles.resize(3, 2 * n);
    for (int i = 0; i < n; ++i) {
      panel.triangles.col(2 * i) << i, i + 1, 2 * n + 1 - i;
      panel.triangles.col(2 * i + 1) << i + 1, 2 * n - i, 2 * n + 1 - i;
    }
    for (int i = 0; i < n; ++i) panel.boundary.push_back({i, 0, static_cast<double>(i) / n});
    panel.boundary.push_back({n, 1, 0});
    for (int i = 0; i < n; ++i) panel.boundary.push_back({n + 1 + i, 2, static_cast<double>(i) / n});
    panel.boundary.push_back({2 * n + 1, 3, 0});
    return panel;
  };
  garment.panels = {strip(0, 0, 12, true), strip(1, 0, 12, false), strip(2, 3, 8, false)};
  garment.vertex_count = 13 + 13 + 13 + 6;  // the line, and what is away from it
  garment.welded = {Eigen::VectorXi(26), Eigen::VectorXi(26), Eigen::VectorXi(12)};
  for (int i = 0; i < 13; ++i) {
    garment.welded[0](i) = garment.welded[1](25 - i) = i;
    garment.welded[0](25 - i) = 13 + i;
    garment.welded[1](i) = 26 + i;
  }
  for (int i = 0; i < 6; ++i) {
    garment.welded[2](11 - i) = 3 + i;
    garment.welded[2](i) = 39 + i;
  }
  Eigen::Index count = 0;
  garment.triangles.resize(3, 24 + 24 + 10);
  for (std::size_t p = 0; p < 3; ++p)
    for (const auto& corners : garment.panels[p].triangles.colwise())
      garment.triangles.col(count++) << garment.welded[p](corners(0)), garment.welded[p](corners(1)),
          garment.welded[p](corners(2));
  const auto places = places_on_outline(garment, rest_shape(garment));
  for (std::size_t p = 0; p < 3; ++p)
    for (std::size_t i = 0; i < places[p].size(); ++i) EXPECT_NEAR(places[p][i], garment.panels[p].boundary[i].at, 1e-12);
}

TEST(RestOnOutlines, PutsEveryBoundaryOnTheNewOutlineWithoutFolds) {
  for (const HandMade& made : {gored_skirt(.01), gores_one_by_one(), curved_bodice()}) {
    const auto larger = [](int, const Eigen::Vector2d& x) -> Eigen::Vector2d {
      return {x.x() * (1.1 + .1 * x.y()), x.y() * (1.05 + .1 * x.y()) + .1 * x.x() * x.x()};
    };
    const RestShape rest = mapped(made.garment, larger);
    const Pattern redrawn = redraw(made.pattern, made.garment, rest).pattern;
    const RestShape cut = rest_on_outlines(redrawn, made.garment, rest);
    EXPECT_LT(off_outline(redrawn, made.garment, cut), 1e-9);
    EXPECT_GT(smallest_area(made.garment, cut), .3 * smallest_area(made.garment, rest));
  }
}

TEST(RestOnOutlines, IsCutAlikeTwice) {
  const HandMade made = curved_bodice();
  const RestShape once = rest_on_outlines(redraw(made.pattern, made.garment, shaken(made.garment, .3e-3)).pattern, made.garment,
                                          shaken(made.garment, .3e-3));
  const Redrawn again = redraw(made.pattern, made.garment, once);
  EXPECT_LT(again.max_deviation, .25e-3);  // half the tolerance curves are refit within
  EXPECT_LT(worst_difference(rest_on_outlines(again.pattern, made.garment, once), once), .4e-3);
}

TEST(RestOnOutlines, KeepsUnevenStretchAndSewsEqualFractions) {
  const HandMade made = gored_skirt();
  // Only what is below 30 cm is lengthened, and the gores disagree a little.
  const auto longer = [](int panel, const Eigen::Vector2d& x) -> Eigen::Vector2d {
    return panel < 8 && x.y() < .3 ? Eigen::Vector2d(x.x(), .3 + (1.3 + .005 * panel) * (x.y() - .3)) : x;
  };
  const RestShape rest = mapped(made.garment, longer);
  const Pattern redrawn = redraw(made.pattern, made.garment, rest).pattern;
  const RestShape cut = rest_on_outlines(redrawn, made.garment, rest);
  for (const BoundarySegment& segment : boundary_segments(made.garment)) {
    const auto p = static_cast<std::size_t>(segment.panel);
    if (p >= 8 || segment.edge % 2 == 0) continue;
    const double wanted = (rest[p].col(segment.to) - rest[p].col(segment.from)).norm();
    EXPECT_NEAR((cut[p].col(segment.to) - cut[p].col(segment.from)).norm(), wanted, .02 * wanted);
  }
  const auto segments = boundary_segments(made.garment);
  for (const BoundarySegment& segment : segments)
    for (const int mate : segment.mates) {
      const BoundarySegment& other = segments[static_cast<std::size_t>(mate)];
      const auto p = static_cast<std::size_t>(segment.panel), q = static_cast<std::size_t>(other.panel);
      if (p >= 8 || q >= 8) continue;
      EXPECT_NEAR((cut[p].col(segment.to) - cut[p].col(segment.from)).norm(),
                  (cut[q].col(other.to) - cut[q].col(other.from)).norm(), 1e-9);
    }
}

TEST(RestOnOutlines, RefusesAnOutlineThatCannotHoldThePanel) {
  const HandMade made = gored_skirt();
  Pattern crossed = made.pattern;
  auto& right = crossed.pieces[0].outline[1].points;
  auto& waist = crossed.pieces[0].outline[2].points;
  auto& left = crossed.pieces[0].outline[3].points;
  std::swap(waist.front().at, waist.back().at);
  right.back() = waist.front();
  left.front() = waist.back();
  try {
    rest_on_outlines(crossed, made.garment, rest_shape(made.garment));
    FAIL() << "a crossed outline was accepted";
  } catch (const BadInput& error) {
    EXPECT_EQ(error.finding().code, "redraw.folded-panel");
    EXPECT_NE(error.finding().place.find("gore:1"), std::string::npos);
  }
}

TEST(SeamMismatch, IsTheDepartureFromTheRatioDrawn) {
  const HandMade made = curved_bodice(1.05);
  EXPECT_NEAR(seam_mismatch(made.pattern, made.pattern), 0, 1e-12);
  Pattern longer = made.pattern;
  for (OutlinePoint& point : longer.pieces[1].outline[1].points) point.at.y() *= 1.01;
  EXPECT_NEAR(seam_mismatch(made.pattern, longer), .01 * length(made.pattern.pieces[0].outline[1]), 1e-9);
}

}  // namespace
}  // namespace toile
