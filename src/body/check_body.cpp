#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#include "body/body.h"
#include "geometry/topology.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

constexpr double touching = 1e-7;                       // m
constexpr double least_height = .2, most_height = 2.6;  // m

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string point(const Vec& at) { return "(" + number(at[0], 3) + ", " + number(at[1], 3) + ", " + number(at[2], 3) + ")"; }

Vec corner(const Mannequin& form, Eigen::Index triangle, Eigen::Index c) {
  return form.positions.col(form.triangles(c, triangle));
}

Eigen::AlignedBox3d bounds(const Mannequin& form) {
  Eigen::AlignedBox3d box;
  for (Eigen::Index t = 0; t < form.triangles.cols(); ++t)
    for (Eigen::Index c = 0; c < 3; ++c) box.extend(corner(form, t, c));
  return box;
}

bool check_numbers(const Mannequin& form, const std::string& place, Report& report) {
  if (form.positions.cols() == 0 || form.triangles.cols() == 0) {
    report.error("body.empty", place, "the body has no triangles", "export the mesh itself, with its faces");
    return false;
  }
  for (Eigen::Index t = 0; t < form.triangles.cols(); ++t)
    if (form.triangles.col(t).minCoeff() < 0 || form.triangles.col(t).maxCoeff() >= form.positions.cols()) {
      report.error("body.no-such-vertex", place, "triangle " + std::to_string(t + 1) + " names a vertex that is not there",
                   "export the body again");
      return false;
    }
  for (Eigen::Index v = 0; v < form.positions.cols(); ++v)
    if (!form.positions.col(v).allFinite()) {
      report.error("body.not-finite", place, "vertex " + std::to_string(v + 1) + " is not a number or infinite",
                   "export the body again; a modifier or a simulation may have blown it up");
      return false;
    }
  return true;
}

void check_scale(const Mannequin& form, const std::string& place, Report& report) {
  const Vec size = bounds(form).sizes();
  const double tallest = size.maxCoeff();
  if (tallest < least_height || tallest > most_height) {
    struct Unit {
      const char* name;
      double metres;
    };
    Unit best{"", 0};
    double least = std::log(most_height / 1.7);  // further off than this no unit makes a body of it
    for (const Unit unit :
         {Unit{"centimetres", 1e-2}, Unit{"millimetres", 1e-3}, Unit{"inches", .0254}, Unit{"decimetres", .1}})
      if (const double off = std::abs(std::log(tallest * unit.metres / 1.7)); off < least) {
        least = off;
        best = unit;
      }
    const std::string is = "the body is " + number(tallest, 3) + " m tall; a body is between 0.2 and 2.6 m";
    if (best.metres > 0)
      report.error("body.not-in-metres", place, is + "; it seems to be in " + best.name,
                   "scale it by " + number(best.metres, 4) + " and export it in metres");
    else
      report.error("body.not-in-metres", place, is, "scale it to metres");
    return;
  }
  if (size[1] < tallest / 1.5)
    report.error("body.not-upright", place,
                 "the body is " + number(size[1], 2) + " m tall (y) but " + number(tallest, 2) +
                     (size[2] == tallest ? " m deep (z)" : " m wide (x)"),
                 size[2] == tallest ? "export it with Y up; this one seems to have Z up" : "export it standing, with Y up");
  else if (size[1] < least_height)
    report.error("body.not-in-metres", place, "the body is " + number(size[1], 3) + " m tall", "scale it to metres");
}

// Open edges that hang together: the border of one hole.
struct Hole {
  int edges = 0;
  Vec centre = Vec::Zero();
  Eigen::AlignedBox3d box;
};

std::vector<Hole> holes(const Mannequin& form, const std::vector<std::pair<int, int>>& open) {
  Eigen::Matrix3Xi strands(3, static_cast<Eigen::Index>(open.size()));
  for (std::size_t e = 0; e < open.size(); ++e)
    strands.col(static_cast<Eigen::Index>(e)) << open[e].first, open[e].second, open[e].second;
  const std::vector<int> part = components(strands, static_cast<int>(form.positions.cols()));
  std::map<int, Hole> by_part;
  for (const auto& [from, to] : open) {
    Hole& hole = by_part[part[static_cast<std::size_t>(from)]];
    ++hole.edges;
    hole.centre += (form.positions.col(from) + form.positions.col(to)) / 2;
    hole.box.extend(Vec(form.positions.col(from)));
    hole.box.extend(Vec(form.positions.col(to)));
  }
  std::vector<Hole> found;
  for (auto& [unused, hole] : by_part) {
    hole.centre /= hole.edges;
    found.push_back(hole);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Hole& a, const Hole& b) { return a.box.diagonal().norm() > b.box.diagonal().norm(); });
  return found;
}

void say_holes(const Mannequin& form, const std::vector<std::pair<int, int>>& open, const std::string& place, Report& report) {
  const std::vector<Hole> found = holes(form, open);
  for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), 3); ++i) {
    std::string text = "the body has a hole of " + std::to_string(found[i].edges) + " edges, " +
                       number(1e3 * found[i].box.diagonal().norm(), 0) + " mm wide, round " + point(found[i].centre);
    if (i == 2 && found.size() > 3) text += ", and " + std::to_string(found.size() - 3) + " more";
    report.error("body.not-closed", place, text, "fill the hole in a 3D program, or wrap the body with a closed surface");
  }
}

