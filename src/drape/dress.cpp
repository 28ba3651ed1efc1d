#include "drape/dress.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "collide/intersections.h"
#include "drape/limb_panels.h"
#include "drape/sewing.h"
#include "drape/start.h"
#include "drape/untangle.h"
#include "garment/units.h"

namespace toile {
namespace {

// m above the start with the fewest blocked stitches: cloth that caught on a foot or an arm passes it from elsewhere.
constexpr std::array<double, 3> attempts{0, 0.06, 0.12};
constexpr double through_body = 0.01;   // m
constexpr double mendable_gap = 15e-3;  // m
constexpr double few_stitches = .04;    // of all
constexpr double gathered = 1.35;       // length ratio of a seam from which the longer side is gathers, not ease

double most_gathered(const Pattern& pattern) {
  double most = 1;
  for (const Seam& seam : pattern.seams) {
    const double a = span_length(pattern, seam.a);
    const double b = span_length(pattern, seam.b);
    if (std::min(a, b) > 0) most = std::max(most, std::max(a, b) / std::min(a, b));
  }
  return most;
}

std::string name_of(const Seam& seam) {
  const std::string between =
      "'" + seam.a.piece + "', edge '" + seam.a.edge + "' and '" + seam.b.piece + "', edge '" + seam.b.edge + "'";
  return seam.name.empty() ? "seam of " + between : "seam '" + seam.name + "' of " + between;
}

// Vertices of the loose cloth along a span's edge.
std::set<int> along_edge(const Pattern& pattern, const GarmentMesh& garment, const LoosePanels& cloth, const EdgeSpan& span) {
  std::set<int> vertices;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    if (piece.name != span.piece || panel.copy != span.copy) continue;
    const double low = std::min(span.begin, span.end) - 1e-6;
    const double high = std::max(span.begin, span.end) + 1e-6;
    for (const BoundaryVertex& at : panel.boundary)
      if (piece.outline[static_cast<std::size_t>(at.edge)].id == span.edge && at.at >= low && at.at <= high)
        vertices.insert(cloth.first[p] + at.vertex);
  }
  return vertices;
}

void check_seams(const Pattern& pattern, const GarmentMesh& garment, const LoosePanels& cloth, double closed_gap,
                 std::set<int>& stuck, Dressed& dressed) {
  const auto gaps = stitch_gaps(cloth);
  for (const double gap : gaps) dressed.seam_gap = std::max(dressed.seam_gap, gap);
  if (dressed.seam_gap <= closed_gap) return;
  for (std::size_t s = 0; s < gaps.size(); ++s)
    if (gaps[s] > closed_gap) stuck.insert(cloth.garment_vertex[static_cast<std::size_t>(cloth.stitched[s].front())]);
  for (const Seam& seam : pattern.seams) {
    const auto a = along_edge(pattern, garment, cloth, seam.a);
    const auto b = along_edge(pattern, garment, cloth, seam.b);
    double open = 0;
    for (std::size_t s = 0; s < gaps.size(); ++s) {
      const auto& group = cloth.stitched[s];
      const bool here = std::any_of(group.begin(), group.end(), [&](int v) { return a.count(v) > 0; }) &&
                        std::any_of(group.begin(), group.end(), [&](int v) { return b.count(v) > 0; });
      if (here) open = std::max(open, gaps[s]);
    }
    if (open <= closed_gap) continue;
    dressed.open_seams.push_back(name_of(seam));
    dressed.report.error("drape.seam-open", name_of(seam), "did not come together: " + in_mm(open) + " are left open",
                         "Check the lengths of the seam and where its pieces are placed", Fault::not_converged);
  }
}

void weld(const LoosePanels& cloth, Eigen::Matrix3Xd& positions) {
  positions.setZero();
  Eigen::VectorXd count = Eigen::VectorXd::Zero(positions.cols());
  for (Eigen::Index v = 0; v < cloth.positions.cols(); ++v) {
    const int g = cloth.garment_vertex[static_cast<std::size_t>(v)];
    positions.col(g) += cloth.positions.col(v);
    count(g) += 1;
  }
  for (Eigen::Index g = 0; g < count.size(); ++g) positions.col(g) /= count(g);
}

void check_intersections(const GarmentMesh& garment, std::set<int>& stuck, Dressed& dressed) {
  const auto offsets = triangle_offsets(garment);
  const auto panel_of = [&](int triangle) {
    const auto after = std::upper_bound(offsets.begin(), offsets.end(), triangle);
    return garment.panels[static_cast<std::size_t>(after - offsets.begin() - 1)].name;
  };
  std::map<std::pair<std::string, std::string>, int> between;
  for (const auto& [a, b] : intersecting_triangles(dressed.positions, garment.triangles)) {
    ++dressed.self_intersections;
    ++between[std::minmax(panel_of(a), panel_of(b))];
    for (const int t : {a, b}) stuck.insert(garment.triangles.col(t).begin(), garment.triangles.col(t).end());
  }
  for (const auto& [names, pairs] : between)
    dressed.report.error(
        "drape.self-intersects",
        names.first == names.second ? "piece '" + names.first + "'" : "pieces '" + names.first + "' and '" + names.second + "'",
        "the cloth passes through itself at " + std::to_string(pairs) + " pairs of triangles",
        "Place the pieces farther apart, or use a smaller edge length", Fault::not_converged);
}

// A simulator moves out what is a little inside the body, not what was sewn together through it.
void check_outside(const GarmentMesh& garment, const Body& body, std::set<int>& stuck, Dressed& dressed) {
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    double deepest = 0;
    for (const int v : garment.welded[p]) {
      const double depth = -body.distance.distance(dressed.positions.col(v));
      if (depth > through_body) stuck.insert(v);
      deepest = std::max(deepest, depth);
    }
    if (deepest > through_body)
      dressed.report.error("drape.through-body", "piece '" + garment.panels[p].name + "'",
                           "lies up to " + in_mm(deepest) + " inside the body",
                           "Check where it is placed: its seams can only meet inside the body", Fault::not_converged);
  }
}

