#include "formats/svg_read/path.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

namespace toile::svg {
namespace {

using Eigen::Vector2d;

class Reader {
 public:
  explicit Reader(std::string_view data) : scan_(data) {}

  PathData read() {
    while (!scan_.at_end() && !data_.broken && !data_.not_finite) {
      const char c = scan_.peek();
      if (std::isalpha(static_cast<unsigned char>(c))) {
        command_ = scan_.take();
        if (data_.parts.empty() && command_ != 'M' && command_ != 'm') return broken();
        if (command_ == 'Z' || command_ == 'z') {
          close();
          continue;
        }
      } else if (command_ == 0 || command_ == 'Z' || command_ == 'z') {
        return broken();
      }
      if (!step()) return broken();
      if (command_ == 'M') command_ = 'L';
      if (command_ == 'm') command_ = 'l';
    }
    return std::move(data_);
  }

 private:
  PathData broken() {
    data_.broken = true;
    data_.at = scan_.place();
    return std::move(data_);
  }

  bool number(double& value) {
    const std::optional<double> found = scan_.number();
    if (!found) return false;
    if (!(std::abs(*found) < 1e300)) data_.not_finite = true;
    value = *found;
    return true;
  }
  bool point(Vector2d& p) {
    if (!number(p.x()) || !number(p.y())) return false;
    if (relative()) p += at_;
    return true;
  }
  bool relative() const { return command_ >= 'a'; }

  void line_to(const Vector2d& p) { add({false, at_, at_, p, p}); }
  void curve_to(const Vector2d& c1, const Vector2d& c2, const Vector2d& p) { add({true, at_, c1, c2, p}); }
  void add(const Segment& segment) {
    if (after_close_) data_.parts.emplace_back();
    after_close_ = false;
    data_.parts.back().segments.push_back(segment);
    at_ = segment.to;
  }
  void close() {
    if (data_.parts.empty() || after_close_) return;
    if ((at_ - start_).norm() > 0) line_to(start_);
    data_.parts.back().closed = true;
    at_ = start_;
    after_close_ = true;
    last_ = 'Z';
  }

  bool step() {
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command_)));
    Vector2d c1, c2, p;
    switch (kind) {
      case 'M':
        if (!point(p)) return false;
        data_.parts.emplace_back();
        after_close_ = false;
        at_ = start_ = p;
        break;
      case 'L':
        if (!point(p)) return false;
        line_to(p);
        break;
      case 'H':
        p = at_;
        if (!number(p.x())) return false;
        if (relative()) p.x() += at_.x();
        line_to(p);
        break;
      case 'V':
        p = at_;
        if (!number(p.y())) return false;
        if (relative()) p.y() += at_.y();
        line_to(p);
        break;
      case 'C':
        if (!point(c1) || !point(c2) || !point(p)) return false;
        curve_to(c1, c2, p);
        control_ = c2;
        break;
      case 'S':
        if (!point(c2) || !point(p)) return false;
        c1 = last_ == 'C' || last_ == 'S' ? Vector2d(2 * at_ - control_) : at_;
        curve_to(c1, c2, p);
        control_ = c2;
        break;
      case 'Q':
      case 'T':
        if (kind == 'Q' && !point(c1)) return false;
        if (!point(p)) return false;
        if (kind == 'T') c1 = last_ == 'Q' || last_ == 'T' ? Vector2d(2 * at_ - control_) : at_;
        control_ = c1;
        curve_to(at_ + 2.0 / 3 * (c1 - at_), p + 2.0 / 3 * (c1 - p), p);
        break;
      case 'A':
        if (!arc()) return false;
        break;
      default:
        return false;
    }
    last_ = kind;
    return true;
  }

  // SVG 1.1, appendix F.6.
  bool arc() {
    Vector2d radii, p;
    double turn = 0;
    if (!number(radii.x()) || !number(radii.y()) || !number(turn)) return false;
    const std::optional<bool> large = scan_.flag();
    const std::optional<bool> sweep = large ? scan_.flag() : std::nullopt;
    if (!sweep || !point(p)) return false;
    radii = radii.cwiseAbs();
    if (data_.not_finite || (p - at_).norm() == 0) return true;
    if (radii.minCoeff() <= 0) {
      line_to(p);
      return true;
    }
    const Eigen::Rotation2Dd rotation(turn * std::numbers::pi / 180);
    const Vector2d half = rotation.inverse() * Vector2d((at_ - p) / 2);
    const double over = half.cwiseQuotient(radii).squaredNorm();
    if (over > 1) radii *= std::sqrt(over);
    const Vector2d unit = half.cwiseQuotient(radii);
    const double q = unit.squaredNorm();
    const double f = std::sqrt(std::max(0.0, (1 - q) / q)) * (*large == *sweep ? -1 : 1);
    const Vector2d centre_unit(f * unit.y(), -f * unit.x());
    const Vector2d centre = rotation * Vector2d(centre_unit.cwiseProduct(radii)) + (at_ + p) / 2;
    const Vector2d a = unit - centre_unit, b = -unit - centre_unit;
    double sweep_angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    if (*sweep && sweep_angle < 0) sweep_angle += 2 * std::numbers::pi;
    if (!*sweep && sweep_angle > 0) sweep_angle -= 2 * std::numbers::pi;
    const double begin = std::atan2(a.y(), a.x());
    // Twelfths of a circle: the cubic is then within 1e-7 radii of the arc.
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep_angle) / (std::numbers::pi / 6) - 1e-9)));
    const double step = sweep_angle / count, handle = 4.0 / 3 * std::tan(step / 4);
    const auto place = [&](const Vector2d& on_unit) -> Vector2d {
      return rotation * Vector2d(on_unit.cwiseProduct(radii)) + centre;
    };
    for (int i = 0; i < count; ++i) {
      const double t0 = begin + i * step, t1 = t0 + step;
      const Vector2d e0(std::cos(t0), std::sin(t0)), e1(std::cos(t1), std::sin(t1));
      const Vector2d n0(-e0.y(), e0.x()), n1(-e1.y(), e1.x());
      curve_to(place(e0 + handle * n0), place(e1 - handle * n1), i + 1 == count ? p : place(e1));
    }
    return true;
  }

  Scanner scan_;
  PathData data_;
  char command_ = 0, last_ = 0;
  bool after_close_ = false;
  Vector2d at_ = Vector2d::Zero(), start_ = Vector2d::Zero(), control_ = Vector2d::Zero();
};

