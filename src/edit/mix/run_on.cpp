#include "edit/mix/run_on.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "garment/units.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

constexpr double most_turn = 10 * units::degree;
constexpr double rounded = 20e-3;  // m, on either side of the bend
constexpr double same = 1e-9;      // share of an edge

std::size_t before(const Piece& piece, int edge) {
  return (static_cast<std::size_t>(edge) + piece.outline.size() - 1) % piece.outline.size();
}

bool runs_on(const Piece& piece, int edge) {
  const Edge &a = piece.outline[before(piece, edge)], &b = piece.outline[static_cast<std::size_t>(edge)];
  if (piece.outline.size() < 4 || a.hem != b.hem || a.seam_allowance != b.seam_allowance || a.locked || b.locked) return false;
  const Eigen::Vector2d in = direction_at<2>(positions(a), 1), out = direction_at<2>(positions(b), 0);
  return std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out))) < most_turn;
}

// Two edges that become one, and the fraction of it at which they met.
struct Meeting {
  int piece = 0, edge = 0;  // the second edge
  double at = 0.5;
};

struct Side {
  const Meeting* meeting;
  bool second;    // the span lies on the second edge
  bool at_begin;  // it is the span's begin that lies at the meeting
};

std::optional<Side> side_of(const Pattern& pattern, const std::vector<Meeting>& meetings, const EdgeSpan& span, double at) {
  const Piece* piece = find_piece(pattern, span.piece);
  const auto index = static_cast<int>(piece - pattern.pieces.data());
  const auto edge = static_cast<int>(find_edge(*piece, span.edge) - piece->outline.data());
  for (const Meeting& m : meetings) {
    if (m.piece != index) continue;
    const bool second = m.edge == edge;
    if (!second && static_cast<int>(before(*piece, m.edge)) != edge) continue;
    if (std::abs(at - (second ? 0 : 1)) < same) return Side{&m, second, std::abs(at - span.begin) < same};
  }
  return std::nullopt;
}

// Where both sides of a seam run on, at the same fraction of both.
void agree(const Pattern& pattern, std::vector<Meeting>& meetings) {
  constexpr int rounds = 40;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> sum(meetings.size(), 0), count(meetings.size(), 0);
    const auto add = [&](const Meeting* m, double at) {
      sum[static_cast<std::size_t>(m - meetings.data())] += at;
      count[static_cast<std::size_t>(m - meetings.data())] += 1;
    };
    for (const Seam& seam : pattern.seams)
      for (const bool begin : {true, false}) {
        const auto a = side_of(pattern, meetings, seam.a, begin ? seam.a.begin : seam.a.end);
        const auto b = side_of(pattern, meetings, seam.b, begin ? seam.b.begin : seam.b.end);
        if (!a || !b) continue;
        const double at_a = a->meeting->at, at_b = a->second == b->second ? b->meeting->at : 1 - b->meeting->at;
        if (std::abs(at_a - at_b) > 0.02) continue;
        add(a->meeting, (at_a + at_b) / 2);
        add(b->meeting, a->second == b->second ? (at_a + at_b) / 2 : 1 - (at_a + at_b) / 2);
      }
    for (std::size_t i = 0; i < meetings.size(); ++i)
      if (count[i] > 0) meetings[i].at = sum[i] / count[i];
  }
}

// Both edges' points end to end, a parabola in place of the bend.
std::vector<OutlinePoint> rounded_off(const Edge& a, const Edge& b) {
  constexpr int steps = 4;
  const auto first = positions(a), second = positions(b);
  const double reach = std::min({rounded, length(a) / 3, length(b) / 3});
  const Eigen::Vector2d corner = first.back(), way_in = corner - point_at<2>(first, 1 - reach / length(a)),
                        way_out = point_at<2>(second, reach / length(b)) - corner;
  const bool straight = a.points.size() == 2 && b.points.size() == 2 &&
                        std::abs(way_in.x() * way_out.y() - way_in.y() * way_out.x()) < 1e-6 * reach;
  std::vector<OutlinePoint> points;
  if (straight) {
    points = {a.points.front(), b.points.back()};
    return points;
  }
  for (const Eigen::Vector2d& p : part_of<2>(first, 0, 1 - reach / length(a))) points.push_back({p, false, {}});
  for (int i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    points.push_back({corner - (1 - t) * (1 - t) * way_in + t * t * way_out, false, {}});
  }
  for (const Eigen::Vector2d& p : part_of<2>(second, reach / length(b), 1)) points.push_back({p, false, {}});
  points.front() = a.points.front();
  points.back() = b.points.back();
  return points;
}

