// Garments draped elsewhere: the islands of vt are the pattern, v is the drape.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <sstream>

#include "formats/folder.h"
#include "formats/formats.h"
#include "formats/obj/faces.h"
#include "formats/obj/garment.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// How a program might write a tube of two halves, front and back, each `across` x `up` quads of cloth.
struct Tube {
  double radius = .16, height = .6, floor = .5;  // m
  int across = 12, up = 10;
  double unit = 1;     // of v: 100 for centimetres
  double texture = 1;  // of vt: units a metre
  bool welded = true;  // a seam is one v with two vt
  bool quads = false;
  bool turned_over = false;  // vt shows the inside
  bool corner_vt = false;    // every corner of every face anew
  bool names = true;
  double squeeze = 1;  // of v in the texture
};

std::string tube(const Tube& t) {
  std::ostringstream v, vt, f;
  v.precision(12);
  vt.precision(12);
  int vertices = 0, textures = 0;
  const int columns = t.across + 1;
  const auto corner = [&](int half, int i, int j) -> Vector3d {
    const double angle = std::numbers::pi * (half + static_cast<double>(i) / t.across);  // 0 at +x, over the back... and round
    return {t.radius * std::cos(angle), t.floor + t.height * j / t.up, t.radius * std::sin(angle)};
  };
  // Angles grow from +x to +z; seen from outside that runs to the left, so the flat x grows the other way.
  const auto flat = [&](int half, int i, int j) -> Vector2d {
    const double width = std::numbers::pi * t.radius;
    double x = width * (1 - static_cast<double>(i) / t.across) + 1.5 * width * half;
    if (t.turned_over) x = -x;
    return t.texture * Vector2d(x, t.squeeze * t.height * j / t.up);
  };
  std::vector<int> number(static_cast<std::size_t>(2 * columns * (t.up + 1)));
  const auto index = [&](int half, int i, int j) -> int& {
    return number[static_cast<std::size_t>((half * columns + i) * (t.up + 1) + j)];
  };
  for (int half = 0; half < 2; ++half)
    for (int i = 0; i <= t.across; ++i)
      for (int j = 0; j <= t.up; ++j) {
        if (t.welded && half == 1 && i == 0)
          index(half, i, j) = index(0, t.across, j);
        else if (t.welded && half == 1 && i == t.across)
          index(half, i, j) = index(0, 0, j);
        else {
          const Vector3d p = t.unit * corner(half, i, j);
          v << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
          index(half, i, j) = ++vertices;
        }
      }
  for (int half = 0; half < 2; ++half) {
    const int base = textures;
    if (!t.corner_vt)
      for (int i = 0; i <= t.across; ++i)
        for (int j = 0; j <= t.up; ++j) {
          const Vector2d p = flat(half, i, j);
          vt << "vt " << p.x() << ' ' << p.y() << '\n';
          ++textures;
        }
    if (t.names) f << "g " << (half == 0 ? "front panel" : "back panel") << '\n';
    const auto face = [&](const std::vector<std::pair<int, int>>& corners) {
      f << 'f';
      for (const auto& [i, j] : corners) {
        int texture = base + i * (t.up + 1) + j + 1;
        if (t.corner_vt) {
          const Vector2d p = flat(half, i, j);
          vt << "vt " << p.x() << ' ' << p.y() << '\n';
          texture = ++textures;
        }
        f << ' ' << index(half, i, j) << '/' << texture;
      }
      f << '\n';
    };
    for (int i = 0; i < t.across; ++i)
      for (int j = 0; j < t.up; ++j) {
        if (t.quads) {
          face({{i, j}, {i, j + 1}, {i + 1, j + 1}, {i + 1, j}});
        } else {
          face({{i, j}, {i, j + 1}, {i + 1, j + 1}});
          face({{i, j}, {i + 1, j + 1}, {i + 1, j}});
        }
      }
  }
  return v.str() + vt.str() + f.str();
}

Loaded<PatternFile> read(const std::string& text, std::optional<double> unit = {}) {
  return read_obj_garment(text, "tube.obj", unit);
}

const Finding* find(const Report& report, const std::string& code) {
  for (const Finding& finding : report.findings)
    if (finding.code == code) return &finding;
  return nullptr;
}

std::string error_of(const std::string& text) {
  const auto loaded = read(text);
  EXPECT_EQ(loaded.value.has_value(), loaded.report.ok());
  for (const Finding& finding : loaded.report.findings)
    if (finding.severity == Severity::error) return finding.code;
  return "none";
}

