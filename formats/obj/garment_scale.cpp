#include "formats/obj/garment_scale.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "garment/units.h"

namespace toile {
namespace {

struct Unit {
  const char* name;
  double metres;
};
constexpr std::array units_of_vertices{Unit{"m", 1}, Unit{"cm", 1e-2}, Unit{"mm", 1e-3}};
constexpr std::array units_of_texture{Unit{"m", 1}, Unit{"cm", 1e-2}, Unit{"mm", 1e-3}, Unit{"inch", 0.0254}};
constexpr double smallest_garment = .15, largest_garment = 3;  // m
constexpr double longest_given = 100;                          // m, in a unit that the user gives
constexpr double one_unit = .03;                               // share by which cloth may have stretched
constexpr double uneven = .1, own_scale = .15, stretched = .08, not_flat = .25;

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

using Weighted = std::vector<std::pair<double, double>>;  // value, weight

double median(Weighted values) {
  std::sort(values.begin(), values.end());
  double whole = 0, sum = 0;
  for (const auto& [value, weight] : values) whole += weight;
  for (const auto& [value, weight] : values)
    if ((sum += weight) >= whole / 2) return value;
  return 1;
}

template <class Act>
void for_triangles(const Island& island, const Eigen::Matrix3Xd& positions, Act act) {
  for (Eigen::Index t = 0; t < island.triangles.cols(); ++t) {
    Eigen::Matrix2d flat;
    Eigen::Matrix<double, 3, 2> hung;
    for (int k = 0; k < 2; ++k) {
      const int a = island.triangles(0, t), b = island.triangles(k + 1, t);
      flat.col(k) = island.flat.col(b) - island.flat.col(a);
      hung.col(k) =
          positions.col(island.vertex[static_cast<std::size_t>(b)]) - positions.col(island.vertex[static_cast<std::size_t>(a)]);
    }
    act(flat, hung);
  }
}

// Lengths of the triangles' sides hanging by their lengths lying, each with its length lying as weight.
Weighted ratios(const Island& island, const Eigen::Matrix3Xd& positions) {
  Weighted all;
  for_triangles(island, positions, [&](const Eigen::Matrix2d& flat, const Eigen::Matrix<double, 3, 2>& hung) {
    for (const Eigen::Vector2d& side : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(1, -1)})
      if (const double lying = (flat * side).norm(); lying > 0) all.emplace_back((hung * side).norm() / lying, lying);
  });
  return all;
}

// What u and v of the texture are in 3D.
Eigen::Vector2d ratios_by_axis(const std::vector<Island>& islands, const Eigen::Matrix3Xd& positions) {
  Weighted u, v;
  for (const Island& island : islands)
    for_triangles(island, positions, [&](const Eigen::Matrix2d& flat, const Eigen::Matrix<double, 3, 2>& hung) {
      const double area = flat.determinant();
      if (!(area > 0)) return;
      const Eigen::Matrix<double, 3, 2> gradient = hung * flat.inverse();
      u.emplace_back(gradient.col(0).norm(), area);
      v.emplace_back(gradient.col(1).norm(), area);
    });
  return {median(u), median(v)};
}

// Mean over the area of the larger of a triangle's two departures from its own size.
double distortion(const Island& island, const Eigen::Matrix3Xd& positions) {
  double sum = 0, whole = 0;
  for_triangles(island, positions, [&](const Eigen::Matrix2d& flat, const Eigen::Matrix<double, 3, 2>& hung) {
    const double area = std::abs(flat.determinant());
    if (!(area > 1e-14)) return;
    const Eigen::Vector2d s = Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>>(hung * flat.inverse()).singularValues();
    sum += area * (s.array() - 1).abs().maxCoeff();
    whole += area;
  });
  return whole > 0 ? sum / whole : 1;
}

// A texture that was fitted to the unit square says nothing of its size.
bool fitted_to_square(const std::vector<Island>& islands) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300), high = -low;
  for (const Island& island : islands) {
    const double side = island.turned_over ? -1 : 1;
    low = low.cwiseMin(Eigen::Vector2d((side * island.flat.row(0)).minCoeff(), island.flat.row(1).minCoeff()));
    high = high.cwiseMax(Eigen::Vector2d((side * island.flat.row(0)).maxCoeff(), island.flat.row(1).maxCoeff()));
  }
  const bool inside = low.minCoeff() >= -1e-6 && high.maxCoeff() <= 1 + 1e-6;
  return inside && high.maxCoeff() > .9;
}

}  // namespace

