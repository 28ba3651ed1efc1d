#include "draft/alike.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace toile {
namespace {

constexpr double grain_tolerance = 1e-3;  // radians

Eigen::Vector2d grain_of(const Piece& piece) {
  if (!piece.grainline) return Eigen::Vector2d::UnitY();
  const Eigen::Vector2d along = piece.grainline->to - piece.grainline->from;
  return along.norm() > 0 ? Eigen::Vector2d(along.normalized()) : Eigen::Vector2d::UnitY();
}

struct Drawn {
  Sides sides;
  Eigen::Vector2d grain;
  std::vector<std::set<int>> sewn_to;  // by run: the pieces it is sewn to
};

std::vector<Drawn> drawn_pieces(const Pattern& pattern) {
  std::vector<Drawn> drawn;
  for (const Piece& piece : pattern.pieces) {
    drawn.push_back({sides_of(piece), grain_of(piece), {}});
    drawn.back().sewn_to.resize(drawn.back().sides.runs.size());
  }
  const auto piece_index = [&](const std::string& name) {
    const Piece* piece = find_piece(pattern, name);
    return piece ? static_cast<int>(piece - pattern.pieces.data()) : -1;
  };
  const auto note = [&](const EdgeSpan& here, const EdgeSpan& there) {
    const int p = piece_index(here.piece), q = piece_index(there.piece);
    if (p < 0 || q < 0) return;
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(p)];
    const Edge* edge = find_edge(piece, here.edge);
    Drawn& d = drawn[static_cast<std::size_t>(p)];
    for (std::size_t r = 0; edge && r < d.sides.runs.size(); ++r)
      for (const Run::Part& part : d.sides.runs[r].parts)
        if (part.edge == edge - piece.outline.data()) d.sewn_to[r].insert(q);
  };
  for (const Seam& seam : pattern.seams) {
    note(seam.a, seam.b);
    note(seam.b, seam.a);
  }
  return drawn;
}

// Points of run `r` at even fractions, both ends included, in the direction it is run.
std::vector<Eigen::Vector2d> samples(const Sides& sides, std::size_t r, bool backwards) {
  const Eigen::Vector2d a = sides.corners[r], chord = sides.corners[(r + 1) % sides.corners.size()] - a;
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 16; ++i) points.push_back(a + on_chord(shape_at(sides.runs[r], (backwards ? 16 - i : i) / 16.0), chord));
  return points;
}

// The best motion (or reflection) of `from` onto `to`.
Isometry best_isometry(const Eigen::Matrix2Xd& from, const Eigen::Matrix2Xd& to, bool reflect) {
  const Eigen::Vector2d a = from.rowwise().mean(), b = to.rowwise().mean();
  Eigen::Matrix2Xd centred = from.colwise() - a;
  if (reflect) centred.row(0) *= -1;
  const Eigen::Matrix2d covariance = (to.colwise() - b) * centred.transpose();
  const double angle = std::atan2(covariance(1, 0) - covariance(0, 1), covariance(0, 0) + covariance(1, 1));
  Isometry result;
  result.turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  if (reflect) result.turn.col(0) *= -1;
  result.shift = b - result.turn * a;
  return result;
}

struct Match {
  Lay lay;
  double error = std::numeric_limits<double>::infinity();
};

// Lays `piece` on `shape` with its first run on run `offset`; the error is that of corners and curves, or infinite.
Match match(const Drawn& piece, const Drawn& shape, int offset, bool reversed) {
  const int count = static_cast<int>(piece.sides.runs.size());
  Match result;
  result.lay.offset = offset;
  result.lay.reversed = reversed;
  Eigen::Matrix2Xd from(2, 17 * count), to(2, 17 * count);
  for (int r = 0; r < count; ++r) {
    const auto i = static_cast<std::size_t>(r), j = static_cast<std::size_t>(run_of(result.lay, r, count));
    if (piece.sides.runs[i].straight != shape.sides.runs[j].straight || piece.sewn_to[i].empty() != shape.sewn_to[j].empty())
      return result;
    const auto mine = samples(piece.sides, i, false), other = samples(shape.sides, j, reversed);
    for (int k = 0; k < 17; ++k) {
      from.col(17 * r + k) = mine[static_cast<std::size_t>(k)];
      to.col(17 * r + k) = other[static_cast<std::size_t>(k)];
    }
  }
  const Isometry lay = best_isometry(from, to, reversed);
  const Eigen::Vector2d turned = lay.turn * piece.grain;
  if (std::abs(turned.x() * shape.grain.y() - turned.y() * shape.grain.x()) > grain_tolerance) return result;
  result.lay.to_shape = lay;
  result.error = ((lay.turn * from).colwise() + lay.shift - to).colwise().norm().maxCoeff();
  return result;
}

// The best lay within `tolerance`: grain the same way round before turned about, as drawn before mirrored.
std::optional<Lay> lay_on(const Drawn& piece, const Drawn& shape, double tolerance) {
  const int count = static_cast<int>(piece.sides.runs.size());
  if (count != static_cast<int>(shape.sides.runs.size())) return std::nullopt;
  std::optional<Lay> best;
  std::array<double, 3> best_rank{};
  for (const bool reversed : {false, true})
    for (int offset = 0; offset < count; ++offset) {
      const Match m = match(piece, shape, offset, reversed);
      if (!(m.error <= tolerance)) continue;
      const bool about = (m.lay.to_shape.turn * piece.grain).dot(shape.grain) < 0;
      const std::array<double, 3> rank{about ? 1.0 : 0.0, reversed ? 1.0 : 0.0, m.error};
      if (!best || rank < best_rank) {
        best = m.lay;
        best_rank = rank;
      }
    }
  return best;
}

