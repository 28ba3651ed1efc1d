#include "formats/dxf_aama/notches.h"

#include <algorithm>
#include <cmath>

#include "formats/dxf_aama/chains.h"
#include "garment/units.h"

namespace toile::aama {
namespace {

constexpr double default_depth = 4e-3;  // m
constexpr double on_line = 0.5e-3;      // m
constexpr double farthest = 60e-3;      // m, of a notch from the sew line: the deepest hem
constexpr double twin = 2e-3;           // m, between the places of one notch drawn on both lines

struct Place {
  std::size_t edge = 0;
  double at = 0;
  double distance = 0;
  double along = 0;  // m, from the start of the outline
};

Points<2> points_of(const Edge& edge) {
  Points<2> points;
  for (const OutlinePoint& point : edge.points) points.push_back(point.at);
  return points;
}

class SewLine {
 public:
  explicit SewLine(const std::vector<Edge>& outline) {
    for (const Edge& edge : outline) {
      edges_.push_back(points_of(edge));
      starts_.push_back(length_);
      length_ += polyline_length<2>(edges_.back());
    }
  }

  double distance_between(const Place& a, const Place& b) const {
    const double d = std::abs(a.along - b.along);
    return std::min(d, length_ - d);
  }

  // A corner belongs to the edge that starts there.
  Place nearest(const Eigen::Vector2d& at) const {
    Place best{0, 0, INFINITY, 0};
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const PolylinePlace place = nearest_on<2>(edges_[i], at);
      const bool corner = place.at < 1e-9 && place.distance < best.distance + 1e-9;
      if (place.distance < best.distance - 1e-9 || corner) best = make(i, place.at, place.distance);
    }
    return normal(best);
  }

  // Where the ray from `at` first meets the line, looking a little back as well.
  std::optional<Place> along_ray(const Eigen::Vector2d& at, const Eigen::Vector2d& direction) const {
    std::optional<Place> best;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const double total = polyline_length<2>(edges_[i]);
      double before = 0;
      for (std::size_t k = 1; k < edges_[i].size(); ++k) {
        const Eigen::Vector2d& a = edges_[i][k - 1];
        const Eigen::Vector2d d = edges_[i][k] - a;
        const double across = direction.x() * d.y() - direction.y() * d.x();
        const Eigen::Vector2d to = a - at;
        const double forward = (to.x() * d.y() - to.y() * d.x()) / across;
        const double t = (to.x() * direction.y() - to.y() * direction.x()) / across;
        const double slack = 1e-6 / std::max(d.norm(), 1e-9);
        if (std::abs(across) > 1e-9 * d.norm() && t >= -slack && t <= 1 + slack && forward >= -on_line &&
            (!best || forward < best->distance - 1e-9))
          best = normal(make(i, (before + std::clamp(t, 0.0, 1.0) * d.norm()) / total, forward));
        before += d.norm();
      }
    }
    return best;
  }

 private:
  Place make(std::size_t edge, double at, double distance) const {
    return {edge, at, distance, starts_[edge] + at * polyline_length<2>(edges_[edge])};
  }
  // The end of an edge is the start of the next.
  Place normal(Place place) const {
    if (place.at > 1 - 1e-9) place = make((place.edge + 1) % edges_.size(), 0, place.distance);
    return place;
  }

  std::vector<Points<2>> edges_;
  std::vector<double> starts_;
  double length_ = 0;
};

double distance_to_lines(const std::vector<Run>& lines, const Eigen::Vector2d& at) {
  double best = INFINITY;
  for (const Run& run : lines)
    if (run.points.size() > 1)
      best = std::min(best, nearest_on<2>(run.closed ? closed_polyline(run.points) : run.points, at).distance);
  return best;
}

struct Candidate {
  Place place;
  DrawnNotch notch;
  bool on_sew = false, on_cut = false;
};

