#include "formats/svg/marks.h"

#include "formats/svg/xml_text.h"
#include "garment/units.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double mark_length = 3;  // mm, of a notch that is not to be snipped

std::string pair(const Vector2d& p) { return in_digits(p.x()) + "," + in_digits(p.y()); }

}  // namespace

std::string path_data(const std::vector<Vector2d>& points, bool closed) {
  std::string data;
  for (const Vector2d& point : points) data.append(data.empty() ? "M " : " L ").append(pair(point));
  return closed ? data + " Z" : data;
}

std::string notch_path(const Vector2d& at, const Vector2d& inwards, const Notch& notch) {
  if (notch.depth <= 0) return path_data({at, at - mark_length * inwards}, false);
  const double depth = notch.depth * mm_per_m;
  const double width = notch.width > 0 ? notch.width * mm_per_m : 0.75 * depth;
  const Vector2d deep = at + depth * inwards;
  const Vector2d side = width / 2 * Vector2d(-inwards.y(), inwards.x());
  switch (notch.kind) {
    case NotchKind::slit:
      return path_data({at, deep}, false);
    case NotchKind::v:
      return path_data({at - side, deep, at + side}, false);
    case NotchKind::t:
      return path_data({at, deep}, false) + " " + path_data({deep - side, deep + side}, false);
    case NotchKind::castle:
      return path_data({at - side, deep - side, deep + side, at + side}, false);
    case NotchKind::check:
      return path_data({at, deep, at + 2 * side}, false);
    case NotchKind::u:
      return "M " + pair(at - side) + " C " + pair(at - side + 4.0 / 3 * (deep - at)) + " " +
             pair(at + side + 4.0 / 3 * (deep - at)) + " " + pair(at + side);
  }
  return {};
}

std::string arrow_heads(const Vector2d& from, const Vector2d& to, double size) {
  const Vector2d along = size * (to - from).normalized();
  const Vector2d across = 0.3 * Vector2d(-along.y(), along.x());
  return path_data({from, from + along + across, from + along - across}, true) + " " +
         path_data({to, to - along + across, to - along - across}, true);
}

std::string crossed_circle(const Vector2d& at, double diameter) {
  const double r = diameter / 2;
  const std::string radii = " A " + in_digits(r) + "," + in_digits(r) + " 0 1 0 ";
  const Vector2d x(r, 0), y(0, r);
  return "M " + pair(at - x) + radii + pair(at + x) + radii + pair(at - x) + " Z " +
         path_data({at - 1.5 * x, at + 1.5 * x}, false) + " " + path_data({at - 1.5 * y, at + 1.5 * y}, false);
}

}  // namespace toile
