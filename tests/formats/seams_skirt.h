#pragma once
// A little skirt to sew in the tests of seams sidecars.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/seams/seams.h"

namespace toile {

inline Piece polygon(const std::string& name, const std::vector<Eigen::Vector2d>& corners, int quantity = 1, int mirrored = 0) {
  Piece piece;
  piece.name = name;
  piece.quantity = quantity;
  piece.mirrored_quantity = mirrored;
  for (std::size_t k = 0; k < corners.size(); ++k)
    piece.outline.push_back(
        {"e" + std::to_string(k), {{corners[k], true, {}}, {corners[(k + 1) % corners.size()], true, {}}}, {}, false});
  return piece;
}

// Four gores 20 cm wide at the hem and 10 cm at the top, 50 cm high, whose outline begins at the top right; a band 40 x 4 cm.
inline Pattern skirt() {
  Pattern pattern;
  pattern.pieces = {polygon("GORE", {{.15, .5}, {.05, .5}, {0, 0}, {.2, 0}}, 4),
                    polygon("BAND", {{0, 0}, {.4, 0}, {.4, .04}, {0, .04}})};
  pattern.pieces[0].notches = {{"e1", .25, NotchKind::slit, 4e-3, 0}};
  return pattern;
}

inline const std::string pieces = R"([[piece]]
name = "gore"
start = "bottom left"
edges = ["hem", "right", "top", "left"]
[[piece]]
name = "BAND"
edges = ["bottom", "right", "top", "left"]
)";

inline Pattern applied(const std::string& text, Pattern pattern = skirt()) {
  const Report report = apply_seams(pattern, text, "skirt.seams.toml");
  for (const Finding& f : report.findings) EXPECT_NE(f.severity, Severity::error) << in_words(f);
  return pattern;
}

inline Finding first_finding(const std::string& text, Pattern pattern = skirt()) {
  const Pattern before = pattern;
  const Report report = apply_seams(pattern, text, "skirt.seams.toml");
  if (!report.ok()) {
    EXPECT_EQ(pattern, before) << "changed in spite of an error";
  }
  if (report.findings.empty()) {
    ADD_FAILURE() << "no finding for\n" << text;
    return {};
  }
  return report.findings[0];
}

inline std::string one_piece(const std::string& lines) { return "[[piece]]\nname = \"GORE\"\n" + lines; }
inline std::string one_seam(const std::string& lines) { return pieces + "[[seam]]\n" + lines; }

}  // namespace toile
