#include "edit/length/trim.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/topology.h"

namespace toile {
namespace {

// One panel seen from one handle.
class PanelTrim {
 public:
  PanelTrim(const EditInput& input, const Handle& handle, const std::vector<char>& moves, const std::vector<char>& on_loop,
            std::size_t p, double by)
      : panel_(input.garment.panels[p]), by_(by), axis_(handle.axis) {
    const auto n = static_cast<std::size_t>(panel_.rest.cols());
    draped_.resize(3, panel_.rest.cols());
    moves_.resize(n);
    on_loop_.resize(n);
    for (std::size_t v = 0; v < n; ++v) {
      const int g = input.garment.welded[p](static_cast<Eigen::Index>(v));
      draped_.col(static_cast<Eigen::Index>(v)) = input.drape.col(g);
      moves_[v] = moves[static_cast<std::size_t>(g)];
      on_loop_[v] = on_loop[static_cast<std::size_t>(g)];
    }
    slide_ = Eigen::Matrix2Xd::Zero(2, panel_.rest.cols());
    known_.assign(n, 0);
    for (std::size_t v = 0; v < n; ++v) known_[v] = !moves_[v];
  }

  bool concerned() const { return std::find(moves_.begin(), moves_.end(), 1) != moves_.end(); }

  // Where its vertices come to lie, 3 x panel vertices; nothing when the seams do not lead the way.
  std::optional<Eigen::Matrix3Xd> positions() {
    if (!slide_seams_and_loop()) return std::nullopt;
    for (const BoundaryVertex& b : panel_.boundary)
      if (!known_[static_cast<std::size_t>(b.vertex)]) return std::nullopt;
    if (!slide_inside()) return std::nullopt;
    Eigen::Matrix3Xd moved = draped_;
    for (Eigen::Index v = 0; v < moved.cols(); ++v)
      if (moves_[static_cast<std::size_t>(v)]) moved.col(v) = lifted(panel_.rest.col(v) + slide_.col(v));
    return moved;
  }

  const std::vector<char>& moves() const { return moves_; }

 private:
  double along(int v) const { return axis_.dot(draped_.col(v)); }
  int boundary(std::ptrdiff_t i) const {
    const auto n = static_cast<std::ptrdiff_t>(panel_.boundary.size());
    return panel_.boundary[static_cast<std::size_t>(((i % n) + n) % n)].vertex;
  }
  bool on_loop(int v) const { return on_loop_[static_cast<std::size_t>(v)]; }
  bool moving(int v) const { return moves_[static_cast<std::size_t>(v)]; }

  void set(int v, const Eigen::Vector2d& slide) {
    slide_.col(v) = slide;
    known_[static_cast<std::size_t>(v)] = 1;
  }

  // From the end of a run of loop vertices along the boundary to the first vertex that stays: each slides towards it along the
  // chain, in proportion to its distance from it.
  bool slide_chain(std::ptrdiff_t start, std::ptrdiff_t step) {
    std::vector<int> chain{boundary(start)};
    for (std::ptrdiff_t i = start + step; chain.size() <= panel_.boundary.size(); i += step) {
      const int v = boundary(i);
      if (on_loop(v) || along(v) >= along(chain.back())) return false;
      chain.push_back(v);
      if (!moving(v)) break;
    }
    const double end = along(chain.back());
    const double room = along(chain.front()) - end;
    if (room + by_ <= 0.1 * room) return false;
    std::size_t below = 0;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const double goal = along(chain[i]) + by_ * (along(chain[i]) - end) / room;
      while (below + 2 < chain.size() && along(chain[below + 1]) > goal) ++below;
      const double share = (along(chain[below]) - goal) / (along(chain[below]) - along(chain[below + 1]));
      const Eigen::Vector2d place = (1 - share) * panel_.rest.col(chain[below]) + share * panel_.rest.col(chain[below + 1]);
      set(chain[i], place - panel_.rest.col(chain[i]));
    }
    return true;
  }

  // Between its ends the loop slides in a direction that turns from that of the one to that of the other, just so far that it
  // has moved by `by` along the axis.
  bool slide_run(std::ptrdiff_t first, std::ptrdiff_t last) {
    std::vector<double> place{0};
    for (std::ptrdiff_t i = first + 1; i <= last; ++i)
      place.push_back(place.back() + (panel_.rest.col(boundary(i)) - panel_.rest.col(boundary(i - 1))).norm());
    const Eigen::Vector2d at_first = slide_.col(boundary(first));
    const Eigen::Vector2d at_last = slide_.col(boundary(last));
    for (std::ptrdiff_t i = first + 1; i < last; ++i) {
      const double s = place[static_cast<std::size_t>(i - first)] / place.back();
      const Eigen::Vector2d towards = (1 - s) * at_first + s * at_last;
      const int v = boundary(i);
      const double goal = along(v) + by_;
      double low = 0;
      double high = 2;
      if (axis_.dot(lifted(panel_.rest.col(v) + high * towards)) > goal) return false;
      for (int halving = 0; halving < 50; ++halving) {
        const double middle = (low + high) / 2;
        (axis_.dot(lifted(panel_.rest.col(v) + middle * towards)) > goal ? low : high) = middle;
      }
      set(v, high * towards);
    }
    return true;
  }