// A notch drawn as a line begins at whichever end is nearer to the cut line.
DrawnNotch from_outside(DrawnNotch notch, const SewLine& sew, const std::optional<Points<2>>& cut) {
  if (!notch.from_line) return notch;
  const auto off = [&](const Eigen::Vector2d& at) { return cut ? distance_to_ring(*cut, at) : sew.nearest(at).distance; };
  const Eigen::Vector2d other = notch.at + notch.depth * notch.direction;
  if (off(other) >= off(notch.at)) return notch;
  notch.at = other;
  notch.direction *= -1;
  return notch;
}

}  // namespace

void drop_notches_on_internal_lines(DrawnPiece& piece, const Points<2>& sew, const std::optional<Points<2>>& cut,
                                    Report& report) {
  const auto on_internal_line_only = [&](const DrawnNotch& notch) {
    return distance_to_ring(sew, notch.at) > on_line && !(cut && distance_to_ring(*cut, notch.at) <= on_line) &&
           distance_to_lines(piece.internal_lines, notch.at) <= on_line;
  };
  for (const DrawnNotch& notch : piece.notches)
    if (on_internal_line_only(notch))
      report.note("aama.notch-on-internal-line", piece.place(notch.line), "a notch on an internal line is left out");
  piece.notches.erase(std::remove_if(piece.notches.begin(), piece.notches.end(), on_internal_line_only), piece.notches.end());
}

std::vector<Notch> placed_notches(const DrawnPiece& piece, const std::vector<Edge>& outline,
                                  const std::optional<Points<2>>& cut, Report& report) {
  const SewLine sew(outline);
  std::vector<Candidate> found;
  int twice = 0;
  for (const DrawnNotch& drawn : piece.notches) {
    const DrawnNotch notch = from_outside(drawn, sew, cut);
    Candidate candidate{sew.nearest(notch.at), notch};
    candidate.on_sew = candidate.place.distance <= on_line;
    candidate.on_cut = cut && distance_to_ring(*cut, notch.at) <= on_line;
    if (!candidate.on_sew && !candidate.on_cut) {
      const bool lost = candidate.place.distance > farthest;
      report.warn("aama.notch-off-outline", piece.place(notch.line),
                  "notch " + in_mm(candidate.place.distance) + " from the outline; " +
                      (lost ? "left out" : "moved to the nearest point of the sew line"),
                  "check the notch in the pattern program");
      if (lost) continue;
    }
    if (!notch.direction.isZero() && !candidate.on_sew)
      if (const std::optional<Place> hit = sew.along_ray(notch.at, notch.direction);
          hit && hit->distance <= 1.5 * candidate.place.distance + on_line)
        candidate.place = *hit;
    // The same notch again: at the end of one run and the start of the next, or on the other line.
    const auto same = std::find_if(found.begin(), found.end(), [&](const Candidate& other) {
      if (other.notch.kind != notch.kind) return false;
      if ((other.notch.at - notch.at).norm() <= piece.tolerance) return true;
      const bool both_lines =
          (other.on_cut && !other.on_sew && candidate.on_sew) || (other.on_sew && candidate.on_cut && !candidate.on_sew);
      return both_lines && sew.distance_between(other.place, candidate.place) <= twin;
    });
    twice += same != found.end();
    if (same == found.end())
      found.push_back(candidate);
    else if (candidate.on_sew && !same->on_sew)
      *same = candidate;
  }

  if (twice > 0)
    report.note("aama.notch-twice", piece.place(),
                std::to_string(twice) + (twice == 1 ? " notch is" : " notches are") +
                    " drawn twice, as cut and sew line have them; read once");

  std::vector<Notch> notches;
  for (const Candidate& c : found)
    notches.push_back(
        {outline[c.place.edge].id, c.place.at, c.notch.kind, c.notch.depth > 0 ? c.notch.depth : default_depth, c.notch.width});
  return notches;
}

}  // namespace toile::aama
