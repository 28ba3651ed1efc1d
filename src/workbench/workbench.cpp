#include "workbench/workbench.h"

#include <algorithm>
#include <cstdio>

#include "collide/intersections.h"
#include "collide/without_crossing.h"
#include "drape/dress.h"
#include "edit/loops.h"
#include "garment/units.h"
#include "geometry/topology.h"
#include "triangulate/hems.h"
#include "triangulate/triangulate.h"
#include "workbench/carried_drape.h"
#include "workbench/stretch.h"

namespace toile {
namespace {

constexpr double penetration_limit = 0.5e-3;  // m
constexpr double slip_limit = 30e-3;          // m
constexpr double floor_limit = 5e-3;          // m
constexpr double shaken_tolerance = 3e-3;     // on |unbalanced force| / |weight|
constexpr int most_shakes = 8;
constexpr double still = 0.3e-3;  // m, mean movement of a round

std::string scientific(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", value);
  return text;
}

bool has_hem(const Pattern& pattern) {
  for (const Piece& piece : pattern.pieces)
    for (const Edge& edge : piece.outline)
      if (edge.hem) return true;
  return false;
}

// Marks the edges that the edit loop "hem" runs along.
void mark_hems(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Body& body, Pattern& pattern) {
  std::vector<char> on_hem(static_cast<std::size_t>(garment.vertex_count), 0);
  try {
    for (const VertexLoop& loop : resolve_loops({pattern, garment, positions, body}, "hem", "hem").loops)
      for (const int v : loop) on_hem[static_cast<std::size_t>(v)] = 1;
  } catch (const BadInput&) {
    return;  // no lowest opening: a garment without a hem
  }
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const auto hem_at = [&](std::size_t i) {
      return on_hem[static_cast<std::size_t>(garment.welded[p](panel.boundary[i].vertex))];
    };
    for (std::size_t i = 0; i < panel.boundary.size(); ++i) {
      const std::size_t next = (i + 1) % panel.boundary.size();
      const int edge = panel.boundary[panel.mirrored ? next : i].edge;
      if (hem_at(i) && hem_at(next))
        pattern.pieces[static_cast<std::size_t>(panel.piece)].outline[static_cast<std::size_t>(edge)].hem = true;
    }
  }
}

Worn sewn(const Pattern& pattern, double edge_length) {
  Worn worn;
  worn.pattern = pattern;
  worn.garment = sew(pattern, triangulate(pattern, {.edge_length = edge_length}));
  return worn;
}

// Cloth that holds its bends would keep the creases of sewing. Each round lets go of them where the cloth has come to and lets
// it fall on, until it hardly moves: what it holds in the end are the folds that it falls into by itself.
Drape settled(const Worn& worn, const Scene& scene, const Eigen::Matrix3Xd& start, double tolerance, DrapeControl control) {
  Eigen::Matrix3Xd x = start;
  double seconds = 0, slipped = 0;
  const auto fall = [&](double to) {
    Drape drape = phi(worn.pattern, scene, control)(worn.garment, x, to);
    seconds += drape.seconds;
    slipped += drape.slipped;
    if (control.time_limit) control.time_limit = std::max(0.0, *control.time_limit - drape.seconds);
    return drape;
  };
  const bool shaken = scene.simulator.holds_bends && scene.fabric.bend_friction > 0;
  for (int round = 0; shaken && round < most_shakes; ++round) {
    const Drape drape = fall(shaken_tolerance);
    const double moved = (drape.positions - x).colwise().norm().mean();
    x = drape.positions;
    if (moved < still || !drape.settled) break;
  }
  Drape drape = fall(tolerance);
  drape.seconds = seconds;
  drape.slipped = slipped;
  return drape;
}

void settle(Worn& worn, const Scene& scene, const Eigen::Matrix3Xd& start, double tolerance, const DrapeControl& control) {
  if (!has_hem(worn.pattern)) mark_hems(worn.garment, start, scene.body, worn.pattern);
  worn.drape = settled(worn, scene, start, tolerance, control);
  worn.report.append(drape_findings(worn.drape, tolerance, "source drape"));
  worn.report.append(stretch_findings(worn.garment, worn.drape.positions, scene.fabric, scene.body.form, "source drape"));
}

// What is wrong with the openings at `start`; fills worn.openings and worn.links_ok.
Report linked_at(Worn& worn, const Scene& scene, const Eigen::Matrix3Xd& start) {
  worn.openings = openings(worn.garment, start, scene.body.form);
  Report linked = check_openings(worn.openings, worn.garment, std::vector<std::string>(worn.garment.panels.size()));
  linked.append(check_caught(worn.garment, start, scene.body.form));
  worn.links_ok = linked.ok();
  return linked;
}

}  // namespace