// The reflection of a shape onto itself, when its sides have the same part to play in the garment.
std::optional<Lay> own_mirror(const Drawn& piece, double tolerance) {
  const int count = static_cast<int>(piece.sides.runs.size());
  for (int offset = 0; offset < count; ++offset) {
    const Match m = match(piece, piece, offset, true);
    if (!(m.error <= tolerance)) continue;
    const bool about_grain = (m.lay.to_shape.turn * piece.grain).dot(piece.grain) > 0;
    bool same_partners = true;
    for (int r = 0; r < count; ++r)
      same_partners &=
          piece.sewn_to[static_cast<std::size_t>(r)] == piece.sewn_to[static_cast<std::size_t>(run_of(m.lay, r, count))];
    if (about_grain || same_partners) return m.lay;
  }
  return std::nullopt;
}

Sides moved(Sides sides, const Isometry& isometry) {
  for (Eigen::Vector2d& corner : sides.corners) corner = isometry(corner);
  return sides;
}

// Both halves replaced by their mean.
void make_symmetric(Sides& sides, int mirror) {
  const Sides before = sides;
  const int count = static_cast<int>(sides.runs.size());
  const auto wrap = [&](int i) { return static_cast<std::size_t>(((i % count) + count) % count); };
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector2d& other = before.corners[wrap(mirror - k + 1)];
    sides.corners[wrap(k)] = (before.corners[wrap(k)] + Eigen::Vector2d(-other.x(), other.y())) / 2;
    Run& run = sides.runs[wrap(k)];
    const Run &mine = before.runs[wrap(k)], &twin = before.runs[wrap(mirror - k)];
    if (run.straight) continue;
    for (const double t : twin.at) run.at.push_back(1 - t);
    std::sort(run.at.begin(), run.at.end());
    run.at.erase(std::unique(run.at.begin(), run.at.end(), [](double a, double b) { return b - a < 1e-9; }), run.at.end());
    run.at.front() = 0;
    run.at.back() = 1;
    run.shape.clear();
    for (const double t : run.at) {
      const Eigen::Vector2d z = shape_at(twin, 1 - t);
      run.shape.push_back((shape_at(mine, t) + Eigen::Vector2d(1 - z.x(), z.y())) / 2);
    }
  }
}

Eigen::Vector2d centre(const Sides& sides) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : sides.corners) sum += corner;
  return sum / static_cast<double>(sides.corners.size());
}

}  // namespace

int run_of(const Lay& lay, int run, int count) {
  const int r = lay.reversed ? lay.offset - run : lay.offset + run;
  return ((r % count) + count) % count;
}

SharedShape on_its_own(const Piece& piece, int index) { return {sides_of(piece), {index}, std::nullopt}; }

Likeness find_likeness(const Pattern& pattern, double tolerance) {
  const std::vector<Drawn> drawn = drawn_pieces(pattern);
  Likeness likeness;
  for (std::size_t p = 0; p < drawn.size(); ++p) {
    std::optional<Lay> lay;
    for (std::size_t s = 0; tolerance > 0 && !lay && s < likeness.shapes.size(); ++s) {
      lay = lay_on(drawn[p], drawn[static_cast<std::size_t>(likeness.shapes[s].pieces.front())], tolerance);
      if (lay) lay->shape = static_cast<int>(s);
    }
    if (!lay) {
      lay = Lay{static_cast<int>(likeness.shapes.size()), {}, 0, false};
      likeness.shapes.push_back({drawn[p].sides, {}, std::nullopt});
    }
    likeness.shapes[static_cast<std::size_t>(lay->shape)].pieces.push_back(static_cast<int>(p));
    likeness.lays.push_back(*lay);
  }
  for (SharedShape& shape : likeness.shapes) {
    const Drawn& first = drawn[static_cast<std::size_t>(shape.pieces.front())];
    const auto mirror = tolerance > 0 ? own_mirror(first, tolerance) : std::nullopt;
    if (!mirror) continue;
    // The axis: its normal is turned about by the reflection; the midpoint of a point and its image lies on it.
    const Eigen::Matrix2d& turn = mirror->to_shape.turn;
    const Eigen::Vector2d normal =
        (Eigen::Vector2d(1 - turn(0, 0), -turn(1, 0)).norm() > .1 ? Eigen::Vector2d(1 - turn(0, 0), -turn(1, 0))
                                                                  : Eigen::Vector2d(-turn(0, 1), 1 - turn(1, 1)))
            .normalized();
    const Eigen::Vector2d c = centre(first.sides), on_axis = (c + mirror->to_shape(c)) / 2;
    Isometry to_axis;
    to_axis.turn << normal.transpose(), -normal.y(), normal.x();
    to_axis.shift = -(to_axis.turn * on_axis);
    shape.mirror = mirror->offset;
    shape.sides = moved(shape.sides, to_axis);
    make_symmetric(shape.sides, *shape.mirror);
    for (const int p : shape.pieces) {
      Lay& lay = likeness.lays[static_cast<std::size_t>(p)];
      lay.to_shape = to_axis.after(lay.to_shape);
    }
  }
  return likeness;
}

}  // namespace toile