std::string text(double x, double y) {
  char digits[64];
  std::string words;
  for (const double value : {x, y}) {
    words.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    words += ' ';
  }
  return words;
}

}  // namespace

PathData path_of(std::string_view data) { return Reader(data).read(); }

bool is_shape(const Element& element) {
  for (const char* name : {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"})
    if (element.name == name) return true;
  return false;
}

PathData shape_of(const Element& element) {
  const auto value = [&](const char* name) { return user_units(element.get(name)).value_or(0); };
  const std::string& name = element.name;
  if (name == "path") return path_of(element.get("d"));
  if (name == "line") return path_of("M" + text(value("x1"), value("y1")) + "L" + text(value("x2"), value("y2")));
  if (name == "polyline" || name == "polygon") {
    PathData data = path_of("M" + element.get("points"));
    if (name == "polygon" && !data.parts.empty() && !data.parts.front().segments.empty()) {
      SubPath& part = data.parts.front();
      const Vector2d first = part.segments.front().from, last = part.segments.back().to;
      if ((first - last).norm() > 0) part.segments.push_back({false, last, last, first, first});
      part.closed = true;
    }
    return data;
  }
  if (name == "rect") {
    const double x = value("x"), y = value("y"), w = value("width"), h = value("height");
    if (w <= 0 || h <= 0) return {};
    double rx = value("rx"), ry = value("ry");
    if (!element.has("rx")) rx = ry;
    if (!element.has("ry")) ry = rx;
    rx = std::min(rx, w / 2);
    ry = std::min(ry, h / 2);
    if (rx <= 0 || ry <= 0) return path_of("M" + text(x, y) + "L" + text(x + w, y) + text(x + w, y + h) + text(x, y + h) + "Z");
    const std::string round = "A" + text(rx, ry) + "0 0 1 ";
    return path_of("M" + text(x + rx, y) + "L" + text(x + w - rx, y) + round + text(x + w, y + ry) + "L" +
                   text(x + w, y + h - ry) + round + text(x + w - rx, y + h) + "L" + text(x + rx, y + h) + round +
                   text(x, y + h - ry) + "L" + text(x, y + ry) + round + text(x + rx, y) + "Z");
  }
  const double cx = value("cx"), cy = value("cy");
  const double rx = name == "circle" ? value("r") : value("rx"), ry = name == "circle" ? rx : value("ry");
  if (rx <= 0 || ry <= 0) return {};
  const std::string half = "A" + text(rx, ry) + "0 1 1 ";
  return path_of("M" + text(cx - rx, cy) + half + text(cx + rx, cy) + half + text(cx - rx, cy) + "Z");
}

}  // namespace toile::svg
