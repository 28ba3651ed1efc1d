#include "workbench/stretch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "body/parametric.h"
#include "cli/templates.h"
#include "formats/formats.h"
#include "workbench/workbench.h"

namespace toile {
namespace {

// A panel of `n` x `n` squares of 2 cm, its grain at `angle` to the y axis, hanging flat at x = 0.
GarmentMesh square(int n, double angle) {
  PanelMesh panel;
  panel.name = "front";
  panel.warp = {-std::sin(angle), std::cos(angle)};
  panel.rest.resize(2, (n + 1) * (n + 1));
  panel.triangles.resize(3, 2 * n * n);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) panel.rest.col(j * (n + 1) + i) << .02 * i, .02 * j;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      panel.triangles.col(2 * (j * n + i)) << a, b, c;
      panel.triangles.col(2 * (j * n + i) + 1) << a, c, d;
    }
  GarmentMesh garment;
  garment.vertex_count = static_cast<int>(panel.rest.cols());
  garment.welded = {Eigen::VectorXi::LinSpaced(garment.vertex_count, 0, garment.vertex_count - 1)};
  garment.triangles = panel.triangles;
  garment.panels = {panel};
  return garment;
}

Eigen::Matrix3Xd hung(const GarmentMesh& garment, const Eigen::Matrix2d& by) {
  Eigen::Matrix3Xd positions = Eigen::Matrix3Xd::Zero(3, garment.vertex_count);
  positions.topRows<2>() = by * garment.panels[0].rest;
  positions.row(1).array() += 1;
  return positions;
}

TEST(Stretch, IsThatAlongTheThreads) {
  Eigen::Matrix2d pull;
  pull << 1.2, 0, 0, .9;
  EXPECT_NEAR(panel_stretches(square(5, 0), hung(square(5, 0), pull))[0].strain, .2, 1e-12);
  EXPECT_NEAR(panel_stretches(square(5, M_PI / 2), hung(square(5, M_PI / 2), pull))[0].strain, .2, 1e-12);
  // On the bias both threads take half of each: sqrt((1.2^2 + .9^2) / 2).
  EXPECT_NEAR(panel_stretches(square(5, M_PI / 4), hung(square(5, M_PI / 4), pull))[0].strain, std::sqrt(1.125) - 1, 1e-12);
}

TEST(Stretch, ShearIsNoStretch) {
  Eigen::Matrix2d shear;
  const double c = std::cos(.3), s = std::sin(.3);
  shear << c, s, s, c;
  EXPECT_NEAR(panel_stretches(square(5, 0), hung(square(5, 0), shear))[0].strain, 0, 1e-12);
}

TEST(Stretch, OfOneOddTriangleDoesNotCount) {
  const GarmentMesh garment = square(10, 0);
  Eigen::Matrix3Xd positions = hung(garment, Eigen::Matrix2d::Identity());
  positions(0, 0) -= .02;
  EXPECT_LT(panel_stretches(garment, positions)[0].strain, 1e-12);
  // Two rows of squares along the lower edge do, and the height is theirs.
  positions = hung(garment, Eigen::Matrix2d::Identity());
  for (int j = 1; j <= 10; ++j)
    for (int i = 0; i <= 10; ++i) positions(1, j * 11 + i) += .006 * std::min(j, 2);
  const PanelStretch strip = panel_stretches(garment, positions)[0];
  EXPECT_NEAR(strip.strain, .3, 1e-9);
  EXPECT_NEAR(strip.height, 1.026, .026);
}

TEST(Stretch, IsSaidWithPanelFigureAndPlace) {
  const GarmentMesh garment = square(5, 0);
  Eigen::Matrix2d pull;
  pull << 1.2, 0, 0, 1;
  Mannequin form;
  form.landmarks = {{"high_hip", 1.06}, {"waist", 1.4}};
  Fabric fabric{.name = "drill", .most_stretch = .21};
  EXPECT_TRUE(stretch_findings(garment, hung(garment, pull), fabric, form, "source drape").findings.empty());
  fabric.most_stretch = .06;
  const Report report = stretch_findings(garment, hung(garment, pull), fabric, form, "source drape");
  ASSERT_EQ(report.findings.size(), 1u);
  const Finding& finding = report.findings[0];
  EXPECT_EQ(finding.code, "drape.overstretched");
  EXPECT_EQ(finding.severity, Severity::warning);
  EXPECT_EQ(finding.place, "source drape, panel 'front'");
  for (const char* words : {"20 %", "6 %", "drill", "high hip"})
    EXPECT_NE(finding.text.find(words), std::string::npos) << words;
  EXPECT_FALSE(finding.remedy.empty());
}

// The sample skirt is drafted for size 38.
TEST(Stretch, ASkirtThatIsTooSmallIsNoticedAndOneThatFitsIsNot) {
  const auto sample = std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / "gored_skirt" / "gored_skirt.dxf";
  const Pattern pattern = value_or_throw(read_pattern(sample));
  const auto overstretched = [&](const char* size) {
    Scene scene;
    scene.fabric = value_or_throw(read_fabric(template_file("fabrics", "cotton_poplin.toml")));
    scene.simulator = find_simulator("fem");
    scene.body =
        make_body(build_mannequin(value_or_throw(read_size_chart_row(template_file("mannequins", "women.csv"), size))));
    std::string said;
    for (const Finding& finding : wear(pattern, scene, .03, 1e-2).report.findings)
      if (finding.code == "drape.overstretched") said += in_words(finding) + "\n";
    return said;
  };
  EXPECT_EQ(overstretched("38"), "");
  EXPECT_NE(overstretched("44"), "");
}

}  // namespace
}  // namespace toile
