#include "formats/dxf/curve_entity.h"

#include <cmath>
#include <map>
#include <numbers>

#include "formats/dxf/entity.h"

namespace toile::dxf {
namespace {

using Eigen::Vector2d;

constexpr double turn = 2 * std::numbers::pi;
constexpr double degree = std::numbers::pi / 180;

// The tags of a curve as lists of numbers by group code.
class Groups {
 public:
  Groups(std::span<const Tag> tags, const Entity& entity, const std::string& name, Report& report) {
    for (const Tag& tag : tags.subspan(1)) {
      const bool point = (tag.code >= 10 && tag.code <= 13) || (tag.code >= 20 && tag.code <= 23);
      if (!point && !(tag.code >= 40 && tag.code <= 52) && tag.code != 230) continue;
      if (const std::optional<double> parsed = number(tag.value)) {
        values_[tag.code].push_back(*parsed);
        continue;
      }
      failed_ = true;
      report.error("dxf.not-a-number", name + ":" + std::to_string(tag.line + 1),
                   "group " + std::to_string(tag.code) + " of a " + entity.type + " on layer " + entity.layer + " is '" +
                       tag.value.substr(0, 40) + "', not a coordinate",
                   "repair the value or export the file again");
    }
  }
  double one(int code, double otherwise) const {
    const auto found = values_.find(code);
    return found == values_.end() ? otherwise : found->second.front();
  }
  bool has(int code) const { return values_.count(code) > 0; }
  const std::vector<double>& all(int code) const {
    static const std::vector<double> none;
    const auto found = values_.find(code);
    return found == values_.end() ? none : found->second;
  }
  // Empty when x and y are not of one number.
  std::vector<Vector2d> points(int code) const {
    const std::vector<double>&x = all(code), &y = all(code + 10);
    std::vector<Vector2d> result;
    if (x.size() == y.size())
      for (std::size_t i = 0; i < x.size(); ++i) result.emplace_back(x[i], y[i]);
    return result;
  }
  bool from_below() const { return one(230, 1) < 0; }
  bool failed() const { return failed_; }

