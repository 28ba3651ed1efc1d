#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "drape/dress.h"
#include "drape/guards.h"
#include "formats/formats.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

// By opening, sorted: what it holds, "head", "hand.L", ...
std::vector<std::string> held(const Dressed& dressed) {
  std::vector<std::string> all;
  for (const Opening& opening : dressed.openings) {
    std::string together;
    for (const std::string& limb : opening.limbs) together += (together.empty() ? "" : " ") + limb;
    all.push_back(together);
  }
  std::sort(all.begin(), all.end());
  return all;
}

struct Case {
  const char* file;
  std::vector<std::string> held;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.file; }

class GarmentCode : public testing::TestWithParam<Case> {
 protected:
  static const Body& body() {
    static const Body made = [] {
      const std::filesystem::path folder = std::filesystem::path(std::getenv("TOILE_CORPUS")) / "bodies";
      return make_body(value_or_throw(read_body(folder / "f38_168_A45_wrap.obj", folder / "f38_168_A45.skeleton.json")));
    }();
    return made;
  }
};

TEST_P(GarmentCode, DressesWithEveryLimbWhereItBelongs) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "takes minutes under a sanitizer";
#endif
  if (!std::getenv("TOILE_CORPUS")) GTEST_SKIP() << "TOILE_CORPUS is not set";
  const auto file = std::filesystem::path(std::getenv("TOILE_CORPUS")) / "patterns/garmentcode/mh_f38" / GetParam().file;
  const Pattern pattern = value_or_throw(read_pattern(file));
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .03}));
  const Dressed dressed = dress(pattern, garment, body());
  EXPECT_TRUE(dressed.report.ok()) << (dressed.report.findings.empty() ? "" : in_words(dressed.report.findings[0]));
  EXPECT_EQ(dressed.self_intersections, 0);
  EXPECT_LE(dressed.seam_gap, .5e-3);
  EXPECT_EQ(held(dressed), GetParam().held);
  EXPECT_EQ(inverted_triangles(garment, dressed.positions), 0);
}

INSTANTIATE_TEST_SUITE_P(Cases, GarmentCode,
                         testing::Values(Case{"tshirt.json", {"hand.L", "hand.R", "head", "head hand.L hand.R"}},
                                         Case{"pants_straight.json", {"foot.L", "foot.R", "head hand.L hand.R"}},
                                         Case{"skirt_circle_half.json", {"foot.L foot.R", "head hand.L hand.R"}}));

}  // namespace
}  // namespace toile