Report drape_findings(const Drape& drape, double tolerance, const std::string& what) {
  Report report;
  if (!drape.settled)
    report.error("drape.not-settled", what,
                 "did not come to rest: residual " + scientific(drape.residual) + " of " + scientific(tolerance),
                 "Its measures are those of the best state found; a stiffer fabric or a looser tolerance settles",
                 Fault::not_converged);
  if (drape.max_penetration > penetration_limit)
    report.error("drape.penetrates", what, "the cloth is " + in_mm(drape.max_penetration) + " inside the body",
                 "Use a smaller edge length, or check that the garment is wide enough for the body", Fault::checks_failed);
  if (drape.inverted_triangles > 0)
    report.warn("drape.inverted", what, std::to_string(drape.inverted_triangles) + " triangles are turned over",
                "Look at the picture: the cloth is crumpled there");
  if (drape.self_intersections > 0)
    report.error("drape.self-intersects", what,
                 "the cloth passes through itself in " + std::to_string(drape.self_intersections) + " pairs of triangles",
                 "Look at the picture; a smaller edge length or another placement of the pieces may come out clear",
                 Fault::checks_failed);
  if (drape.slipped > slip_limit)
    report.warn("drape.slipped", what, "the part that holds the garment dropped by " + in_mm(drape.slipped),
                "The garment is too wide to stay where its pieces were placed");
  const double lowest = drape.positions.cols() > 0 ? drape.positions.row(1).minCoeff() : 0;
  if (lowest < -floor_limit)
    report.warn("drape.below-floor", what,
                "the garment reaches " + in_mm(-lowest, 0) + " below the floor and hangs there freely",
                "It is too long for this body: check the body's height and the pattern's size, or shorten it");
  return report;
}

Simulate phi(const Pattern& pattern, const Scene& scene, const DrapeControl& control) {
  return [&pattern, &scene, control](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double tolerance) {
    return scene.simulator.drape({.garment = with_hems(pattern, garment, scene.hem),
                                  .start = start,
                                  .body = scene.body,
                                  .fabric = scene.fabric,
                                  .tolerance = tolerance,
                                  .time_limit = control.time_limit,
                                  .progress = control.progress,
                                  .stop = control.stop});
  };
}

Worn wear(const Pattern& pattern, const Scene& scene, double edge_length, double tolerance, const DrapeControl& control) {
  Worn worn = sewn(pattern, edge_length);
  DressOptions options;
  options.progress = control.dressing;
  Dressed dressed = dress(pattern, worn.garment, scene.body, options);
  worn.seam_gap = dressed.seam_gap;
  worn.links_ok = dressed.links_ok;
  worn.openings = std::move(dressed.openings);
  worn.report = std::move(dressed.report);
  if (dressed.stuck && control.stuck) control.stuck(worn.garment, *dressed.stuck);
  settle(worn, scene, dressed.positions, tolerance, control);
  return worn;
}