 private:
  std::map<int, std::vector<double>> values_;
  bool failed_ = false;
};

int whole(std::span<const Tag> tags, int code) {
  for (const Tag& tag : tags)
    if (tag.code == code) return whole_number(tag.value).value_or(0);
  return 0;
}

// From `from` counter-clockwise to `to`, radians; the whole round when they are the same.
double sweep_of(double from, double to) {
  double sweep = std::fmod(to - from, turn);
  if (sweep <= 1e-12) sweep += turn;
  return sweep;
}

bool arc(const Groups& groups, Entity& entity) {
  const std::vector<Vector2d> centre = groups.points(10);
  const double radius = groups.one(40, 0);
  if (centre.size() != 1 || !(radius > 0)) return false;
  entity.closed = entity.type == "CIRCLE";
  if (!entity.closed && (!groups.has(50) || !groups.has(51))) return false;
  const double from = entity.closed ? 0 : groups.one(50, 0) * degree;
  const double sweep = entity.closed ? turn : sweep_of(from, groups.one(51, 0) * degree);
  const int parts = static_cast<int>(std::ceil(sweep / (turn / 4) - 1e-9));
  for (int i = 0; i < parts + !entity.closed; ++i) {
    const double at = from + sweep * i / parts;
    entity.points.push_back(centre.front() + radius * Vector2d(std::cos(at), std::sin(at)));
    entity.bulges.push_back(i < parts ? std::tan(sweep / parts / 4) : 0);
  }
  if (groups.from_below()) mirror(entity);
  return true;
}

// Quadratic rational spans of at most a quarter each.
bool ellipse(const Groups& groups, Entity& entity) {
  const std::vector<Vector2d> centre = groups.points(10), major = groups.points(11);
  const double ratio = groups.one(40, 0);
  if (centre.size() != 1 || major.size() != 1 || !(ratio > 0) || major.front().isZero()) return false;
  const double from = groups.one(41, 0), sweep = sweep_of(from, groups.one(42, turn));
  const Vector2d a = major.front();
  const Vector2d b = (groups.from_below() ? -ratio : ratio) * Vector2d(-a.y(), a.x());
  const int parts = static_cast<int>(std::ceil(sweep / (turn / 4) - 1e-9));
  const double half = sweep / parts / 2;
  const auto on = [&](double at, double out) -> Vector2d {
    return centre.front() + out * (std::cos(at) * a + std::sin(at) * b);
  };
  entity.degree = 2;
  entity.knots = {0, 0, 0};
  for (int i = 0; i < parts; ++i) {
    const double at = from + 2 * half * i;
    if (i == 0) entity.points.push_back(on(at, 1)), entity.weights.push_back(1);
    entity.points.push_back(on(at + half, 1 / std::cos(half)));
    entity.weights.push_back(std::cos(half));
    entity.points.push_back(on(at + 2 * half, 1));
    entity.weights.push_back(1);
    for (int k = 0; k < (i + 1 < parts ? 2 : 3); ++k) entity.knots.push_back(i + 1);
  }
  if (sweep > turn - 1e-9) entity.points.back() = entity.points.front();
  return true;
}

// A smooth curve through its fit points (centripetal Catmull-Rom, as cubic spans): what is left of a spline whose control
// points the writer kept to itself.
bool through(const std::vector<Vector2d>& fit, Entity& entity) {
  std::vector<Vector2d> points;
  for (const Vector2d& p : fit)
    if (points.empty() || p != points.back()) points.push_back(p);
  const std::size_t n = points.size();
  if (n < 2) return false;
  const bool ring = n > 3 && points.front() == points.back();
  const auto chord = [&](std::size_t i) { return std::sqrt((points[i + 1] - points[i]).norm()); };
  const auto tangent = [&](std::size_t i, double scale) -> Vector2d {
    std::size_t before = i, after = i;
    if (ring && (i == 0 || i + 1 == n)) {
      before = n - 2, after = 0;
    } else if (i == 0 || i + 1 == n) {
      const std::size_t k = i == 0 ? 0 : n - 2;
      return (points[k + 1] - points[k]) * (scale / chord(k));
    } else {
      before = i - 1;
    }
    const double d1 = chord(before), d2 = chord(after);
    const Vector2d v1 = (points[before + 1] - points[before]) / d1, v2 = (points[after + 1] - points[after]) / d2;
    return (d2 * v1 + d1 * v2) / (d1 + d2) * scale;
  };
  entity.degree = 3;
  entity.points = {points.front()};
  entity.knots = {0, 0, 0, 0};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    entity.points.push_back(points[i] + tangent(i, chord(i)) / 3);
    entity.points.push_back(points[i + 1] - tangent(i + 1, chord(i)) / 3);
    entity.points.push_back(points[i + 1]);
    for (int k = 0; k < (i + 2 < n ? 3 : 4); ++k) entity.knots.push_back(static_cast<double>(i + 1));
  }
  return true;
}

bool spline(const Groups& groups, std::span<const Tag> tags, Entity& entity) {
  entity.points = groups.points(10);
  if (entity.points.empty()) return through(groups.points(11), entity);
  entity.degree = whole(tags, 71);
  entity.knots = groups.all(40);
  entity.weights = groups.all(41);
  const std::size_t n = entity.points.size();
  if (entity.degree < 1 || entity.degree > 15 || n <= static_cast<std::size_t>(entity.degree)) return false;
  if (entity.knots.size() != n + static_cast<std::size_t>(entity.degree) + 1) return false;
  for (std::size_t i = 1; i < entity.knots.size(); ++i)
    if (entity.knots[i] < entity.knots[i - 1]) return false;
  if (entity.weights.size() != n) entity.weights.clear();
  for (const double weight : entity.weights)
    if (!(weight > 1e-9)) return false;
  return true;
}

}  // namespace

bool is_curve(std::string_view type) { return type == "ARC" || type == "CIRCLE" || type == "ELLIPSE" || type == "SPLINE"; }

void read_curve(std::span<const Tag> tags, Entity& entity, const std::string& name, Report& report) {
  for (const Tag& tag : tags)
    if (tag.code == 8) entity.layer = tag.value;
  const Groups groups(tags, entity, name, report);
  if (groups.failed()) return;
  Entity unread = entity;
  unread.kind = Kind::other;
  bool complete = false;
  if (entity.type == "SPLINE")
    complete = spline(groups, tags, entity);
  else if (entity.type == "ELLIPSE")
    complete = ellipse(groups, entity);
  else
    complete = arc(groups, entity);
  if (!complete) entity = unread;
}

}  // namespace toile::dxf