// By panel, the hand that must come out where the panel is left open.
std::vector<std::string> sleeves(const Pattern& pattern, const GarmentMesh& garment, const Body& body) {
  std::vector<std::string> hand(garment.panels.size());
  const auto arms = arm_lines(body.form);
  for (std::size_t p = 0; p < hand.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    const auto copy = static_cast<std::size_t>(panel.copy - 1);
    if (copy < piece.placement.size() && piece.placement[copy]) {
      Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Zero(3, panel.rest.cols());
      flat.topRows<2>() = panel.rest;
      const Placement& at = *piece.placement[copy];
      flat = (at.rotation * flat).colwise() + at.translation;
      if (const auto arm = arm_of({flat, at.rotation}, arms, body.form)) hand[p] = "hand" + arms[*arm].name.substr(3);
    } else if (copy < piece.body_part.size() && piece.body_part[copy] && piece.body_part[copy]->part.rfind("arm", 0) == 0) {
      hand[p] = "hand" + piece.body_part[copy]->part.substr(3);
    }
  }
  return hand;
}

void check_worn(const Pattern& pattern, const GarmentMesh& garment, const Body& body, std::set<int>& stuck, Dressed& dressed) {
  dressed.openings = openings(garment, dressed.positions, body.form);
  Report report = check_openings(dressed.openings, garment, sleeves(pattern, garment, body));
  report.append(check_caught(garment, dressed.positions, body.form));
  dressed.links_ok = report.ok();
  for (const Opening& opening : dressed.openings)
    if (std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& finding) {
          return finding.place == opening.name || finding.code == "drape.not-around-body";
        }))
      stuck.insert(opening.loop.begin(), opening.loop.end());
  dressed.report.append(report);
}