// True when every edge has one triangle on each side, facing the same way.
bool check_closed(const Mannequin& form, const std::string& place, Report& report) {
  std::vector<std::pair<int, int>> sides;
  int flat = 0;
  for (Eigen::Index t = 0; t < form.triangles.cols(); ++t)
    for (Eigen::Index c = 0; c < 3; ++c) {
      sides.emplace_back(form.triangles(c, t), form.triangles((c + 1) % 3, t));
      flat += sides.back().first == sides.back().second;
    }
  if (flat > 0) {
    report.error("body.flat-triangle", place, std::to_string(flat) + " triangles have the same vertex twice",
                 "remove degenerate faces and export again");
    return false;
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::pair<int, int>> open, doubled;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    if (s + 1 < sides.size() && sides[s] == sides[s + 1]) doubled.push_back(sides[s]);
    if (!std::binary_search(sides.begin(), sides.end(), std::pair(sides[s].second, sides[s].first))) open.push_back(sides[s]);
  }
  if (!doubled.empty()) {
    const Vec at = (form.positions.col(doubled[0].first) + form.positions.col(doubled[0].second)) / 2;
    report.error("body.not-oriented", place,
                 "at " + std::to_string(doubled.size()) +
                     " edges neighbouring triangles face opposite ways or more than two meet, the first at " + point(at),
                 "make the normals consistent (outside), and remove doubled and inner faces");
    return false;
  }
  if (!open.empty()) say_holes(form, open, place, report);
  return open.empty();
}

void check_outside(const Mannequin& form, const std::string& place, Report& report) {
  const std::vector<int> part = components(form.triangles, static_cast<int>(form.positions.cols()));
  struct Part {
    double volume = 0;
    Eigen::AlignedBox3d box;
  };
  std::map<int, Part> parts;
  const Vec middle = bounds(form).center();
  for (Eigen::Index t = 0; t < form.triangles.cols(); ++t) {
    Part& mine = parts[part[static_cast<std::size_t>(form.triangles(0, t))]];
    const Vec a = corner(form, t, 0) - middle, b = corner(form, t, 1) - middle, c = corner(form, t, 2) - middle;
    mine.volume += a.dot(b.cross(c)) / 6;
    for (const Vec& p : {a, b, c}) mine.box.extend(p + middle);
  }
  for (const auto& [unused, mine] : parts)
    if (mine.volume <= 0) {
      const std::string what = parts.size() == 1 ? "the body" : "a part of the body round " + point(mine.box.center());
      report.error("body.not-oriented", place, what + " is inside out",
                   "flip its normals so that they point outwards, or delete it if it is an inner wall");
      return;
    }
}

void check_skeleton(const Mannequin& form, const std::string& place, Report& report) {
  if (form.bones.empty()) {
    report.warn(
        "body.no-skeleton", place,
        "the body has no skeleton: edits along sleeves and trouser legs are not possible, the trunk is taken as upright",
        "put NAME.skeleton.json beside the body");
  } else {
    Eigen::AlignedBox3d box = bounds(form);
    const double margin = .1 * box.sizes()[1];
    box.min().array() -= margin;
    box.max().array() += margin;
    for (const Bone& bone : form.bones)
      if (!box.contains(bone.from) || !box.contains(bone.to)) {
        report.error("body.skeleton-elsewhere", place, "bone '" + bone.name + "' lies outside the body, at " + point(bone.from),
                     "use the skeleton that belongs to this body, in the same unit and frame");
        break;
      }
    const Bone *left = find_bone(form, "thigh.L"), *right = find_bone(form, "thigh.R");
    if (left && right && left->from[0] < right->from[0])
      report.error("body.faces-away", place, "the left leg is on the -X side",
                   "turn the body so that it faces +Z, with the wearer's left at +X");
  }
  if (form.landmarks.empty())
    report.warn("body.no-landmarks", place,
                "the body names no landmarks; waist, hip, bust and crotch are measured on its shape",
                "give landmarks_m in NAME.skeleton.json");
}

void check_self_intersections(const Mannequin& form, const std::string& place, Report& report) {
  const TriangleTree tree(form.positions, form.triangles);
  int count = 0;
  Vec first = Vec::Zero();
  for (const MeshEdge& edge : mesh_edges(form.triangles)) {
    const Vec a = form.positions.col(edge.vertex[0]), b = form.positions.col(edge.vertex[1]);
    for (const int t : tree.pierced(a, b)) {
      const Eigen::Vector3i other = form.triangles.col(t);
      if ((other.array() == edge.vertex[0]).any() || (other.array() == edge.vertex[1]).any()) continue;
      // An edge in the plane of the triangle, as on a flat sole, goes through nothing.
      const Vec corner_a = corner(form, t, 0),
                normal = (corner(form, t, 1) - corner_a).cross(corner(form, t, 2) - corner_a).normalized();
      const double above = normal.dot(a - corner_a), below = normal.dot(b - corner_a);
      if (above * below >= 0 || std::min(std::abs(above), std::abs(below)) < touching) continue;
      if (count++ == 0) first = (a + b) / 2;
    }
  }
  if (count > 0)
    report.warn("body.self-intersects", place,
                "the body cuts through itself: " + std::to_string(count) +
                    " edges pass through other triangles, the first at " + point(first),
                "cloth may catch there; wrap the body with a closed surface if a garment touches that place");
}

}  // namespace

Report check_body(const Mannequin& form, const std::string& place, SelfIntersections intersections) {
  Report report;
  if (!check_numbers(form, place, report)) return report;
  check_scale(form, place, report);
  const bool scaled = report.ok();
  if (check_closed(form, place, report)) {
    check_outside(form, place, report);
    if (intersections == SelfIntersections::looked_for) check_self_intersections(form, place, report);
  }
  if (!scaled) return report;
  if (const double floor = bounds(form).min()[1]; std::abs(floor) > .01 * bounds(form).sizes()[1])
    report.warn("body.not-on-floor", place,
                "its lowest point is at y = " + number(floor, 3) + " m; heights are counted from y = 0",
                "move the body so that it stands on y = 0");
  check_skeleton(form, place, report);
  return report;
}

}  // namespace toile
