#include "edit/mix/even_chords.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "draft/alike.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

constexpr int samples = 32;           // of a chord
constexpr double alike_ends = 30e-3;  // m, chords on alike pieces whose ends are this near are meant to be alike
constexpr double corner = 8e-3;       // m, a chord that ends this near to a corner ends in it

bool earlier(const OutlinePlace& a, const OutlinePlace& b) { return a.edge != b.edge ? a.edge < b.edge : a.at < b.at; }

Eigen::Vector2d point_of(const Piece& piece, const OutlinePlace& place) {
  return point_at<2>(positions(piece.outline[static_cast<std::size_t>(place.edge)]), place.at);
}

bool same_cut(const Pattern& pattern, int piece, const std::vector<Chord>& a, const std::vector<Chord>& b) {
  if (a.size() != b.size()) return false;
  const Piece& of = pattern.pieces[static_cast<std::size_t>(piece)];
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].from.edge != b[i].from.edge || a[i].to.edge != b[i].to.edge || a[i].beyond_left != b[i].beyond_left ||
        (point_of(of, a[i].from) - point_of(of, b[i].from)).norm() > alike_ends ||
        (point_of(of, a[i].to) - point_of(of, b[i].to)).norm() > alike_ends)
      return false;
  return true;
}

std::vector<PieceGroup> grouped(const EditInput& input, const Parting& parting) {
  std::vector<PieceGroup> groups;
  for (std::size_t p = 0; p < input.garment.panels.size(); ++p) {
    const PanelMesh& panel = input.garment.panels[p];
    std::vector<Chord> chords = parting.panels[p].chords;
    std::vector<std::pair<Chord, bool>> ordered;
    for (Chord& chord : chords) {
      const bool turn = earlier(chord.to, chord.from);
      chord.points = resample<2>(chord.points, samples);
      if (turn) {
        std::swap(chord.from, chord.to);
        std::reverse(chord.points.begin(), chord.points.end());
        chord.beyond_left = !chord.beyond_left;
      }
      ordered.emplace_back(chord, turn);
    }
    std::sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return earlier(a.first.from, b.first.from); });
    chords.clear();
    std::vector<bool> turned;
    for (const auto& [chord, turn] : ordered) {
      chords.push_back(chord);
      turned.push_back(turn);
    }
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const PieceGroup& group) {
      return group.piece == panel.piece && same_cut(input.pattern, panel.piece, group.chords, chords) &&
             (!chords.empty() || group.beyond == parting.panels[p].beyond);
    });
    const bool fresh = found == groups.end();
    PieceGroup& group = fresh ? groups.emplace_back() : *found;
    if (fresh) {
      group.piece = panel.piece;
      group.beyond = parting.panels[p].beyond;
      group.chords = chords;
    }
    group.copies.push_back(panel.copy);
    group.panels.push_back(static_cast<int>(p));
    group.copy_chords.push_back(std::move(chords));
    group.turned.push_back(std::move(turned));
  }
  for (PieceGroup& group : groups)
    for (std::size_t c = 0; c < group.chords.size(); ++c) {
      Chord& shared = group.chords[c];
      shared.from.at = shared.to.at = 0;
      for (Eigen::Vector2d& point : shared.points) point.setZero();
      const auto count = static_cast<double>(group.copies.size());
      for (const std::vector<Chord>& copy : group.copy_chords) {
        shared.from.at += copy[c].from.at / count;
        shared.to.at += copy[c].to.at / count;
        for (std::size_t i = 0; i < shared.points.size(); ++i) shared.points[i] += copy[c].points[i] / count;
      }
    }
  return groups;
}

// A chord as it lies on the shape that its piece shares with others; each way it may be laid there.
struct Laid {
  PieceGroup* group;
  std::size_t chord;
  std::vector<Eigen::Vector2d> points;
};

