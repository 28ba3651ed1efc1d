#include "formats/garmentcode/panel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "formats/garmentcode/curves.h"
#include "garment/units.h"

namespace toile {
namespace {

using Json = nlohmann::json;

constexpr double chord_error = 0.05e-3;  // m
constexpr double shortest_edge = 1e-6;   // m, a vertex given twice
constexpr double farthest = 100;         // m, of a coordinate
constexpr double largest_radius = 1e4;   // m; beyond it the centre is lost to rounding

// What is wrong with this panel; becomes one finding.
struct Wrong {
  std::string code, place, text, remedy;
};

template <int N>
Eigen::Matrix<double, N, 1> numbers(const Json& node, const std::string& what, const std::string& place) {
  if (node.is_array() && node.size() == N &&
      std::all_of(node.begin(), node.end(), [](const Json& x) { return x.is_number(); })) {
    Eigen::Matrix<double, N, 1> out;
    for (int i = 0; i < N; ++i) out[i] = node[static_cast<std::size_t>(i)].get<double>();
    return out;
  }
  throw Wrong{"garmentcode.bad-value", place, what + " must be a list of " + std::to_string(N) + " numbers",
              "Export the pattern again, or correct it by hand"};
}

// A place, from file units to metres.
template <int N>
Eigen::Matrix<double, N, 1> in_metres(const Eigen::Matrix<double, N, 1>& at, double metres, const std::string& what,
                                      const std::string& place) {
  const Eigen::Matrix<double, N, 1> out = metres * at;
  if (out.cwiseAbs().maxCoeff() <= farthest) return out;
  throw Wrong{"garmentcode.too-large", place, what + " is more than 100 m away",
              "Check it, and the file's properties.units_in_meter"};
}

const Json& member(const Json& node, const char* key, const std::string& place) {
  if (node.is_object())
    if (const auto found = node.find(key); found != node.end()) return *found;
  throw Wrong{"garmentcode.missing", place, "there is no '" + std::string(key) + "'",
              "A GarmentCode specification has it for every panel"};
}

std::vector<Eigen::Vector2d> read_vertices(const Json& panel, double metres, const std::string& place) {
  const Json& list = member(panel, "vertices", place);
  std::vector<Eigen::Vector2d> vertices;
  if (!list.is_array() || list.size() < 3)
    throw Wrong{"garmentcode.bad-value", place, "'vertices' must be a list of at least three points", "Complete the panel"};
  for (std::size_t i = 0; i < list.size(); ++i)
    vertices.push_back(
        in_metres<2>(numbers<2>(list[i], "vertex " + std::to_string(i), place), metres, "vertex " + std::to_string(i), place));
  return vertices;
}

Eigen::Vector2d control_point(const Json& node, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                              const GarmentCodeUnits& units, const std::string& place) {
  const Eigen::Vector2d p = numbers<2>(node, "a control point", place);
  if (!units.relative_curves) return in_metres<2>(p, units.metres, "a control point", place);
  const Eigen::Vector2d along = to - from, left(-along.y(), along.x());
  return in_metres<2>(from + p.x() * along + p.y() * left, 1, "a control point", place);
}

bool flag(const Json& node, const std::string& place) {
  if (node.is_boolean()) return node.get<bool>();
  if (node.is_number()) return node.get<double>() != 0;
  throw Wrong{"garmentcode.bad-curve", place, "a circle's flags must be 0 or 1", "Write [radius, large_arc, right]"};
}

std::vector<Eigen::Vector2d> points_between(const Json& edge, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                            const GarmentCodeUnits& units, const std::string& place) {
  const auto found = edge.find("curvature");
  if (found == edge.end() || found->is_null()) return {};
  const Json& curvature = *found;
  const auto through = [&](const Json& list) {
    std::vector<Eigen::Vector2d> control{from};
    for (const Json& p : list) control.push_back(control_point(p, from, to, units, place));
    control.push_back(to);
    return bezier_between(control, chord_error);
  };
  if (curvature.is_array()) return through(Json::array({curvature}));
  const auto type = curvature.is_object() ? curvature.find("type") : curvature.end();
  const auto params = curvature.is_object() ? curvature.find("params") : curvature.end();
  if (type == curvature.end() || params == curvature.end() || !type->is_string() || !params->is_array())
    throw Wrong{"garmentcode.bad-curve", place, "'curvature' must have a type and params",
                "Write for example "
                "{\"type\": \"quadratic\", \"params\": [[0.5, 0.1]]}"};
  const std::string name = type->get<std::string>();
  if (name == "quadratic" && params->size() == 1) return through(*params);
  if (name == "cubic" && params->size() == 2) return through(*params);
  if (name == "circle" && params->size() == 3 && (*params)[0].is_number()) {
    const double radius = units.metres * (*params)[0].get<double>();
    const double half = (to - from).norm() / 2;
    if (!(radius <= largest_radius))
      throw Wrong{"garmentcode.bad-curve", place, "the circle's radius is more than 10 km", "Write a straight edge instead"};
    if (!(radius > half * .99))
      throw Wrong{"garmentcode.bad-curve", place,
                  "no circle of radius " + in_mm(radius) + " passes through two points " + in_mm(2 * half) + " apart",
                  "The radius is a length in the file's unit, at least half the distance of the edge's ends"};
    return arc_between(from, to, radius, flag((*params)[1], place), flag((*params)[2], place), chord_error);
  }
  throw Wrong{"garmentcode.bad-curve", place,
              "a curve of type '" + name + "' with " + std::to_string(params->size()) + " params",
              "The types are quadratic (1 point), cubic (2 points) and circle (radius, large_arc, right)"};
}

struct Ends {
  std::size_t from, to;
};

Ends ends_of(const Json& edge, std::size_t vertex_count, const std::string& place) {
  const Json& ends = member(edge, "endpoints", place);
  const auto index = [&](std::size_t i) {
    if (!ends.is_array() || ends.size() != 2 || !ends[i].is_number_integer())
      throw Wrong{"garmentcode.bad-value", place, "'endpoints' must be two vertex numbers", "Write for example [0, 1]"};
    const auto k = ends[i].get<std::int64_t>();
    if (k < 0 || k >= static_cast<std::int64_t>(vertex_count))
      throw Wrong{"garmentcode.unknown-vertex", place, "there is no vertex " + std::to_string(k),
                  "The panel's vertices are 0 to " + std::to_string(vertex_count - 1)};
    return static_cast<std::size_t>(k);
  };
  return {index(0), index(1)};
}

std::vector<Edge> read_outline(const Json& panel, const std::vector<Eigen::Vector2d>& vertices, const GarmentCodeUnits& units,
                               const std::string& place) {
  const Json& edges = member(panel, "edges", place);
  if (!edges.is_array() || edges.size() < 2)
    throw Wrong{"garmentcode.bad-value", place, "'edges' must be a list of at least two edges", "Complete the panel"};
  std::vector<Edge> outline;
  std::vector<Ends> ends;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const std::string edge_place = place + ", edge " + std::to_string(k);
    ends.push_back(ends_of(edges[k], vertices.size(), edge_place));
    const Eigen::Vector2d &from = vertices[ends.back().from], &to = vertices[ends.back().to];
    if ((to - from).norm() < shortest_edge)
      throw Wrong{"garmentcode.short-edge", edge_place, "the edge has no length", "Remove one of its two vertices"};
    Edge edge;
    edge.id = "e" + std::to_string(k);
    edge.points.push_back({from, true, {}});
    for (const Eigen::Vector2d& p : points_between(edges[k], from, to, units, edge_place))
      edge.points.push_back({p, false, {}});
    edge.points.push_back({to, true, {}});
    outline.push_back(std::move(edge));
  }
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const std::size_t next = (k + 1) % ends.size();
    if (ends[k].to != ends[next].from)
      throw Wrong{"garmentcode.open-outline", place + ", edge " + std::to_string(k),
                  "the edge ends at vertex " + std::to_string(ends[k].to) + " but edge " + std::to_string(next) +
                      " starts at vertex " + std::to_string(ends[next].from),
                  "A panel's edges must form one closed loop in the order of the list"};
  }
  return outline;
}