std::optional<FileUnits> garment_units(const Eigen::Matrix3Xd& positions, std::optional<double> unit_in_metres,
                                       const std::string& place, Report& report) {
  const Eigen::Vector3d low = positions.rowwise().minCoeff(), high = positions.rowwise().maxCoeff();
  const double size = (high - low).maxCoeff();
  std::optional<FileUnits> units;
  if (unit_in_metres) {
    units = FileUnits{"", *unit_in_metres, "override"};
    for (const Unit& unit : units_of_texture)
      if (std::abs(unit.metres / *unit_in_metres - 1) < 1e-9) units->name = unit.name;
  } else {
    // Of two units the larger garment is likelier: 200 is two metres rather than twenty centimetres.
    for (const Unit& unit : units_of_vertices)
      if (!units && size * unit.metres >= smallest_garment && size * unit.metres <= largest_garment)
        units = FileUnits{unit.name, unit.metres, "plausibility"};
    if (!units) {
      char words[96];
      std::snprintf(words, sizeof words, "the garment is %.4g units large, which is no garment in m, cm or mm", size);
      report.error("obj.units", place, words, "say which unit it is: --units m, cm, mm or in", Fault::ambiguous);
      return std::nullopt;
    }
  }
  if (!(size * units->in_metres <= longest_given)) {
    report.error("obj.units", place, "the garment would be " + in_mm(size * units->in_metres, 0) + " large in the unit given",
                 "say which unit it is: --units m, cm, mm or in");
    return std::nullopt;
  }
  report.note("obj.units", place,
              "the garment is " + in_mm(size * units->in_metres, 0) + " large in " +
                  (units->name.empty() ? "the unit given" : units->name) + " (" + units->decided_by + ")");
  const double metres = units->in_metres, below = low.y() * metres;
  if (below < -.1 || high.y() * metres < .25)
    report.warn(
        "obj.not-upright", place,
        "the garment hangs from " + in_mm(high.y() * metres, 0) + " down to " + in_mm(below, 0) + " above the floor (y = 0)",
        "the body has Y up, its floor at y = 0 and faces +Z; export the garment so, or move its body");
  return units;
}

void lay_flat(std::vector<Island>& islands, const Eigen::Matrix3Xd& positions, const std::string& place, Report& report) {
  Eigen::Vector2d scale = ratios_by_axis(islands, positions);
  if (std::abs(scale.x() / scale.y() - 1) > uneven) {
    report.warn("obj.uneven-texture", place,
                "u and v of the texture are of different scale (" + percent(scale.x() / scale.y() - 1) +
                    "); each piece was set right by itself",
                "Export the texture coordinates (UV) without stretching them to a square");
    for (Island& island : islands) island.flat = scale.asDiagonal() * island.flat;
    scale.setOnes();
  } else {
    Weighted all;
    for (const Island& island : islands)
      for (const auto& ratio : ratios(island, positions)) all.push_back(ratio);
    scale.setConstant(median(all));
    std::string known;
    for (const Unit& unit : units_of_texture)
      if (std::abs(scale.x() / unit.metres - 1) < one_unit && !fitted_to_square(islands)) {
        known = std::string("; taken as ") + unit.name + ", the cloth stretched by " + percent(scale.x() / unit.metres - 1);
        scale.setConstant(unit.metres);
      }
    report.note("obj.vt-scale", place,
                "one unit of the texture (vt) is " + in_mm(scale.x(), scale.x() < .1 ? 4 : 1) +
                    " of cloth, by the lengths of edges in 3D and in the texture" + known);
    for (Island& island : islands) island.flat *= scale.x();
  }
  for (Island& island : islands) {
    const std::string where = place + ":" + std::to_string(island.line) + ", piece '" + island.name + "'";
    double far = distortion(island, positions);
    const double own = median(ratios(island, positions));
    if (far > own_scale && std::abs(own - 1) > own_scale) {
      island.flat *= own;
      const double left = distortion(island, positions);
      if (left < std::min(far / 2, stretched)) {
        report.warn("obj.island-scale", where,
                    "the piece has a scale of its own in the texture; it was made " + percent(own - 1) + " larger",
                    "Export all pieces in one scale, if they are");
        far = left;
      } else {
        island.flat /= own;
      }
    }
    if (far > not_flat)
      report.error(
          "obj.not-flat", where,
          "lengths in the texture (vt) differ by " + percent(far) + " from those in 3D: it is not what the piece is cut from",
          "export the garment with the flat pattern as texture coordinates (UV), and without the body");
    else if (far > stretched)
      report.warn("obj.stretched", where, "the cloth is stretched or crumpled by " + percent(far) + " on average",
                  "Check the size of the piece");
  }
}

}  // namespace toile