void average_alike(const Pattern& pattern, const Likeness& likeness, std::vector<PieceGroup>& groups) {
  std::vector<std::vector<Laid>> by_shape(likeness.shapes.size());
  for (PieceGroup& group : groups)
    for (std::size_t c = 0; c < group.chords.size(); ++c) {
      const Lay& lay = likeness.lays[static_cast<std::size_t>(group.piece)];
      Laid laid{&group, c, {}};
      for (const Eigen::Vector2d& point : group.chords[c].points) laid.points.push_back(lay.to_shape(point));
      by_shape[static_cast<std::size_t>(lay.shape)].push_back(std::move(laid));
    }
  for (std::size_t s = 0; s < by_shape.size(); ++s) {
    const std::vector<Laid>& laid = by_shape[s];
    for (const Laid& own : laid) {
      std::vector<Eigen::Vector2d> sum(own.points.size(), Eigen::Vector2d::Zero());
      double count = 0;
      const auto take = [&](std::vector<Eigen::Vector2d> points) {
        for (int turn = 0; turn < 2; ++turn, std::reverse(points.begin(), points.end()))
          if ((points.front() - own.points.front()).norm() < alike_ends &&
              (points.back() - own.points.back()).norm() < alike_ends) {
            for (std::size_t i = 0; i < points.size(); ++i) sum[i] += points[i];
            ++count;
            return;
          }
      };
      for (const Laid& other : laid) {
        take(other.points);
        if (!likeness.shapes[s].mirror) continue;
        std::vector<Eigen::Vector2d> mirrored = other.points;
        for (Eigen::Vector2d& point : mirrored) point.x() = -point.x();
        take(std::move(mirrored));
      }
      const Isometry back = likeness.lays[static_cast<std::size_t>(own.group->piece)].to_shape.inverse();
      Chord& chord = own.group->chords[own.chord];
      for (std::size_t i = 0; i < sum.size(); ++i) chord.points[i] = back(sum[i] / count);
      const Piece& piece = pattern.pieces[static_cast<std::size_t>(own.group->piece)];
      for (auto* place : {&chord.from, &chord.to}) {
        const Eigen::Vector2d end = place == &chord.from ? chord.points.front() : chord.points.back();
        place->at = nearest_on<2>(positions(piece.outline[static_cast<std::size_t>(place->edge)]), end).at;
      }
    }
  }
}

// Both ends of every seam that is cut draw to the same place on it.
void average_at_seams(const Pattern& pattern, std::vector<PieceGroup>& groups) {
  struct End {
    PieceGroup* group;
    std::size_t chord;
    bool from;
    double sum = 0;
    int count = 0;
  };
  std::vector<End> ends;
  for (PieceGroup& group : groups)
    for (std::size_t c = 0; c < group.chords.size(); ++c)
      for (const bool from : {true, false}) ends.push_back({&group, c, from});
  const auto place = [](const End& end) -> OutlinePlace& {
    Chord& chord = end.group->chords[end.chord];
    return end.from ? chord.from : chord.to;
  };
  const auto on = [&](const EdgeSpan& span) {
    std::vector<std::pair<End*, double>> found;  // and how far along the seam
    const double low = std::min(span.begin, span.end) - 1e-6, high = std::max(span.begin, span.end) + 1e-6;
    for (End& end : ends) {
      const Piece& piece = pattern.pieces[static_cast<std::size_t>(end.group->piece)];
      const OutlinePlace& at = place(end);
      const auto& copies = end.group->copies;
      if (piece.name == span.piece && piece.outline[static_cast<std::size_t>(at.edge)].id == span.edge && at.at >= low &&
          at.at <= high && std::find(copies.begin(), copies.end(), span.copy) != copies.end())
        found.emplace_back(&end, (at.at - span.begin) / (span.end - span.begin));
    }
    return found;
  };
  for (const Seam& seam : pattern.seams) {
    const double length = span_length(pattern, seam.a);
    for (const auto& [a, at_a] : on(seam.a))
      for (const auto& [b, at_b] : on(seam.b)) {
        if (std::abs(at_a - at_b) * length > 2 * alike_ends) continue;
        const double mean = (at_a + at_b) / 2;
        a->sum += seam.a.begin + mean * (seam.a.end - seam.a.begin);
        b->sum += seam.b.begin + mean * (seam.b.end - seam.b.begin);
        ++a->count;
        ++b->count;
      }
  }
  for (const End& end : ends)
    if (end.count > 0) place(end).at = end.sum / end.count;
}