std::string label_of(const Json& edge) {
  const auto label = edge.find("label");
  return label != edge.end() && label->is_string() ? label->get<std::string>() : std::string();
}

bool looks_like_a_number(const std::string& id) {
  return id.size() > 1 && id[0] == 'e' && std::all_of(id.begin() + 1, id.end(), [](char c) { return c >= '0' && c <= '9'; });
}

void take_labels(const Json& edges, std::vector<Edge>& outline) {
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const std::string label = label_of(edges[k]);
    const auto same = std::count_if(edges.begin(), edges.end(), [&](const Json& edge) { return label_of(edge) == label; });
    if (!label.empty() && same == 1 && !looks_like_a_number(label)) outline[k].id = label;
  }
}

// R = Rz Ry Rx of three angles in degrees.
Eigen::Matrix3d turned(const Eigen::Vector3d& angles) {
  const auto about = [](double angle, const Eigen::Vector3d& axis) { return Eigen::AngleAxisd(angle * units::degree, axis); };
  return (about(angles.z(), Eigen::Vector3d::UnitZ()) * about(angles.y(), Eigen::Vector3d::UnitY()) *
          about(angles.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

// Draws a clockwise panel mirrored and turns its placement about its y axis: every 3D point stays.
void show_outside(Piece& piece) {
  if (signed_area(piece) > 0) return;
  for (Edge& edge : piece.outline)
    for (OutlinePoint& point : edge.points) point.at.x() = -point.at.x();
  if (piece.placement.empty()) return;
  Placement& placement = *piece.placement[0];
  placement.rotation = placement.rotation * Eigen::Vector3d(-1, 1, -1).asDiagonal();
}

}  // namespace

std::optional<Piece> read_panel(const Json& panel, const std::string& name, const GarmentCodeUnits& units,
                                const std::string& file, Report& report) {
  const std::string place = file + ", panel '" + name + "'";
  try {
    Piece piece;
    piece.name = name;
    const auto vertices = read_vertices(panel, units.metres, place);
    piece.outline = read_outline(panel, vertices, units, place);
    take_labels(panel["edges"], piece.outline);
    if (std::abs(signed_area(piece)) < shortest_edge * shortest_edge)
      throw Wrong{"garmentcode.no-area", place, "the panel encloses no area", "Check its vertices"};
    const bool placed = panel.contains("rotation") && panel.contains("translation");
    if (placed) {
      const Eigen::Vector3d rotation = numbers<3>(panel["rotation"], "'rotation'", place);
      const Eigen::Vector3d translation = numbers<3>(panel["translation"], "'translation'", place);
      piece.placement = {Placement{turned(rotation), in_metres<3>(translation, units.metres, "'translation'", place)}};
    } else {
      report.warn("garmentcode.no-placement", place,
                  "nothing says where the panel hangs: 'rotation' or 'translation' is missing",
                  "Say where its piece sits on the body in a seams file beside the pattern");
    }
    show_outside(piece);
    return piece;
  } catch (const Wrong& wrong) {
    report.error(wrong.code, wrong.place, wrong.text, wrong.remedy);
    return std::nullopt;
  }
}

}  // namespace toile
