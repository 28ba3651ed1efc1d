#pragma once
// A figure for every triangle or vertex of a draped garment, such as its stretch or the air under it, and its colours.

#include <Eigen/Core>
#include <string>

namespace toile {

enum class MapOf { triangle, vertex };

struct GarmentMap {
  std::string name;        // "stretch_warp": stable, for files and keys
  std::string title;       // "stretch along the warp"
  std::string unit;        // in which people read it: "%", "mm", "kPa"
  double unit_size = 1;    // one such unit in SI: .01, 1e-3, 1e3
  bool is_signed = false;  // has a meaning on both sides of 0: shown in two colours
  MapOf of = MapOf::vertex;
  double least_top = 0;     // SI: colours tell no finer differences than on a scale to here,
  double most_top = 1e300;  // and beyond here none at all
  Eigen::VectorXd values;   // SI; one per garment triangle or garment vertex; NaN: none there
  bool operator==(const GarmentMap&) const = default;
};

// What the ends of the colours mean, SI. A signed map's scale is -high .. high.
struct MapScale {
  double low = 0, high = 1;
  bool operator==(const MapScale&) const = default;
};

struct ColouredMap {
  GarmentMap map;
  MapScale scale;
  Eigen::Matrix3Xd colours;  // sRGB 0..1, one column per value
};

}  // namespace toile
