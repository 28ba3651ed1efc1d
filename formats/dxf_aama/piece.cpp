#include "formats/dxf_aama/piece.h"

#include <algorithm>
#include <cmath>

#include "formats/dxf_aama/allowances.h"
#include "formats/dxf_aama/chains.h"
#include "formats/dxf_aama/net_line.h"
#include "formats/dxf_aama/notches.h"
#include "formats/dxf_aama/turn_points.h"
#include "garment/units.h"

namespace toile::aama {
namespace {

constexpr double on_the_line = 1e-5;  // m, a vertex that does not bend the outline
constexpr double no_edge = 1e-4;      // m, corners nearer than this have no edge between them

// Drops vertices on the fold that are neither corners nor bends, so that a hem across the fold is one straight edge again.
void smooth_fold(Points<2>& ring, std::vector<bool>& turn, const Axis& fold) {
  for (std::size_t i = ring.size(); i-- > 0;) {
    const std::size_t n = ring.size();
    if (n <= 3 || turn[i] || distance_to_axis(ring[i], fold) > same_vertex) continue;
    const Points<2> past{ring[(i + n - 1) % n], ring[(i + 1) % n]};
    if (nearest_on<2>(past, ring[i]).distance > on_the_line) continue;
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    turn.erase(turn.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

// Corners drawn twice a hair apart (some programs do, where two seams are joined) are one corner.
void join_double_corners(Points<2>& ring, std::vector<bool>& turn) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3;) {
    const std::size_t next = (i + 1) % ring.size();
    if (turn[i] && turn[next] && (ring[next] - ring[i]).norm() < no_edge) {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(next));
      turn.erase(turn.begin() + static_cast<std::ptrdiff_t>(next));
    } else {
      ++i;
    }
  }
}

std::optional<int> rule_at(const DrawnPiece& drawn, const Eigen::Vector2d& at) {
  for (const RuleMark& mark : drawn.grade_rules)
    if (mark.role != Role::notch && (mark.at - at).norm() <= drawn.tolerance) return mark.rule;
  return {};
}

std::vector<Edge> edges_of(const Points<2>& ring, const std::vector<bool>& turn, const DrawnPiece& drawn) {
  const std::size_t n = ring.size();
  const bool ccw = signed_area(ring) > 0;
  const auto first = static_cast<std::size_t>(std::find(turn.begin(), turn.end(), true) - turn.begin());
  std::vector<Edge> edges;
  for (std::size_t k = 0; k <= n; ++k) {
    const std::size_t i = ccw ? (first + k) % n : (first + n - k) % n;
    const OutlinePoint point{ring[i], turn[i], rule_at(drawn, ring[i])};
    if (k > 0) edges.back().points.push_back(point);
    if (turn[i] && k < n) {
      Edge edge;
      edge.id = "e" + std::to_string(edges.size());
      edge.points.push_back(point);
      edges.push_back(std::move(edge));
    }
  }
  return edges;
}

void measure_allowances(std::vector<Edge>& outline, const Points<2>& cut, const DrawnPiece& drawn, Report& report) {
  Points<2> sew;
  for (const Edge& edge : outline)
    for (std::size_t i = 1; i < edge.points.size(); ++i) sew.push_back(edge.points[i].at);
  std::string uneven, unknown, facing;
  for (Edge& edge : outline) {
    const Allowance allowance = measured_allowance(positions(edge), sew, cut);
    edge.seam_allowance = allowance.width;
    if (allowance.spread > 1e-3) uneven += " " + edge.id + " (by " + in_mm(allowance.spread) + ")";
    if (!allowance.width) (allowance.faces_itself ? facing : unknown) += " " + edge.id;
  }
  if (!facing.empty())
    report.note("aama.dart-in-outline", drawn.place(), "no allowance of their own have the edges of a dart or slit:" + facing);
  if (!uneven.empty())
    report.note("aama.uneven-allowance", drawn.place(),
                "the allowance is not the same all along:" + uneven + "; its median is kept");
  if (!unknown.empty())
    report.warn("aama.allowance-unknown", drawn.place(), "no cut line within 100 mm of:" + unknown,
                "the cut sheet's own allowance will be used there");
}

void set_quantity(Piece& piece, const DrawnPiece& drawn, Report& report) {
  const PieceTexts& texts = drawn.texts;
  if (texts.quantity_unreadable)
    report.warn("aama.quantity", drawn.place(), "the quantity '" + texts.quantity_text + "' cannot be read; 1 is taken",
                "write it as a number or as right,left");
  if (!texts.quantity) return;
  piece.quantity = *texts.quantity;
  piece.mirrored_quantity = *texts.mirrored;
  if (copies(piece) > 0) return;
  piece.quantity = 1;
  report.note("aama.quantity", drawn.place(), "the quantity is 0; 1 is taken");
}

// Points and rule numbers of the file that are at no point of the outline.
void report_off_outline(const DrawnPiece& drawn, const Points<2>& sew, Report& report) {
  const auto on_sew = [&](const Eigen::Vector2d& at) {
    return std::any_of(sew.begin(), sew.end(), [&](const Eigen::Vector2d& p) { return (p - at).norm() <= drawn.tolerance; });
  };
  const auto points =
      std::count_if(drawn.points.begin(), drawn.points.end(), [&](const MarkedPoint& p) { return !on_sew(p.at); });
  const auto rules =
      std::count_if(drawn.grade_rules.begin(), drawn.grade_rules.end(), [&](const RuleMark& m) { return !on_sew(m.at); });
  const auto listed = static_cast<std::ptrdiff_t>(drawn.points.size());
  const auto ruled = static_cast<std::ptrdiff_t>(drawn.grade_rules.size());
  if (listed > 0 || ruled > 0)
    report.note("aama.points", drawn.place(),
                std::to_string(listed) + " turn and curve points and " + std::to_string(ruled) + " grade rule numbers; " +
                    std::to_string(points) + " and " + std::to_string(rules) + " of them are on other lines than the sew line");
}

void set_grain(Piece& piece, const DrawnPiece& drawn, Report& report) {
  double longest = 1e-4;
  int lines = 0;
  for (const Run& run : drawn.grain) {
    // Of a line with an arrow head, the shaft.
    for (std::size_t i = 1; i < run.points.size(); ++i) {
      const double length = (run.points[i] - run.points[i - 1]).norm();
      if (length <= longest) continue;
      longest = length;
      piece.grainline = Grainline{run.points[i - 1], run.points[i]};
    }
    ++lines;
  }
  if (!piece.grainline)
    report.warn("aama.no-grain-line", drawn.place(), "the piece has no grain line; its y axis is taken as the grain",
                "draw a grain line on layer 7");
  else if (lines > 1)
    report.note("aama.grain-lines", drawn.place(), std::to_string(lines) + " grain lines; the longest is taken");
}

// A line that is drawn more densely on its other layer is taken from there.
void take_dense(std::vector<Run>& lines, const std::vector<Run>& dense) {
  std::vector<bool> taken(dense.size(), false);
  for (Run& line : lines)
    for (std::size_t i = 0; i < dense.size(); ++i) {
      if (taken[i] || dense[i].points.size() <= line.points.size() || dense[i].closed != line.closed) continue;
      const Points<2> finer = dense[i].closed ? closed_polyline(dense[i].points) : dense[i].points;
      if (!std::all_of(line.points.begin(), line.points.end(),
                       [&](const Eigen::Vector2d& p) { return nearest_on<2>(finer, p).distance <= closing_gap; }))
        continue;
      if (!line.closed && (dense[i].points.front() - line.points.front()).norm() > closing_gap) continue;
      taken[i] = true;
      line.points = dense[i].points;
      break;
    }
}

void add_lines(Piece& piece, const std::vector<Run>& runs, bool cut_out) {
  for (const Run& run : runs) {
    Points<2> points = without_repeats(run.points, false);
    if (run.closed && points.size() > 2 && (points.back() - points.front()).norm() > same_vertex)
      points.push_back(points.front());
    if (points.size() > 1) piece.internal_lines.push_back({std::move(points), cut_out});
  }
}

}  // namespace

std::optional<MadePiece> make_piece(DrawnPiece drawn, Report& report) {
  std::optional<NetLine> net = net_line(drawn, report);
  if (!net) return {};
  if (net->sew.size() < 3 || std::abs(signed_area(net->sew)) < 1e-6) {
    report.error("aama.open-outline", drawn.place(), "the outline encloses nothing",
                 "draw the outline as a closed line on layer 1");
    return {};
  }
  take_dense(drawn.internal_lines, drawn.dense_internal_lines);
  take_dense(drawn.cut_outs, drawn.dense_cut_outs);
  drop_notches_on_internal_lines(drawn, net->sew, net->cut, report);
  report_off_outline(drawn, net->sew, report);
  if (net->fold) {
    unfold_details(drawn, *net->fold);
    report.note("aama.unfolded", drawn.place(), "drawn as a half up to its mirror line; read as the whole piece");
  }
  TurnPoints turns = turn_points(net->sew, drawn, net->fold);
  if (net->fold) smooth_fold(net->sew, turns.turn, *net->fold);
  join_double_corners(net->sew, turns.turn);

  if (const std::optional<Eigen::Vector2d> at = crossing(net->sew))
    report.warn("aama.crossing-outline", drawn.place(),
                "the sew line crosses itself near (" + in_mm(at->x(), 2) + ", " + in_mm(at->y(), 2) + ")",
                "such a piece cannot be cut or draped; correct its outline in the pattern program");

  Piece piece;
  piece.name = drawn.name;
  piece.material = drawn.texts.material;
  piece.annotations = drawn.texts.annotations;
  piece.outline = edges_of(net->sew, turns.turn, drawn);
  if (turns.by_angle)
    report.note("aama.turn-points-by-angle", drawn.place(),
                "the file marks no turn points on the sew line; " + std::to_string(piece.outline.size()) + " found by angle");
  set_quantity(piece, drawn, report);
  set_grain(piece, drawn, report);
  if (net->cut) {
    if (signed_area(*net->cut) < 0) std::reverse(net->cut->begin(), net->cut->end());
    measure_allowances(piece.outline, *net->cut, drawn, report);
  }
  piece.notches = placed_notches(drawn, piece.outline, net->cut, report);
  add_lines(piece, drawn.internal_lines, false);
  add_lines(piece, drawn.cut_outs, true);
  piece.drill_holes = drawn.drill_holes;

  PieceFacts facts;
  facts.piece = piece.name;
  facts.has_sew_line = net->source != "cut line";
  facts.sew_line_source = net->source;
  facts.unfolded = net->fold.has_value();
  for (const Edge& edge : piece.outline)
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) facts.graded_points += edge.points[i].grade_rule.has_value();
  return MadePiece{std::move(piece), std::move(facts), net->fold};
}

}  // namespace toile::aama