void end_at_corners(const Pattern& pattern, std::vector<PieceGroup>& groups) {
  for (PieceGroup& group : groups)
    for (Chord& chord : group.chords)
      for (OutlinePlace* place : {&chord.from, &chord.to}) {
        const double length =
            toile::length(pattern.pieces[static_cast<std::size_t>(group.piece)].outline[static_cast<std::size_t>(place->edge)]);
        if (place->at * length < corner) place->at = 0;
        if ((1 - place->at) * length < corner) place->at = 1;
      }
}

// The points between moved as the ends have been.
void follow_ends(const Pattern& pattern, std::vector<PieceGroup>& groups) {
  for (PieceGroup& group : groups)
    for (Chord& chord : group.chords) {
      const Piece& piece = pattern.pieces[static_cast<std::size_t>(group.piece)];
      const Eigen::Vector2d first = point_of(piece, chord.from) - chord.points.front();
      const Eigen::Vector2d last = point_of(piece, chord.to) - chord.points.back();
      for (std::size_t i = 0; i < chord.points.size(); ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(chord.points.size() - 1);
        chord.points[i] += (1 - t) * first + t * last;
      }
    }
}

}  // namespace

std::vector<PieceGroup> even_chords(const EditInput& input, const Parting& parting) {
  constexpr int rounds = 60;  // of drawing together; what is left halves with each
  std::vector<PieceGroup> groups = grouped(input, parting);
  const Likeness likeness = find_likeness(input.pattern, 1e-4);
  for (int round = 0; round < rounds; ++round) {
    follow_ends(input.pattern, groups);
    average_alike(input.pattern, likeness, groups);
    average_at_seams(input.pattern, groups);
  }
  end_at_corners(input.pattern, groups);
  follow_ends(input.pattern, groups);
  for (PieceGroup& group : groups)
    for (Chord& chord : group.chords) chord.points = smooth_curve(chord.points);
  return groups;
}

std::vector<Eigen::Vector2d> smooth_curve(const std::vector<Eigen::Vector2d>& points) {
  constexpr double straight = 1.5e-3, near = 2e-3;  // m
  constexpr int drawn = 12, most = 8;
  const Eigen::Vector2d first = points.front(), last = points.back();
  const auto n = static_cast<Eigen::Index>(points.size());
  double bent = 0;
  for (const Eigen::Vector2d& point : points) bent = std::max(bent, nearest_on<2>({first, last}, point).distance);
  if (bent < straight) return {first, last};
  // Polynomials of the arc length that vanish at both ends, added to the straight line.
  Eigen::Matrix2Xd off(2, n);
  Eigen::VectorXd at(n);
  double along = 0;
  const double length = polyline_length<2>(points);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (i > 0) along += (points[static_cast<std::size_t>(i)] - points[static_cast<std::size_t>(i - 1)]).norm();
    at(i) = along / length;
    off.col(i) = points[static_cast<std::size_t>(i)] - ((1 - at(i)) * first + at(i) * last);
  }
  const auto row = [](double t, int degree) {
    Eigen::RowVectorXd terms(degree - 1);
    double power = t * (1 - t);
    for (int k = 0; k < degree - 1; ++k, power *= 2 * t - 1) terms(k) = power;
    return terms;
  };
  Eigen::MatrixXd weights;
  int degree = 2;
  for (; degree <= most; ++degree) {
    Eigen::MatrixXd terms(n, degree - 1);
    for (Eigen::Index i = 0; i < n; ++i) terms.row(i) = row(at(i), degree);
    weights = terms.colPivHouseholderQr().solve(off.transpose());
    if ((terms * weights - off.transpose()).rowwise().norm().mean() < near) break;
  }
  degree = std::min(degree, most);
  std::vector<Eigen::Vector2d> curve{first};
  for (int i = 1; i < drawn; ++i) {
    const double t = static_cast<double>(i) / drawn;
    curve.push_back((1 - t) * first + t * last + (row(t, degree) * weights).transpose());
  }
  curve.push_back(last);
  return curve;
}

}  // namespace toile