  bool slide_seams_and_loop() {
    const auto n = static_cast<std::ptrdiff_t>(panel_.boundary.size());
    bool any = false;
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      if (!on_loop(boundary(i)) || on_loop(boundary(i - 1))) continue;
      std::ptrdiff_t last = i;
      while (on_loop(boundary(last + 1)) && last - i < n) ++last;
      if (last - i >= n || last == i || !slide_chain(i, -1) || !slide_chain(last, 1) || !slide_run(i, last)) return false;
      any = true;
    }
    return any;
  }

  // Harmonic between what is known.
  bool slide_inside() {
    std::vector<int> unknown(known_.size(), -1);
    int count = 0;
    for (std::size_t v = 0; v < known_.size(); ++v)
      if (!known_[v]) unknown[v] = count++;
    if (count == 0) return true;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
    const auto couple = [&](int a, int b, double weight) {
      const int i = unknown[static_cast<std::size_t>(a)];
      if (i < 0) return;
      entries.emplace_back(i, i, weight);
      const int j = unknown[static_cast<std::size_t>(b)];
      if (j >= 0)
        entries.emplace_back(i, j, -weight);
      else
        right.row(i) += weight * slide_.col(b).transpose();
    };
    for (Eigen::Index t = 0; t < panel_.triangles.cols(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int a = panel_.triangles(k, t);
        const int b = panel_.triangles((k + 1) % 3, t);
        const int c = panel_.triangles((k + 2) % 3, t);
        const Eigen::Vector2d u = panel_.rest.col(a) - panel_.rest.col(c);
        const Eigen::Vector2d w = panel_.rest.col(b) - panel_.rest.col(c);
        const double cotangent = u.dot(w) / std::abs(u.x() * w.y() - u.y() * w.x()) / 2;
        couple(a, b, cotangent);
        couple(b, a, cotangent);
      }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    if (factor.info() != Eigen::Success) return false;
    const Eigen::MatrixX2d solved = factor.solve(right);
    for (std::size_t v = 0; v < known_.size(); ++v)
      if (unknown[v] >= 0) slide_.col(static_cast<Eigen::Index>(v)) = solved.row(unknown[v]).transpose();
    return true;
  }

  // The draped place of a point of the rest shape; just outside it, of the nearest triangle carried on.
  Eigen::Vector3d lifted(const Eigen::Vector2d& at) const {
    double best = -std::numeric_limits<double>::infinity();
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (Eigen::Index t = 0; t < panel_.triangles.cols(); ++t) {
      const Eigen::Vector3i corner = panel_.triangles.col(t);
      const Eigen::Vector2d a = panel_.rest.col(corner(0));
      const Eigen::Vector2d u = Eigen::Vector2d(panel_.rest.col(corner(1))) - a;
      const Eigen::Vector2d w = Eigen::Vector2d(panel_.rest.col(corner(2))) - a;
      const Eigen::Vector2d d = at - a;
      const double area = u.x() * w.y() - u.y() * w.x();
      const double second = (d.x() * w.y() - d.y() * w.x()) / area;
      const double third = (u.x() * d.y() - u.y() * d.x()) / area;
      const double inside = std::min({1 - second - third, second, third});
      if (inside <= best) continue;
      best = inside;
      place = (1 - second - third) * draped_.col(corner(0)) + second * draped_.col(corner(1)) + third * draped_.col(corner(2));
      if (inside >= 0) break;
    }
    return place;
  }

  const PanelMesh& panel_;
  double by_;
  Eigen::Vector3d axis_;
  Eigen::Matrix3Xd draped_;
  std::vector<char> moves_, on_loop_, known_;
  Eigen::Matrix2Xd slide_;  // in the rest shape, m
};

}  // namespace

std::optional<Eigen::Matrix3Xd> trimmed(const EditInput& input, const std::vector<Handle>& handles, double by) {
  if (by >= 0) return std::nullopt;
  Eigen::Matrix3Xd positions = input.drape;
  for (const Handle& handle : handles) {
    std::vector<char> moves(static_cast<std::size_t>(input.garment.vertex_count), 0);
    std::vector<char> on_loop = moves;
    for (const int v : handle.moving) moves[static_cast<std::size_t>(v)] = 1;
    for (const int v : handle.loop) on_loop[static_cast<std::size_t>(v)] = 1;
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(positions.cols());
    Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, positions.cols());
    for (std::size_t p = 0; p < input.garment.panels.size(); ++p) {
      PanelTrim trim(input, handle, moves, on_loop, p, by);
      if (!trim.concerned()) continue;
      const auto moved = trim.positions();
      if (!moved) return std::nullopt;
      for (Eigen::Index v = 0; v < moved->cols(); ++v) {
        const int g = input.garment.welded[p](v);
        sum.col(g) += moved->col(v);
        shares(g) += 1;
      }
    }
    for (const int v : handle.moving) {
      if (shares(v) == 0) return std::nullopt;
      positions.col(v) = sum.col(v) / shares(v);
    }
  }
  return positions;
}

}  // namespace toile
