// Every DXF profile through write, read and ezdxf, with patterns made by chance from a fixed seed.

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>

#include "cut/cut.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_aama/profiles.h"
#include "formats/formats.h"

namespace toile {
namespace {

using Eigen::Vector2d;

// Pieces of three to seven edges round the origin, some curved, with everything on them that a piece can have.
class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  double in(double low, double high) { return low + (high - low) * static_cast<double>(engine_() % 100001) / 1e5; }
  int upto(int most) { return static_cast<int>(engine_() % static_cast<unsigned>(most + 1)); }

  Piece piece(const std::string& name) {
    Piece made;
    made.name = name;
    made.quantity = 1 + upto(3);
    made.mirrored_quantity = upto(2);
    made.material = upto(1) ? "self" : "lining";
    const int n = 3 + upto(4);
    const double size = in(.2, .4);
    std::vector<Vector2d> corners;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * M_PI * (k + in(-.2, .2)) / n;
      corners.push_back(size * in(.8, 1.1) * Vector2d(std::cos(angle), std::sin(angle)));
    }
    for (int k = 0; k < n; ++k) {
      const Vector2d a = corners[static_cast<std::size_t>(k)], b = corners[static_cast<std::size_t>((k + 1) % n)];
      Edge edge;
      edge.id = "e" + std::to_string(k);
      const int segments = upto(1) ? 1 : 6 + upto(6);
      const double sag = in(-.08, .08);
      for (int i = 0; i <= segments; ++i) {
        const double t = static_cast<double>(i) / segments;
        const Vector2d out(b.y() - a.y(), a.x() - b.x());
        edge.points.push_back({a + t * (b - a) + 4 * t * (1 - t) * sag * out, i == 0 || i == segments, {}});
      }
      made.outline.push_back(edge);
    }
    for (const Edge& edge : made.outline)
      if (upto(1)) {
        Notch notch;
        notch.edge = edge.id;
        notch.at = in(.3, .7);
        notch.kind = static_cast<NotchKind>(upto(5));
        notch.depth = 1e-3 * (2 + upto(4));
        notch.width = notch.kind == NotchKind::slit ? 0 : 1e-3 * (2 + upto(3));
        made.notches.push_back(notch);
      }
    if (upto(1)) made.drill_holes.push_back({{in(-.05, .05), in(-.05, .05)}, 1e-3 * upto(5)});
    if (upto(1)) made.internal_lines.push_back({{{-.05, 0}, {0, .03}, {.05, .01}}, false});
    if (upto(1)) made.internal_lines.push_back({{{-.02, -.06}, {.02, -.06}, {0, -.03}, {-.02, -.06}}, true});
    made.grainline = Grainline{{0, -.08}, {in(-.01, .01), .08}};
    if (upto(1)) made.annotations = {"ease 2 cm"};
    return made;
  }

 private:
  std::mt19937 engine_;
};

void expect_near(const std::vector<Vector2d>& a, const std::vector<Vector2d>& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LE((a[i] - b[i]).norm(), 2e-7) << what;
}

void expect_same(const Piece& piece, const Piece& other, bool plain_notches) {
  SCOPED_TRACE(piece.name);
  EXPECT_EQ(other.quantity, piece.quantity);
  EXPECT_EQ(other.mirrored_quantity, piece.mirrored_quantity);
  EXPECT_EQ(other.material, piece.material);
  EXPECT_EQ(other.annotations, piece.annotations);
  ASSERT_EQ(other.outline.size(), piece.outline.size());
  for (std::size_t e = 0; e < piece.outline.size(); ++e) {
    expect_near(positions(piece.outline[e]), positions(other.outline[e]), piece.outline[e].id);
    for (std::size_t i = 0; i < piece.outline[e].points.size(); ++i)
      EXPECT_EQ(other.outline[e].points[i].turn, piece.outline[e].points[i].turn);
  }
  ASSERT_EQ(other.notches.size(), piece.notches.size());
  for (std::size_t n = 0; n < piece.notches.size(); ++n) {
    const Notch &notch = piece.notches[n], &same = other.notches[n];
    EXPECT_EQ(same.edge, notch.edge);
    EXPECT_NEAR(same.at, notch.at, 2e-4);
    EXPECT_NEAR(same.depth, notch.depth, 1e-7);
    EXPECT_NEAR(same.width, notch.width, 1e-7);
    if (!plain_notches) {
      EXPECT_EQ(same.kind, notch.kind);
    }
  }
  ASSERT_EQ(other.drill_holes.size(), piece.drill_holes.size());
  for (std::size_t h = 0; h < piece.drill_holes.size(); ++h) {
    expect_near({piece.drill_holes[h].at}, {other.drill_holes[h].at}, "hole");
    EXPECT_NEAR(other.drill_holes[h].diameter, piece.drill_holes[h].diameter, 1e-7);
  }
  ASSERT_EQ(other.internal_lines.size(), piece.internal_lines.size());
  for (std::size_t l = 0; l < piece.internal_lines.size(); ++l) {
    EXPECT_EQ(other.internal_lines[l].cut_out, piece.internal_lines[l].cut_out);
    expect_near(piece.internal_lines[l].points, other.internal_lines[l].points, "internal line");
  }
  ASSERT_TRUE(other.grainline);
  expect_near({piece.grainline->from, piece.grainline->to}, {other.grainline->from, other.grainline->to}, "grain");
}

Pattern by_chance(unsigned seed) {
  Chance chance(seed);
  Pattern pattern;
  pattern.name = "PATTERN" + std::to_string(seed);
  pattern.sample_size = "38";
  for (int p = 0; p <= chance.upto(2); ++p) pattern.pieces.push_back(chance.piece("PIECE" + std::to_string(p)));
  return pattern;
}