// The two halves of the tube: width by height, four straight edges, sewn side to side in the right sense.
void expect_tube(const Loaded<PatternFile>& loaded, const Tube& t, double tolerance = 1e-6) {
  ASSERT_TRUE(loaded.value) << (loaded.report.findings.empty() ? "" : in_words(loaded.report.findings.back()));
  const Pattern& pattern = loaded.value->pattern;
  ASSERT_EQ(pattern.pieces.size(), 2u);
  // Chords of the circle are shorter than its arc; the texture is what counts.
  const double width = std::numbers::pi * t.radius;
  for (const Piece& piece : pattern.pieces) {
    ASSERT_EQ(piece.outline.size(), 4u) << piece.name;
    EXPECT_NEAR(signed_area(piece), width * t.height, 2 * tolerance) << piece.name;
    for (const Edge& edge : piece.outline) {
      EXPECT_EQ(edge.points.size(), 2u);
      EXPECT_TRUE(edge.points.front().turn && edge.points.back().turn);
    }
  }
  ASSERT_EQ(pattern.seams.size(), 2u);
  const DrapedGarment& drape = loaded.value->drape.at(0);
  EXPECT_NO_THROW(check(drape.garment));
  EXPECT_EQ(drape.garment.vertex_count, 2 * t.across * (t.up + 1));
  for (const Seam& seam : pattern.seams) {
    EXPECT_FALSE(seam.right_to_wrong);
    EXPECT_NEAR(span_length(pattern, seam.a), t.height, tolerance);
    EXPECT_NEAR(span_length(pattern, seam.b), t.height, tolerance);
    EXPECT_NE(seam.a.piece, seam.b.piece);
    EXPECT_LT((seam.a.end - seam.a.begin) * (seam.b.end - seam.b.begin), 0) << "right to right";
  }
}

TEST(ObjGarment, ReadsWeldedAndUnweldedSeamsTrianglesAndQuads) {
  for (const bool welded : {true, false})
    for (const bool quads : {true, false}) {
      const Tube t{.welded = welded, .quads = quads};
      const auto loaded = read(tube(t));
      expect_tube(loaded, t);
      EXPECT_EQ(find(loaded.report, "obj.polygons-split") != nullptr, quads);
      EXPECT_EQ(loaded.value->pattern.pieces[0].name, "front panel");
      EXPECT_EQ(loaded.value->pattern.pieces[1].name, "back panel");
    }
}

TEST(ObjGarment, TakesUnitsOfVerticesAndTextureFromTheGarmentItself) {
  for (const auto& [unit, name] : {std::pair(1., "m"), std::pair(100., "cm"), std::pair(1000., "mm")}) {
    const Tube t{.unit = unit, .texture = 1};
    const auto loaded = read(tube(t));
    // The chords of 12 quads to half a circle are .3 % shorter than the cloth: still metres.
    expect_tube(loaded, t);
    EXPECT_EQ(loaded.value->units.name, name);
    EXPECT_EQ(loaded.value->units.decided_by, "plausibility");
    EXPECT_NEAR(loaded.value->drape[0].positions.row(1).maxCoeff(), 1.1, 1e-9);
  }
  for (const double texture : {100., 1000., 1 / .0254}) expect_tube(read(tube({.texture = texture})), {});
}

TEST(ObjGarment, ScalesATextureOfNoUnitByItsEdges) {
  const Tube t{.across = 40, .texture = 1 / 1.37};
  const auto loaded = read(tube(t));
  expect_tube(loaded, t, 2e-3);
  const Finding* scale = find(loaded.report, "obj.vt-scale");
  ASSERT_TRUE(scale);
  EXPECT_NE(scale->text.find("1370"), std::string::npos) << scale->text;
}

TEST(ObjGarment, SetsRightATextureStretchedToASquare) {
  const Tube t{.across = 40, .texture = .9, .squeeze = 1.6};
  const auto loaded = read(tube(t));
  expect_tube(loaded, t, 2e-3);
  EXPECT_TRUE(find(loaded.report, "obj.uneven-texture"));
}

TEST(ObjGarment, AsksForTheUnitWhenNoneFits) {
  const auto loaded = read(tube({.unit = 12}));
  ASSERT_FALSE(loaded.value);
  ASSERT_TRUE(find(loaded.report, "obj.units"));
  EXPECT_EQ(find(loaded.report, "obj.units")->fault, Fault::ambiguous);
  expect_tube(read(tube({.unit = 12, .texture = 1}), 1 / 12.), {});
}

TEST(ObjGarment, ReflectsWhatTheTextureShowsFromInside) {
  const Tube t{.turned_over = true};
  const auto loaded = read(tube(t));
  expect_tube(loaded, t);
  EXPECT_TRUE(find(loaded.report, "obj.turned-over"));
}

TEST(ObjGarment, ReadsFilesThatWriteEveryCornerAnew) { expect_tube(read(tube({.corner_vt = true})), {}); }

TEST(ObjGarment, NamesPiecesThatTheFileDoesNotName) {
  const auto loaded = read(tube({.names = false}));
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->pattern.pieces[0].name, "piece 1");
  EXPECT_EQ(loaded.value->pattern.pieces[1].name, "piece 2");
}

