#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "formats/formats.h"
#include "formats/garmentcode/garmentcode.h"
#include "formats/garmentcode/one_to_one.h"
#include "garment/units.h"

namespace toile {
namespace {

using Json = nlohmann::ordered_json;

constexpr double curve_tolerance = .05e-3;  // m
constexpr double gap = 50e-3;               // m, between pieces that hang nowhere

double cm(double metres) { return metres * cm_per_m; }
Json cm(const Eigen::Vector2d& p) { return {cm(p.x()), cm(p.y())}; }
Json cm(const Eigen::Vector3d& p) { return {cm(p.x()), cm(p.y()), cm(p.z())}; }

// Degrees about x, y and z so that R = Rz Ry Rx.
Json angles(const Eigen::Matrix3d& r) {
  const double b = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
  const bool upright = std::abs(r(2, 0)) > 1 - 1e-12;  // the other two turn about one axis
  const double a = upright ? std::atan2(-r(1, 2), r(1, 1)) : std::atan2(r(2, 1), r(2, 2));
  const double c = upright ? 0 : std::atan2(r(1, 0), r(0, 0));
  return {a / units::degree, b / units::degree, c / units::degree};
}

// In the frame of the edge: along it and to its left.
Json relative(const Eigen::Vector2d& p, const PanelEdge& edge) {
  const Eigen::Vector2d along = edge.points.back() - edge.points.front(), left(-along.y(), along.x());
  const Eigen::Vector2d from = p - edge.points.front();
  return {from.dot(along) / along.squaredNorm(), from.dot(left) / along.squaredNorm()};
}

Json curvature(const PanelEdge& edge) {
  using Kind = FittedCurve::Kind;
  Json params = Json::array();
  if (edge.curve.kind == Kind::circle) {
    params = {cm(edge.curve.radius), edge.curve.large ? 1 : 0, edge.curve.right ? 1 : 0};
    return {{"type", "circle"}, {"params", params}};
  }
  for (const Eigen::Vector2d& p : edge.curve.control) params.push_back(relative(p, edge));
  return {{"type", edge.curve.kind == Kind::quadratic ? "quadratic" : "cubic"}, {"params", params}};
}

Json written(const FlatPanel& panel, const Placement& placement) {
  Json vertices = Json::array(), edges = Json::array();
  const std::size_t n = panel.edges.size();
  for (std::size_t k = 0; k < n; ++k) {
    const PanelEdge& edge = panel.edges[k];
    vertices.push_back(cm(edge.points.front()));
    Json drawn = {{"endpoints", {k, (k + 1) % n}}};
    if (edge.curve.kind != FittedCurve::Kind::line) drawn["curvature"] = curvature(edge);
    const bool number = edge.id == "e" + std::to_string(k);
    if (edge.whole && !number) drawn["label"] = edge.id;
    edges.push_back(std::move(drawn));
  }
  return {{"vertices", vertices},
          {"edges", edges},
          {"translation", cm(placement.translation)},
          {"rotation", angles(placement.rotation)}};
}

void say_losses(const Pattern& pattern, const OneToOne& all, bool unplaced, Report& report) {
  const auto lost = [&](const char* what, const auto& has) {
    std::string names;
    for (const Piece& piece : pattern.pieces)
      if (has(piece)) names += (names.empty() ? "'" : ", '") + piece.name + "'";
    if (!names.empty())
      report.warn(std::string("garmentcode.no-") + what, "pieces " + names,
                  std::string("the format has no ") + what + "s; they are left out", "Keep the pattern as DXF or SVG too");
  };
  const auto any_edge = [](const Piece& piece, const auto& has) {
    return std::any_of(piece.outline.begin(), piece.outline.end(), has);
  };
  lost("notch", [](const Piece& p) { return !p.notches.empty(); });
  lost("drill-hole", [](const Piece& p) { return !p.drill_holes.empty(); });
  lost("internal-line", [](const Piece& p) { return !p.internal_lines.empty(); });
  lost("grain-line", [](const Piece& p) {
    if (!p.grainline) return false;
    const Eigen::Vector2d along = p.grainline->to - p.grainline->from;
    return std::abs(along.x()) > 1e-6 * along.norm();  // what is upright is meant anyway
  });
  lost("text", [](const Piece& p) { return !p.annotations.empty() || !p.material.empty(); });
  lost("seam-allowance",
       [&](const Piece& p) { return any_edge(p, [](const Edge& e) { return e.seam_allowance.has_value(); }); });
  lost("grade-rule", [&](const Piece& p) {
    return any_edge(p, [](const Edge& e) {
      return std::any_of(e.points.begin(), e.points.end(), [](const OutlinePoint& at) { return at.grade_rule.has_value(); });
    });
  });
  if (all.panels.size() > pattern.pieces.size())
    report.note("garmentcode.copies", pattern.name,
                std::to_string(pattern.pieces.size()) + " pieces were written as " + std::to_string(all.panels.size()) +
                    " panels, one for each copy, as the format knows no quantities");
  std::set<std::string> cut;
  for (const FlatPanel& panel : all.panels)
    for (const PanelEdge& edge : panel.edges)
      if (!edge.whole) cut.insert(panel.name + "." + edge.id);
  if (!cut.empty())
    report.note(
        "garmentcode.edges-split", *cut.begin() + (cut.size() > 1 ? " and others" : ""),
        std::to_string(cut.size()) + " edges were split, because a stitch joins two whole edges and an edge is one curve");
  std::string named;
  for (const Seam& seam : pattern.seams)
    if (!seam.name.empty() && seam.name != seam.a.piece + "." + seam.a.edge + " to " + seam.b.piece + "." + seam.b.edge)
      named += (named.empty() ? "'" : ", '") + seam.name + "'";
  if (!named.empty())
    report.note("garmentcode.no-seam-name", "seams " + named, "the format has no names of seams; they are left out");
  if (unplaced)
    report.warn("garmentcode.no-placement", pattern.name,
                "nothing says where the pieces hang round the body; they were laid side by side",
                "Place the panels before they are sewn by a simulator");
}

}  // namespace

std::pair<std::string, Report> garmentcode_text(const Pattern& pattern) {
  Report report;
  const OneToOne all = one_to_one(pattern, curve_tolerance);
  Json panels = Json::object(), order = Json::array(), stitches = Json::array();
  bool unplaced = false;
  double x = 0;
  for (const FlatPanel& panel : all.panels) {
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    const auto copy = static_cast<std::size_t>(panel.copy - 1);
    Placement placement;
    if (copy < piece.placement.size() && piece.placement[copy]) {
      placement = *piece.placement[copy];
    } else {
      unplaced = true;
      double low = 1e300, high = -1e300;
      for (const PanelEdge& edge : panel.edges)
        for (const Eigen::Vector2d& p : edge.points) low = std::min(low, p.x()), high = std::max(high, p.x());
      placement.translation.x() = x - low;
      x += high - low + gap;
    }
    panels[panel.name] = written(panel, placement);
    order.push_back(panel.name);
  }
  for (const Stitch& stitch : all.stitches) {
    const Seam& seam = pattern.seams[static_cast<std::size_t>(stitch.seam)];
    Json written = {{{"panel", all.panels[static_cast<std::size_t>(stitch.panel_a)].name}, {"edge", stitch.edge_a}},
                    {{"panel", all.panels[static_cast<std::size_t>(stitch.panel_b)].name}, {"edge", stitch.edge_b}}};
    if (stitch.same_way) written.push_back("right_wrong");
    stitches.push_back(std::move(written));
    if (stitch.same_way != seam.right_to_wrong)
      report.warn("garmentcode.seam-turned", "seam '" + seam.name + "'",
                  "the directions of its sides say " + std::string(stitch.same_way ? "right to wrong" : "right to right") +
                      " and the seam does not; the directions count",
                  "Check which side lies on which");
  }
  say_losses(pattern, all, unplaced, report);
  const Json root = {{"pattern", {{"panels", panels}, {"stitches", stitches}, {"panel_order", order}}},
                     {"parameters", Json::object()},
                     {"parameter_order", Json::array()},
                     {"properties",
                      {{"curvature_coords", "relative"},
                       {"normalize_panel_translation", false},
                       {"normalized_edge_loops", true},
                       {"units_in_meter", 100}}}};
  return {root.dump(2) + "\n", std::move(report)};
}

Report write_garmentcode(const std::filesystem::path& file, const Pattern& pattern) {
  auto [text, report] = garmentcode_text(pattern);
  write_whole_file(file, text);
  return report;
}

}  // namespace toile
