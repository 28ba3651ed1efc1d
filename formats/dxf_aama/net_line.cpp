#include "formats/dxf_aama/net_line.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "formats/dxf_aama/allowances.h"
#include "formats/dxf_aama/bridge.h"
#include "formats/dxf_aama/turn_points.h"
#include "garment/units.h"

namespace toile::aama {
namespace {

std::string in_mm_at(const Eigen::Vector2d& at) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.2f, %.2f) mm", at.x() * mm_per_m, at.y() * mm_per_m);
  return text;
}

// The largest closed chain, or the longest open one when none is closed.
const Chain* principal(const std::vector<Chain>& all) {
  const Chain* best = nullptr;
  const auto size = [](const Chain& chain) {
    return chain.closed ? std::abs(signed_area(chain.points)) : polyline_length<2>(chain.points);
  };
  for (const Chain& chain : all)
    if (!best || (chain.closed && !best->closed) || (chain.closed == best->closed && size(chain) > size(*best))) best = &chain;
  return best;
}

// The whole ring of a chain, unfolded when the piece is a half.
std::optional<Points<2>> ring_of(const Chain& chain, const std::optional<Axis>& fold) {
  if (fold) return unfolded(chain, *fold);
  if (!chain.closed || chain.points.size() < 3) return {};
  return chain.points;
}

// `dense` when it draws the same closed line as `sparse` with more vertices.
std::optional<Points<2>> finer(const std::vector<Run>& dense, const Points<2>& sparse, const std::optional<Axis>& fold) {
  const std::vector<Chain> all = chains(dense);
  const Chain* chain = principal(all);
  if (!chain) return {};
  std::optional<Points<2>> ring = ring_of(*chain, fold);
  if (!ring || ring->size() <= sparse.size()) return {};
  const Points<2> loop = closed_polyline(*ring);
  for (const Eigen::Vector2d& p : sparse)
    if (nearest_on<2>(loop, p).distance > closing_gap) return {};
  return ring;
}

// Whether `sew` goes round with `cut`: nearly all of the cut line has it within the widest hem.
bool goes_round_with(const Points<2>& sew, const Points<2>& cut) {
  constexpr int samples = 200;
  constexpr double widest = 80e-3;  // m
  const Points<2> sew_loop = closed_polyline(sew), cut_loop = closed_polyline(cut);
  int near = 0;
  for (int i = 0; i < samples; ++i)
    near += nearest_on<2>(sew_loop, point_at<2>(cut_loop, double(i) / samples)).distance <= widest;
  return near > .85 * samples;
}

// Whether `ring` runs inside `cut` at 3 .. 50 mm, the same (within 1 mm) along each of its edges.
bool runs_parallel(Points<2> ring, const Points<2>& cut) {
  if (ring.size() < 3 || std::abs(signed_area(ring)) >= std::abs(signed_area(cut)) || !goes_round_with(ring, cut)) return false;
  if (signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  const std::vector<bool> corner = corners_by_angle(ring, 20 * units::degree);
  const auto first = static_cast<std::size_t>(std::find(corner.begin(), corner.end(), true) - corner.begin()) % ring.size();
  double even = 0, all = 0;
  Points<2> edge{ring[first]};
  for (std::size_t i = 1; i <= ring.size(); ++i) {
    const std::size_t at = (first + i) % ring.size();
    edge.push_back(ring[at]);
    if (!corner[at] && i < ring.size()) continue;
    const double length = polyline_length<2>(edge);
    const Allowance allowance = measured_allowance(edge, ring, cut);
    if (allowance.width && *allowance.width >= 3e-3 && *allowance.width <= 50e-3 && allowance.spread <= 1e-3) even += length;
    if (!allowance.faces_itself) all += length;
    edge = {ring[at]};
  }
  return even > .85 * all;
}

// Takes the sew line out of the internal lines; the outermost when several would do.
std::optional<Points<2>> sew_line_on_8(DrawnPiece& piece, const Points<2>& cut, const std::optional<Axis>& fold) {
  std::optional<Points<2>> best;
  std::size_t best_run = 0;
  for (std::size_t i = 0; i < piece.internal_lines.size(); ++i) {
    const std::vector<Chain> chain = chains({piece.internal_lines[i]});
    if (chain.size() != 1) continue;
    const std::optional<Points<2>> ring = ring_of(chain.front(), fold);
    if (!ring || !runs_parallel(*ring, cut)) continue;
    if (best && std::abs(signed_area(*best)) >= std::abs(signed_area(*ring))) continue;
    best = ring;
    best_run = i;
  }
  if (best) piece.internal_lines.erase(piece.internal_lines.begin() + static_cast<std::ptrdiff_t>(best_run));
  return best;
}

void report_open(const DrawnPiece& piece, const Chain& chain, const char* what, Report& report) {
  report.error("aama.open-outline", piece.place(chain.gap_line),
               std::string("the ") + what + " does not close: a gap of " + in_mm(chain.gap, 2) + " from " +
                   in_mm_at(chain.gap_from) + " to " + in_mm_at(chain.gap_to),
               "close the outline in the pattern program and export it again");
}

// Layer 14; nothing, and the reason in `why_not`, when it cannot be used.
std::optional<Points<2>> sew_line_on_14(const DrawnPiece& piece, const std::optional<Points<2>>& cut,
                                        const std::optional<Axis>& fold, std::string& why_not) {
  const std::vector<Chain> parts = chains(piece.sew.empty() ? piece.dense_sew : piece.sew);
  const Chain* chain = principal(parts);
  if (!chain) return {};
  std::optional<Points<2>> sew = ring_of(*chain, fold);
  if (!sew && !fold && cut) sew = bridged(parts, *cut);
  if (!sew) {
    why_not = "the sew line on layer 14 does not close: a gap of " + in_mm(chain->gap, 2) + " from " +
              in_mm_at(chain->gap_from) + " to " + in_mm_at(chain->gap_to);
  } else if (cut && !goes_round_with(*sew, *cut)) {
    why_not = "the line on layer 14 goes round only a part of the piece";
    sew.reset();
  }
  return sew;
}

}  // namespace