// Pieces hang where they would have to be sewn from: the front before the body, the back behind it.
TEST(ObjGarment, SaysWhereThePiecesHang) {
  const Tube t;
  const auto loaded = read(tube(t));
  ASSERT_TRUE(loaded.value);
  for (int p = 0; p < 2; ++p) {
    const Piece& piece = loaded.value->pattern.pieces[static_cast<std::size_t>(p)];
    ASSERT_EQ(piece.placement.size(), 1u);
    ASSERT_TRUE(piece.placement[0]);
    const double side = p == 0 ? 1 : -1;  // half 0 goes from +x over +z to -x
    EXPECT_NEAR(piece.placement[0]->rotation.determinant(), 1, 1e-9);
    EXPECT_GT(side * (piece.placement[0]->rotation * Vector3d::UnitZ()).z(), .99);
    for (const Edge& edge : piece.outline) {
      const Vector2d at = edge.points.front().at;
      const Vector3d hung = piece.placement[0]->rotation * Vector3d(at.x(), at.y(), 0) + piece.placement[0]->translation;
      EXPECT_NEAR(side * hung.z(), t.radius + .05, 1e-6);
      EXPECT_GT(hung.y(), t.floor - 1e-6);
      EXPECT_LT(hung.y(), t.floor + t.height + 1e-6);
    }
  }
}

TEST(ObjGarment, NamesWhatIsMissingOrBroken) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  EXPECT_EQ(error_of(square + "f 1 2 3\nf 1 3 4\n"), "obj.no-vt");
  EXPECT_EQ(error_of(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1 3 4\n"), "obj.no-vt");
  EXPECT_EQ(error_of(square + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"), "obj.no-such-vertex");
  EXPECT_EQ(error_of(square + "vt 0 0\nvt 1 nan\nvt 1 1\nf 1/1 2/2 3/3\n"), "obj.not-finite");
  EXPECT_EQ(error_of(square + "vt 0 0\nvt 1 1e80\nvt 1 1\nf 1/1 2/2 3/3\n"), "obj.too-far");
  EXPECT_EQ(error_of(square + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3/1/1\n"), "obj.bad-face");
  EXPECT_EQ(error_of(square + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 1/1\n"), "obj.no-faces");
  EXPECT_EQ(error_of(square + "vt 0 0\nf 1/1 2/1 3/1\n"), "obj.degenerate-island");
  // Three faces at one edge.
  EXPECT_EQ(error_of(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 3/3 1/1 2/2\n"),
            "obj.not-manifold");
  // One of two faces folded over onto a small part of the other.
  EXPECT_EQ(error_of(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt .6 .5\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"), "obj.folded-island");
  // A bow tie of a quad.
  EXPECT_EQ(error_of(square + "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nf 1/1 2/2 3/3 4/4\n"), "obj.folded-island");
  EXPECT_EQ(error_of(""), "obj.no-faces");
  // Two triangles that touch in a point only.
  EXPECT_EQ(error_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvt 2 0\nvt 2 1\n"
                     "f 1/1 2/2 3/3\nf 2/2 5/5 6/6\nf 4/4 3/3 2/2\nf 2/2 6/6 4/4\n"),
            "none");
}

// The texture of a sphere's octant is no flat of it.
TEST(ObjGarment, RefusesATextureThatIsNoFlatOfThePiece) {
  std::ostringstream text;
  const int n = 12;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double a = std::numbers::pi * 1.6 * i / n, b = std::numbers::pi * .45 * j / n;
      text << "v " << std::sin(b) * std::cos(a) * .4 << ' ' << 1 + .4 * std::cos(b) << ' ' << .4 * std::sin(b) * std::sin(a)
           << '\n';
    }
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) text << "vt " << static_cast<double>(i) / n << ' ' << static_cast<double>(j) / n << '\n';
  const auto at = [&](int i, int j) { return std::to_string(i * (n + 1) + j + 1); };
  for (int i = 0; i < n; ++i)
    for (int j = 1; j < n; ++j)
      text << "f " << at(i, j) + "/" + at(i, j) << ' ' << at(i + 1, j) + "/" + at(i + 1, j) << ' '
           << at(i + 1, j + 1) + "/" + at(i + 1, j + 1) << ' ' << at(i, j + 1) + "/" + at(i, j + 1) << '\n';
  EXPECT_EQ(error_of(text.str()), "obj.not-flat");
}

TEST(SplitPolygon, KeepsAreaAndSense) {
  const std::vector<Vector2d> arrow = {{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}};
  for (const bool clockwise : {false, true}) {
    std::vector<Vector2d> polygon = arrow;
    if (clockwise) std::reverse(polygon.begin(), polygon.end());
    double area = 0;
    const auto triangles = split_polygon(polygon);
    ASSERT_EQ(triangles.size(), 3u);
    for (const Eigen::Vector3i& t : triangles) {
      const auto at = [&](int k) { return polygon[static_cast<std::size_t>(t[k])]; };
      const double twice = (at(1) - at(0)).x() * (at(2) - at(0)).y() - (at(1) - at(0)).y() * (at(2) - at(0)).x();
      EXPECT_EQ(twice < 0, clockwise);
      area += twice / 2;
    }
    EXPECT_NEAR(std::abs(area), 8, 1e-12);
  }
}

}  // namespace
}  // namespace toile