// Welds as sewing left them what a few stitches, and only a little, are open at or cross at, and spans the cloth round them
// anew. False when there was nothing to mend, or it did not succeed.
bool mended(const LoosePanels& cloth, const GarmentMesh& garment, const Body& body, const DressOptions& options,
            Eigen::Matrix3Xd& positions) {
  const std::vector<double> gaps = stitch_gaps(cloth);
  std::vector<int> open;
  for (std::size_t s = 0; s < gaps.size(); ++s) {
    if (gaps[s] > mendable_gap) return false;
    if (gaps[s] > options.closed_gap) open.push_back(cloth.garment_vertex[static_cast<std::size_t>(cloth.stitched[s].front())]);
  }
  if (static_cast<double>(open.size()) > few_stitches * static_cast<double>(gaps.size())) return false;
  return untangle(garment, body, options.body_offset, open, positions);
}

Dressed sewn_from(const Start& start, const Pattern& pattern, const GarmentMesh& garment, const Body& body,
                  const DressOptions& options) {
  LoosePanels cloth = loose_panels(garment, start.placed);
  for (const int panel : cloth.panel) cloth.layer.push_back(start.layer[static_cast<std::size_t>(panel)]);
  SewOptions sewing{.shrinking_steps = options.shrinking_steps,
                    .holding_steps = options.holding_steps,
                    .sweeps = options.sweeps,
                    .body_offset = options.body_offset,
                    .closed_gap = options.closed_gap,
                    .unfold = start.narrowed < 1 || start.gathered || start.widened,
                    .progress = options.progress};
  if (most_gathered(pattern) > gathered) {
    sewing.thickness = 1e-3;
    sewing.bending_share = .01;
    sewing.holding_steps *= 2;
  }
  draw_together(sewing, body, cloth);

  Dressed dressed;
  std::set<int> stuck;
  dressed.positions.resize(3, garment.vertex_count);
  weld(cloth, dressed.positions);
  if (!mended(cloth, garment, body, options, dressed.positions))
    check_seams(pattern, garment, cloth, options.closed_gap, stuck, dressed);
  check_intersections(garment, stuck, dressed);
  check_outside(garment, body, stuck, dressed);
  check_worn(pattern, garment, body, stuck, dressed);
  if (!dressed.report.ok()) {
    dressed.stuck = Stuck{{}, {stuck.begin(), stuck.end()}, {}};
    for (std::size_t p = 0; p < garment.panels.size(); ++p)
      dressed.stuck->panels.push_back(cloth.positions.middleCols(cloth.first[p], garment.panels[p].rest.cols()));
    for (const Finding& finding : dressed.report.findings)
      if (finding.severity == Severity::error) dressed.stuck->errors.push_back(finding);
  }
  return dressed;
}

// Fewest wrong openings, then open seams, then intersections.
auto worth(const Dressed& dressed) {
  const auto wrong = std::count_if(dressed.report.findings.begin(), dressed.report.findings.end(), [](const Finding& finding) {
    return finding.code == "drape.linked-wrong" || finding.code == "drape.not-around-body";
  });
  return std::make_tuple(wrong, dressed.open_seams.size(), dressed.self_intersections);
}

}  // namespace

Dressed dress(const Pattern& pattern, const GarmentMesh& garment, const Body& body, const DressOptions& options) {
  std::optional<Dressed> best;
  std::optional<Start> crossed;  // sewing does not untangle what is tangled from the start
  for (const double higher : attempts) {
    Start start = start_positions(pattern, garment, body, higher);
    if (start.intersections > 0) {
      if (!crossed || start.intersections < crossed->intersections) crossed = std::move(start);
      continue;
    }
    Dressed dressed = sewn_from(start, pattern, garment, body, options);
    if (!best || worth(dressed) < worth(*best)) best = std::move(dressed);
    if (best->report.ok()) break;
  }
  return best ? *best : sewn_from(*crossed, pattern, garment, body, options);
}

}  // namespace toile
