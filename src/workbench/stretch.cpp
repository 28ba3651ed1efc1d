#include "workbench/stretch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "garment/units.h"

namespace toile {
namespace {

constexpr double near_landmark = 0.06;  // m

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
  return text;
}

// "1.04 m above the floor, near the waist"
std::string in_words(double height, const Mannequin& form) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f m above the floor", height);
  std::pair<double, std::string> nearest{near_landmark, ""};
  for (const auto& [name, at] : form.landmarks) nearest = std::min(nearest, {std::abs(at - height), name});
  std::replace(nearest.second.begin(), nearest.second.end(), '_', ' ');
  return nearest.second.empty() ? text : std::string(text) + ", near the " + nearest.second;
}

}  // namespace

std::vector<PanelStretch> panel_stretches(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions) {
  struct Pulled {
    double strain, area, height;
  };
  std::vector<PanelStretch> stretches;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const Eigen::Vector2d weft(-panel.warp.y(), panel.warp.x());
    std::vector<Pulled> pulled;
    for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
      const Eigen::Vector3i v = panel.triangles.col(t);
      Eigen::Matrix2d rest;
      rest << panel.rest.col(v(1)) - panel.rest.col(v(0)), panel.rest.col(v(2)) - panel.rest.col(v(0));
      const auto at = [&](int k) { return positions.col(garment.welded[p](v(k))); };
      Eigen::Matrix<double, 3, 2> edges;
      edges << at(1) - at(0), at(2) - at(0);
      const Eigen::Matrix<double, 3, 2> gradient = edges * rest.inverse();
      const double longest = std::max((gradient * panel.warp).norm(), (gradient * weft).norm());
      pulled.push_back({longest - 1, std::abs(rest.determinant()) / 2, (at(0) + at(1) + at(2)).y() / 3});
    }
    std::sort(pulled.begin(), pulled.end(), [](const Pulled& a, const Pulled& b) { return a.strain > b.strain; });
    PanelStretch stretch;
    double area = 0, moment = 0;
    for (const Pulled& triangle : pulled) {
      area += triangle.area;
      moment += triangle.area * triangle.height;
      stretch = {triangle.strain, moment / area};
      if (area >= least_area) break;
    }
    stretches.push_back(stretch);
  }
  return stretches;
}

Report stretch_findings(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Fabric& fabric,
                        const Mannequin& form, const std::string& what) {
  const std::vector<PanelStretch> stretches = panel_stretches(garment, positions);
  std::size_t worst = 0;
  for (std::size_t p = 1; p < stretches.size(); ++p)
    if (stretches[p].strain > stretches[worst].strain) worst = p;
  Report report;
  if (stretches.empty() || stretches[worst].strain <= fabric.most_stretch) return report;
  std::string others;
  for (std::size_t p = 0; p < stretches.size(); ++p)
    if (p != worst && stretches[p].strain > fabric.most_stretch)
      others += (others.empty() ? "" : ", ") + garment.panels[p].name + " (" + percent(stretches[p].strain) + ")";
  report.warn("drape.overstretched", what + ", panel '" + garment.panels[worst].name + "'",
              "the cloth is pulled " + percent(stretches[worst].strain) + " longer " + in_words(stretches[worst].height, form) +
                  "; " + fabric.name + " gives " + percent(fabric.most_stretch) + (others.empty() ? "" : ". Also " + others),
              "The garment is too small there: take a larger size, let the panels out, or use cloth that stretches more");
  return report;
}

}  // namespace toile