TEST(DxfProfiles, ReadBackWhatIsWrittenWhateverTheProfile) {
  for (const DxfProfile& profile : dxf_profiles)
    for (unsigned seed = 1; seed <= 12; ++seed) {
      const Pattern pattern = by_chance(seed);
      SheetRules rules;
      rules.width = 3;
      rules.allowances.allowance = seed % 3 == 0 ? 0 : 5e-3 * (seed % 3);
      const CutSheet sheet = with_notches_as_drawn(lay_out(pattern, rules));
      SCOPED_TRACE(std::string(profile.name) + ", seed " + std::to_string(seed));
      const auto read = read_dxf_aama_bytes(dxf_bytes(sheet, profile), "x.dxf");
      ASSERT_TRUE(read.value) << in_words(read.report.findings.front());
      EXPECT_EQ(read.value->sample_size, "38");
      ASSERT_EQ(read.value->pieces.size(), pattern.pieces.size());
      for (const Piece& piece : pattern.pieces) {
        const Piece* same = find_piece(*read.value, piece.name);
        ASSERT_TRUE(same) << piece.name;
        expect_same(piece, *same, profile.plain_notches);
        if (HasFailure()) return;
      }
    }
}

TEST(DxfProfiles, AreFoundByNameAndSaysWhatTheyDo) {
  for (const DxfProfile& profile : dxf_profiles) {
    EXPECT_EQ(find_dxf_profile(profile.name), &profile);
    EXPECT_EQ(profile.says.find("works in"), std::string_view::npos);
  }
  EXPECT_EQ(find_dxf_profile("word"), nullptr);
  EXPECT_EQ(dxf_profiles[0].name, "aama");
}

TEST(DxfProfiles, SayWhatTheyCannotHold) {
  CutSheet sheet = lay_out(by_chance(3));
  Notch castle{.edge = "e0", .at = .5, .kind = NotchKind::castle, .depth = 4e-3, .width = 3e-3};
  sheet.placed[0].cut.piece.notches = {castle};
  const auto says = [&](const char* profile, const std::string& code) {
    for (const Finding& finding : dxf_losses(sheet, *find_dxf_profile(profile)).findings)
      if (finding.code == code) return true;
    return false;
  };
  EXPECT_TRUE(says("lectra", "dxf.notch-kinds"));
  EXPECT_FALSE(says("aama", "dxf.notch-kinds"));
  EXPECT_FALSE(says("aama", "dxf.edge-names"));
  sheet.placed[0].cut.piece.outline[0].id = "hem";
  EXPECT_TRUE(says("aama", "dxf.edge-names"));
}

// Sizes that grow evenly: every point's moves are in the table, none for the sample size, and equal moves share a rule.
TEST(DxfProfiles, PutGradingIntoRules) {
  PatternFile file;
  file.pattern = by_chance(5);
  file.sizes = {"36", "38", "40"};
  for (const double scale : {.95, 1., 1.1}) {
    Pattern size = file.pattern;
    for (Piece& piece : size.pieces)
      for (Edge& edge : piece.outline)
        for (OutlinePoint& point : edge.points) point.at *= scale;
    file.graded.push_back(size);
  }
  const RuledPattern ruled = with_rules(file, "My Rules", *find_dxf_profile("optitex"));
  EXPECT_NE(ruled.table.find("SIZE LIST: 36 38 40\n"), std::string::npos) << ruled.table.substr(0, 300);
  EXPECT_NE(ruled.table.find("GRADE RULE TABLE: My_Rules\n"), std::string::npos);
  EXPECT_NE(ruled.table.find("RULE: DELTA 1\n  0.000, 0.000  0.000, 0.000\n  0.000, 0.000\n"), std::string::npos);
  const OutlinePoint& point = ruled.pattern.pieces[0].outline[0].points[0];
  ASSERT_TRUE(point.grade_rule);
  char expected[128];
  std::snprintf(expected, sizeof expected, "RULE: DELTA %d\n  %.3f, %.3f  0.000, 0.000\n  %.3f, %.3f\n", *point.grade_rule,
                -50 * point.at.x(), -50 * point.at.y(), 100 * point.at.x(), 100 * point.at.y());
  EXPECT_NE(ruled.table.find(expected), std::string::npos) << expected;
  file.graded[0].pieces[0].outline[0].points.pop_back();
  EXPECT_THROW(with_rules(file, "x", dxf_profiles[0]), std::invalid_argument);
}

TEST(DxfProfiles, PassEzdxfsAudit) {
  std::string python;
  for (const std::string& candidate : {std::string("python3"), std::string("/usr/bin/python3")})
    if (python.empty() && std::system((candidate + " -c 'import ezdxf' > /dev/null 2>&1").c_str()) == 0) python = candidate;
  if (python.empty()) GTEST_SKIP() << "python3-ezdxf is not installed";
  const auto folder = std::filesystem::temp_directory_path() / ("toile-profiles-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::string files;
  for (const DxfProfile& profile : dxf_profiles) {
    const auto file = folder / (std::string(profile.name) + ".dxf");
    write_whole_file(file, dxf_bytes(lay_out(by_chance(7)), profile));
    files += " " + file.string();
  }
  // 202, "Deleted SEQEND", is ezdxf's own about any R12 polyline.
  write_whole_file(folder / "audit.py",
                   "import ezdxf, sys\n"
                   "for name in sys.argv[1:]:\n"
                   "    auditor = ezdxf.readfile(name).audit()\n"
                   "    bad = [e.message for e in auditor.errors + auditor.fixes if int(e.code) != 202]\n"
                   "    if bad: sys.exit(name + ': ' + str(bad))\n");
  EXPECT_EQ(std::system((python + " " + (folder / "audit.py").string() + files).c_str()), 0);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace toile
