#include "measure/girth_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "body/girth.h"
#include "body/landmarks.h"
#include "body/relative.h"
#include "measure/cloth_section.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

constexpr double biceps_share = .55;   // of the upper arm
constexpr double below_crotch = .02;   // m
constexpr double longest_slide = .06;  // m, of the tape on the garment
constexpr double shift_step = 5e-3;    // m

bool is_trunk(const GirthPlace& place) { return place.limb == "trunk"; }

// Points in which the limb itself meets the plane.
std::vector<Vec> crossings(const LimbAxis& axis, const Vec& at, const Vec& normal) {
  std::vector<Vec> points;
  double along = 0;
  for (std::size_t i = 1; i < axis.points.size() && along < axis.body_end - 1e-9; ++i) {
    const Vec &a = axis.points[i - 1], &b = axis.points[i];
    along += (b - a).norm();
    const double from = (a - at).dot(normal), to = (b - at).dot(normal);
    if ((from >= 0) != (to >= 0)) points.push_back(a + from / (from - to) * (b - a));
  }
  return points;
}

// Where other limbs than the one that is taped go through the plane; legs are part of what is taped at the hip.
std::vector<Vec> other_limbs(const std::vector<LimbAxis>& axes, const GirthPlace& place, const Vec& at) {
  std::vector<Vec> others;
  for (const LimbAxis& axis : axes) {
    if (axis.name == place.limb || (is_trunk(place) && axis.name.rfind("arm", 0) != 0)) continue;
    for (const Vec& point : crossings(axis, at, place.along)) others.push_back(point);
  }
  return others;
}

struct Taped {
  double girth = 0, cloth = 0;  // m
};

struct Coverage {
  bool any = false;            // something goes round the limb, perhaps round others too
  std::optional<Taped> alone;  // innermost of what goes round it only
};

Coverage coverage(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const GirthPlace& place, const Vec& at,
                  const std::vector<LimbAxis>& axes) {
  Coverage found;
  const std::vector<Vec> others = other_limbs(axes, place, at);
  for (const ClothSection& section : cloth_sections(garment, positions, at, place.along)) {
    if (!goes_round(section, at, place.along)) continue;
    found.any = true;
    if (std::any_of(others.begin(), others.end(), [&](const Vec& point) { return goes_round(section, point, place.along); }))
      continue;
    SectionLoop points;
    for (const auto& piece : section.pieces) points.insert(points.end(), piece.begin(), piece.end());
    const double girth = loop_girth(points, place.along, GirthKind::tape);
    if (!found.alone || girth < found.alone->girth) found.alone = Taped{girth, section.at_rest};
  }
  return found;
}

// Middle of the loop of the trunk at a height; nothing when no loop crosses the midplane there.
std::optional<Vec> middle_of_trunk(const Mannequin& form, double height) {
  std::optional<Vec> middle;
  double widest = 0;
  for (const SectionLoop& loop : section_loops(form.positions, form.triangles, {0, height, 0}, Vec::UnitY())) {
    Vec low = loop.front(), high = loop.front();
    for (const Vec& p : loop) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const double size = (high - low).x() * (high - low).z();
    if (low.x() >= 0 || high.x() <= 0 || size <= widest) continue;
    widest = size;
    middle = (low + high) / 2;
  }
  return middle;
}

}  // namespace

std::vector<GirthPlace> girth_places(const Mannequin& form) {
  std::map<std::string, double> levels = measured_landmarks(form);
  for (const auto& [name, height] : form.landmarks) levels[name] = height;
  std::vector<GirthPlace> places;
  for (const char* name : {"bust", "waist", "hip"})
    if (const auto level = levels.find(name); level != levels.end())
      if (const auto middle = middle_of_trunk(form, level->second))
        places.push_back({name, *middle, Vec::UnitY(), "trunk", name == std::string("bust") ? longest_slide : 0});
  const std::vector<LimbAxis> axes = limb_axes(form);
  const auto axis_of = [&](const std::string& name) -> const LimbAxis* {
    for (const LimbAxis& axis : axes)
      if (axis.name == name) return &axis;
    return nullptr;
  };
  for (const std::string side : {".L", ".R"})
    if (const LimbAxis* arm = axis_of("arm" + side)) {
      const Vec upper = arm->points[1] - arm->points[0];
      places.push_back({"biceps" + side, arm->points[0] + biceps_share * upper, upper.normalized(), arm->name, longest_slide});
    }
  const auto crotch = levels.find("crotch");
  for (const std::string side : {".L", ".R"})
    if (const LimbAxis* leg = axis_of("leg" + side); leg && crotch != levels.end())
      if (const auto at = crossings(*leg, {0, crotch->second - below_crotch, 0}, Vec::UnitY()); !at.empty())
        places.push_back({"thigh" + side, at.front(), Vec::UnitY(), leg->name, longest_slide});
  return places;
}

GirthRow girth_row(const GirthPlace& place, const GarmentMesh& garment, const Eigen::Matrix3Xd& positions,
                   const Mannequin& form) {
  if (positions.cols() != garment.vertex_count) throw std::invalid_argument("girth_row: one position per garment vertex");
  GirthRow row{.name = place.name, .height = place.at.y(), .garment_height = place.at.y()};
  row.body = is_trunk(place) ? trunk_girth(form.positions, form.triangles, place.at.y())
                             : limb_girth(form.positions, form.triangles, place.at, place.along);
  const std::vector<LimbAxis> axes = limb_axes(form);
  const Vec outwards = std::abs(place.along.y()) > .9999 ? Vec(-Vec::UnitY()) : place.along;
  for (double shift = 0; shift <= place.slide; shift += shift_step) {
    const Vec at = place.at + shift * outwards;
    const Coverage found = coverage(garment, positions, place, at, axes);
    if (!found.any) break;
    if (!found.alone) continue;
    row.garment_height = at.y();
    row.garment = found.alone->girth;
    row.cloth = found.alone->cloth;
    row.ease = row.garment - row.body;
    row.covered = true;
    break;
  }
  return row;
}

std::vector<GirthRow> girth_table(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Mannequin& form) {
  std::vector<GirthRow> rows;
  for (const GirthPlace& place : girth_places(form)) rows.push_back(girth_row(place, garment, positions, form));
  return rows;
}

}  // namespace toile