void apply(Pattern& pattern, GarmentMesh& garment, const Meeting& m) {
  Piece& piece = pattern.pieces[static_cast<std::size_t>(m.piece)];
  const auto first = static_cast<int>(before(piece, m.edge)), second = m.edge;
  const std::string name = piece.outline[static_cast<std::size_t>(first)].id,
                    other = piece.outline[static_cast<std::size_t>(second)].id;
  const auto on_both = [&](bool of_second, double at) { return of_second ? m.at + (1 - m.at) * at : m.at * at; };
  for (Seam& seam : pattern.seams)
    for (EdgeSpan* span : {&seam.a, &seam.b}) {
      if (span->piece != piece.name || (span->edge != name && span->edge != other)) continue;
      const bool of_second = span->edge == other;
      span->begin = on_both(of_second, span->begin);
      span->end = on_both(of_second, span->end);
      span->edge = name;
    }
  for (Notch& notch : piece.notches) {
    if (notch.edge != name && notch.edge != other) continue;
    notch.at = on_both(notch.edge == other, notch.at);
    notch.edge = name;
  }
  Edge& kept = piece.outline[static_cast<std::size_t>(first)];
  kept.points = rounded_off(kept, piece.outline[static_cast<std::size_t>(second)]);
  piece.outline.erase(piece.outline.begin() + second);
  for (PanelMesh& panel : garment.panels) {
    if (panel.piece != m.piece) continue;
    for (BoundaryVertex& v : panel.boundary) {
      if (v.edge == first || v.edge == second) {
        v.at = on_both(v.edge == second, v.at);
        v.edge = first;
      }
      if (v.edge > second) --v.edge;
    }
  }
}

// `next` continues `seam` on both sides, at the same fraction of both.
bool continues(const Seam& seam, const Seam& next) {
  constexpr double alike = 1e-6;
  const auto share = [](const EdgeSpan& a, const EdgeSpan& b) { return (a.end - a.begin) / (b.end - a.begin); };
  const auto one = [](const EdgeSpan& a, const EdgeSpan& b) {
    return a.piece == b.piece && a.copy == b.copy && a.edge == b.edge && std::abs(a.end - b.begin) < same &&
           (a.begin < a.end) == (b.begin < b.end);
  };
  return seam.right_to_wrong == next.right_to_wrong && one(seam.a, next.a) && one(seam.b, next.b) &&
         std::abs(share(seam.a, next.a) - share(seam.b, next.b)) < alike;
}

Seam turned(Seam seam) {
  std::swap(seam.a.begin, seam.a.end);
  std::swap(seam.b.begin, seam.b.end);
  return seam;
}

Seam exchanged(Seam seam) {
  std::swap(seam.a, seam.b);
  return seam;
}

void join_seams(Pattern& pattern, const std::set<std::pair<std::string, std::string>>& edges) {
  std::vector<Seam>& seams = pattern.seams;
  for (std::size_t i = 0; i < seams.size(); ++i)
    for (std::size_t k = 0; k < seams.size(); ++k) {
      if (i == k || !edges.count({seams[i].a.piece, seams[i].a.edge})) continue;
      std::optional<Seam> next;
      for (const Seam& way : {seams[k], turned(seams[k]), exchanged(seams[k]), exchanged(turned(seams[k]))})
        if (!next && continues(seams[i], way)) next = way;
      if (!next) continue;
      seams[i].a.end = next->a.end;
      seams[i].b.end = next->b.end;
      seams.erase(seams.begin() + static_cast<std::ptrdiff_t>(k));
      if (k < i) --i;
      k = static_cast<std::size_t>(-1);
    }
}

}  // namespace

void run_on(Pattern& pattern, GarmentMesh& garment, const std::vector<PieceCorner>& corners) {
  // Of a row of short edges none: which two of them are one is not told by its corners.
  const auto neighbour = [&](const PieceCorner& c) {
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(c.piece)];
    return std::any_of(corners.begin(), corners.end(), [&](const PieceCorner& other) {
      const auto edge = static_cast<std::size_t>(other.edge);
      return other.piece == c.piece &&
             (edge == before(piece, c.edge) || static_cast<std::size_t>(c.edge) == before(piece, other.edge));
    });
  };
  std::vector<PieceCorner> smooth;
  for (const PieceCorner& c : corners)
    if (runs_on(pattern.pieces[static_cast<std::size_t>(c.piece)], c.edge) && !neighbour(c)) smooth.push_back(c);
  std::vector<Meeting> meetings;
  for (const PieceCorner& c : smooth) {
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(c.piece)];
    const double a = length(piece.outline[before(piece, c.edge)]), b = length(piece.outline[static_cast<std::size_t>(c.edge)]);
    meetings.push_back({c.piece, c.edge, a / (a + b)});
  }
  agree(pattern, meetings);
  // From the last edge of a piece on, so that the numbers of those before stay.
  std::sort(meetings.begin(), meetings.end(),
            [](const Meeting& a, const Meeting& b) { return a.piece != b.piece ? a.piece < b.piece : a.edge > b.edge; });
  std::set<std::pair<std::string, std::string>> edges;
  for (const Meeting& m : meetings) {
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(m.piece)];
    edges.emplace(piece.name, piece.outline[before(piece, m.edge)].id);
    apply(pattern, garment, m);
  }
  join_seams(pattern, edges);
}

}  // namespace toile