Worn wear_from(const Pattern& pattern, const Scene& scene, double edge_length, double tolerance, const Eigen::Matrix3Xd& start,
               const DrapeControl& control) {
  Worn worn = sewn(pattern, edge_length);
  if (start.cols() != worn.garment.vertex_count)
    throw BadInput({"drape.other-garment", Severity::error, "start",
                    "the earlier drape has " + std::to_string(start.cols()) + " vertices, this garment has " +
                        std::to_string(worn.garment.vertex_count),
                    "Go on with the pattern and edge length that it was made with"});
  worn.report.append(linked_at(worn, scene, start));
  settle(worn, scene, start, tolerance, control);
  return worn;
}

const Pattern& edited_pattern(const Worn& worn, const Target& target) {
  return target.pattern ? *target.pattern : worn.pattern;
}

Worn wear_draped(const Pattern& pattern, const DrapedGarment& draped, const Scene& scene, double edge_length, double tolerance,
                 const DrapeControl& control) {
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = edge_length}));
  return wear_from(pattern, scene, edge_length, tolerance, carried_drape(draped, garment, scene.body), control);
}

WornGarment as_worn(Worn worn, double edge_length) {
  return {std::move(worn.pattern), std::move(worn.garment), std::move(worn.drape.positions), edge_length,
          std::move(worn.report)};
}

namespace {

bool has_layers(const GarmentMesh& garment) {
  const std::vector<MeshEdge> edges = mesh_edges(garment.triangles);
  return std::any_of(edges.begin(), edges.end(), [](const MeshEdge& edge) { return edge.further != -1; });
}

// An edit moves every layer by the body, and close layers through each other: they stay on their sides.
void keep_layers_apart(const GarmentMesh& garment, const Eigen::Matrix3Xd& before, Eigen::Matrix3Xd& positions) {
  if (before.cols() != positions.cols() || !has_layers(garment)) return;
  if (intersecting_triangles(positions, garment.triangles).empty() ||
      !intersecting_triangles(before, garment.triangles).empty())
    return;
  positions = without_crossing(before, positions, garment.triangles);
}

}  // namespace

Target edit(const Worn& worn, const Scene& scene, const std::vector<Edit>& edits) {
  Target target;
  target.garment = worn.garment;
  target.source = target.positions = worn.drape.positions;
  for (const Edit& step : edits) {
    try {
      const Body& body = target.body ? *target.body : scene.body;
      Target next = find_operation(step.operation)
                        .apply({edited_pattern(worn, target), target.garment, target.positions, body, scene.find_body,
                                scene.find_garment},
                               step.arguments);
      next.report.findings.insert(next.report.findings.begin(), target.report.findings.begin(), target.report.findings.end());
      if (!next.body) next.body = target.body;
      if (!next.pattern) {
        keep_layers_apart(next.garment, target.positions, next.positions);
        next.pattern = target.pattern;
        next.source = target.source;
      }
      target = std::move(next);
    } catch (const BadInput& bad) {
      Finding finding = bad.finding();
      finding.place = finding.place.empty() ? step.place : step.place + ", " + finding.place;
      throw BadInput(finding);
    }
  }
  return target;
}

Adjustment adjust_pattern(const Pattern& pattern, const Target& target, const Scene& scene, const AdjustOptions& options,
                          const DrapeControl& control) {
  const MakeCuttable make_cuttable = [&](const RestShape& rest) {
    return rest_on_outlines(redraw(pattern, target.garment, rest).pattern, target.garment, rest);
  };
  return adjust(target, phi(pattern, scene, control), make_cuttable, options);
}

Verified verify(const Pattern& pattern, const Target& target, const RestShape& like, const Scene& scene, double tolerance,
                const DrapeControl& control) {
  Verified verified;
  verified.rest = rest_on_outlines(pattern, target.garment, like);
  verified.drape = phi(pattern, scene, control)(with_rest(target.garment, verified.rest), target.positions, tolerance);
  verified.step = measure(target, verified.rest, verified.drape);
  verified.report = drape_findings(verified.drape, tolerance, "re-drape");
  verified.report.append(stretch_findings(with_rest(target.garment, verified.rest), verified.drape.positions, scene.fabric,
                                          scene.body.form, "re-drape"));
  return verified;
}

}  // namespace toile