std::optional<NetLine> net_line(DrawnPiece& piece, Report& report) {
  NetLine net;
  net.fold = mirror_axis(piece);
  std::vector<Chain> boundary = chains(piece.cut.empty() ? piece.dense_cut : piece.cut);
  const Chain* outline = principal(boundary);
  if (outline) {
    net.cut = ring_of(*outline, net.fold);
    if (!net.cut && net.fold && outline->closed) {
      report.warn("aama.mirror-line", piece.place(), "the mirror line on layer 6 is no edge of the piece; it is read as drawn",
                  "unfold the piece in the pattern program if it is a half");
      net.fold.reset();
      net.cut = ring_of(*outline, net.fold);
    }
    if (!net.cut) {
      report_open(piece, *outline, "outline on layer 1", report);
      return {};
    }
    for (const Chain& other : boundary)
      if (&other != outline) {
        report.warn("aama.second-outline", piece.place(other.line), "a second line on layer 1 is kept as an internal line",
                    "a piece has one boundary; put inner lines on layer 8 or 11");
        piece.internal_lines.push_back({other.points, other.closed, other.line});
      }
    if (std::optional<Points<2>> dense = finer(piece.dense_cut, *net.cut, net.fold)) net.cut = std::move(dense);
  }

  std::string why_not;
  std::optional<Points<2>> sew = sew_line_on_14(piece, net.cut, net.fold, why_not);
  if (sew) {
    net.source = "layer 14";
    if (std::optional<Points<2>> dense = finer(piece.dense_sew, *sew, net.fold)) {
      sew = std::move(dense);
      net.source = "layer 87";
    }
  } else if (net.cut && (sew = sew_line_on_8(piece, *net.cut, net.fold))) {
    net.source = "layer 8";
    report.note("aama.sew-line-on-8", piece.place(),
                "the closed line on layer 8 parallel to the boundary is taken as sew line");
  } else if (net.cut) {
    net.source = "cut line";
    sew = std::move(net.cut);
    net.cut.reset();
    report.warn("aama.no-sew-line", piece.place(),
                (why_not.empty() ? std::string("the file has no sew line for this piece") : why_not) +
                    "; its boundary is taken as the sew line, its seam allowance is unknown",
                "if the boundary is the cut line, export with sew lines (layer 14)");
  } else {
    report.error("aama.open-outline", piece.place(), why_not.empty() ? "the piece has no outline" : why_not,
                 "close the outline in the pattern program and export it again");
    return {};
  }
  net.sew = std::move(*sew);
  return net;
}

}  // namespace toile::aama
