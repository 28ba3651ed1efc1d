#include "edit/length/on_cloth.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <memory>

#include "edit/length/panel_chart.h"

namespace toile {
namespace {

constexpr double behind_edge = 0.05;  // m of cloth or seam that say how it goes on beyond the loop

// One panel seen from one handle.
class PanelSlide {
 public:
  PanelSlide(const EditInput& input, const Handle& handle, const std::vector<char>& moves, const std::vector<char>& on_loop,
             std::size_t p)
      : panel_(input.garment.panels[p]), axis_(handle.axis), draped_(3, panel_.rest.cols()), chart_(panel_, draped_) {
    const auto n = static_cast<std::size_t>(panel_.rest.cols());
    moves_.resize(n);
    on_loop_.resize(n);
    for (std::size_t v = 0; v < n; ++v) {
      const int g = input.garment.welded[p](static_cast<Eigen::Index>(v));
      draped_.col(static_cast<Eigen::Index>(v)) = input.drape.col(g);
      moves_[v] = moves[static_cast<std::size_t>(g)];
      on_loop_[v] = on_loop[static_cast<std::size_t>(g)];
    }
    double twice_area = 0;
    for (std::ptrdiff_t i = 0; i < count(); ++i) {
      const Eigen::Vector2d a = rest(i), b = rest(i + 1);
      twice_area += a.x() * b.y() - a.y() * b.x();
    }
    clockwise_ = twice_area < 0;
  }
  PanelSlide(const PanelSlide&) = delete;
  PanelSlide& operator=(const PanelSlide&) = delete;

  bool concerned() const { return std::find(moves_.begin(), moves_.end(), 1) != moves_.end(); }

  // Slides the boundary by `cloth` metres, positive = longer. False when the seams do not lead the way.
  bool slide_boundary(double cloth) {
    slide_ = Eigen::Matrix2Xd::Zero(2, panel_.rest.cols());
    known_.assign(moves_.size(), 0);
    for (std::size_t v = 0; v < moves_.size(); ++v) known_[v] = !moves_[v];
    runs_.clear();
    for (std::ptrdiff_t i = 0; i < count(); ++i) {
      if (!on_loop(boundary(i)) || on_loop(boundary(i - 1))) continue;
      std::ptrdiff_t last = i;
      while (on_loop(boundary(last + 1)) && last - i < count()) ++last;
      if (last - i >= count() || last == i || !slide_chain(i, -1, cloth) || !slide_chain(last, 1, cloth)) return false;
      slide_run(i, last);
    }
    return !runs_.empty() && std::all_of(panel_.boundary.begin(), panel_.boundary.end(), [&](const BoundaryVertex& b) {
      return known_[static_cast<std::size_t>(b.vertex)] != 0;
    });
  }

  // Where a vertex has come to.
  Eigen::Vector3d place(int v) const {
    if (!moves_[static_cast<std::size_t>(v)]) return draped_.col(v);
    const Eigen::Vector2d at = panel_.rest.col(v) + slide_.col(v);
    if (longer_ && !chart_.contains(at)) return nearest_run(at).at(at);
    return chart_.at(at);
  }

  // Harmonic between what is known.
  bool slide_inside();

 private:
  std::ptrdiff_t count() const { return static_cast<std::ptrdiff_t>(panel_.boundary.size()); }
  int boundary(std::ptrdiff_t i) const {
    return panel_.boundary[static_cast<std::size_t>(((i % count()) + count()) % count())].vertex;
  }
  Eigen::Vector2d rest(std::ptrdiff_t i) const { return panel_.rest.col(boundary(i)); }
  double along(int v) const { return axis_.dot(draped_.col(v)); }
  bool on_loop(int v) const { return on_loop_[static_cast<std::size_t>(v)]; }
  void set(int v, const Eigen::Vector2d& slide) {
    slide_.col(v) = slide;
    known_[static_cast<std::size_t>(v)] = 1;
  }

  // From the end of a run of loop vertices along the boundary to the first vertex that stays: each slides along the chain, in
  // proportion to its distance from that one.
  bool slide_chain(std::ptrdiff_t start, std::ptrdiff_t step, double cloth) {
    std::vector<int> chain{boundary(start)};
    std::vector<double> length{0};  // from the loop
    for (std::ptrdiff_t i = start + step; chain.size() <= panel_.boundary.size(); i += step) {
      const int v = boundary(i);
      if (on_loop(v) || along(v) >= along(chain.back())) return false;
      length.push_back(length.back() + (panel_.rest.col(v) - panel_.rest.col(chain.back())).norm());
      chain.push_back(v);
      if (!moves_[static_cast<std::size_t>(v)]) break;
    }
    const double room = length.back();
    if (room + cloth <= 0.1 * room) return false;
    longer_ = cloth > 0;
    std::size_t behind = 1;
    while (behind + 1 < chain.size() && length[behind] < behind_edge) ++behind;
    const Eigen::Vector2d on = (panel_.rest.col(chain[0]) - panel_.rest.col(chain[behind])).normalized();
    std::size_t after = chain.size() - 1;
    for (std::size_t i = chain.size() - 1; i-- > 0;) {
      const double goal = room - (room - length[i]) * (1 + cloth / room);
      if (goal < 0) {
        set(chain[i], panel_.rest.col(chain[0]) - goal * on - panel_.rest.col(chain[i]));
        continue;
      }
      while (after > 1 && length[after - 1] > goal) --after;
      const double share = (goal - length[after - 1]) / (length[after] - length[after - 1]);
      const Eigen::Vector2d at = (1 - share) * panel_.rest.col(chain[after - 1]) + share * panel_.rest.col(chain[after]);
      set(chain[i], at - panel_.rest.col(chain[i]));
    }
    return true;
  }

  // Between its ends the loop keeps its distance from where it was, seen across it, and moves along itself as its ends do.
  void slide_run(std::ptrdiff_t first, std::ptrdiff_t last) {
    const auto along_loop = [&](std::ptrdiff_t i) -> Eigen::Vector2d {
      return (rest(std::min(i + 1, last)) - rest(std::max(i - 1, first))).normalized();
    };
    const auto outward = [&](const Eigen::Vector2d& t) -> Eigen::Vector2d {
      return clockwise_ ? Eigen::Vector2d(-t.y(), t.x()) : Eigen::Vector2d(t.y(), -t.x());
    };
    double length = 0;
    for (std::ptrdiff_t i = first; i < last; ++i) length += (rest(i + 1) - rest(i)).norm();
    const Eigen::Vector2d begin = slide_.col(boundary(first)), end = slide_.col(boundary(last));
    const Eigen::Vector2d t0 = along_loop(first), t1 = along_loop(last);
    double so_far = 0;
    std::vector<int> edge;
    Eigen::Matrix2Xd directions(2, last - first + 1);
    for (std::ptrdiff_t i = first; i <= last; ++i) {
      if (i > first) so_far += (rest(i) - rest(i - 1)).norm();
      const double s = so_far / length;
      const Eigen::Vector2d t = along_loop(i);
      if (i > first && i < last)
        set(boundary(i), ((1 - s) * begin.dot(outward(t0)) + s * end.dot(outward(t1))) * outward(t) +
                             ((1 - s) * begin.dot(t0) + s * end.dot(t1)) * t);
      edge.push_back(boundary(i));
      directions.col(i - first) = slide_.col(boundary(i));
    }
    runs_.emplace_back(panel_, chart_, std::move(edge), std::move(directions), behind_edge);
  }

  const CarriedOn& nearest_run(const Eigen::Vector2d& at) const {
    return *std::min_element(runs_.begin(), runs_.end(),
                             [&](const CarriedOn& a, const CarriedOn& b) { return a.distance(at) < b.distance(at); });
  }

  const PanelMesh& panel_;
  Eigen::Vector3d axis_;
  Eigen::Matrix3Xd draped_;
  PanelChart chart_;
  std::vector<char> moves_, on_loop_, known_;
  Eigen::Matrix2Xd slide_;  // in the rest shape, m
  std::vector<CarriedOn> runs_;
  bool clockwise_ = false, longer_ = false;
};

bool PanelSlide::slide_inside() {
  std::vector<int> unknown(known_.size(), -1);
  int unknowns = 0;
  for (std::size_t v = 0; v < known_.size(); ++v)
    if (!known_[v]) unknown[v] = unknowns++;
  if (unknowns == 0) return true;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(unknowns, 2);
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
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success) return false;
  const Eigen::MatrixX2d solved = factor.solve(right);
  for (std::size_t v = 0; v < known_.size(); ++v)
    if (unknown[v] >= 0) slide_.col(static_cast<Eigen::Index>(v)) = solved.row(unknown[v]).transpose();
  return true;
}

// All panels of one handle.
class GarmentSlide {
 public:
  GarmentSlide(const EditInput& input, const Handle& handle) : input_(input), handle_(handle) {
    std::vector<char> moves(static_cast<std::size_t>(input.garment.vertex_count), 0);
    std::vector<char> on_loop = moves;
    for (const int v : handle.moving) moves[static_cast<std::size_t>(v)] = 1;
    for (const int v : handle.loop) on_loop[static_cast<std::size_t>(v)] = 1;
    panels_.resize(input.garment.panels.size());
    for (std::size_t p = 0; p < panels_.size(); ++p) {
      auto panel = std::make_unique<PanelSlide>(input, handle, moves, on_loop, p);
      if (panel->concerned()) panels_[p] = std::move(panel);
    }
  }

  bool slide_boundaries(double cloth) {
    return std::all_of(panels_.begin(), panels_.end(), [&](auto& panel) { return !panel || panel->slide_boundary(cloth); });
  }
  bool slide_insides() {
    return std::all_of(panels_.begin(), panels_.end(), [&](auto& panel) { return !panel || panel->slide_inside(); });
  }

  // m, along the axis, in the mean over the loop.
  double moved() const {
    const auto at = places(handle_.loop);
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += handle_.axis.dot(at[i] - input_.drape.col(handle_.loop[i]));
    return sum / static_cast<double>(at.size());
  }

  // Of garment vertices; where panels meet, in the mean.
  std::vector<Eigen::Vector3d> places(const std::vector<int>& vertices) const {
    std::vector<int> wanted(static_cast<std::size_t>(input_.garment.vertex_count), -1);
    for (std::size_t i = 0; i < vertices.size(); ++i) wanted[static_cast<std::size_t>(vertices[i])] = static_cast<int>(i);
    std::vector<Eigen::Vector3d> sum(vertices.size(), Eigen::Vector3d::Zero());
    std::vector<int> shares(vertices.size(), 0);
    for (std::size_t p = 0; p < panels_.size(); ++p) {
      if (!panels_[p]) continue;
      const Eigen::VectorXi& welded = input_.garment.welded[p];
      for (Eigen::Index v = 0; v < welded.size(); ++v) {
        const int i = wanted[static_cast<std::size_t>(welded(v))];
        if (i < 0) continue;
        sum[static_cast<std::size_t>(i)] += panels_[p]->place(static_cast<int>(v));
        ++shares[static_cast<std::size_t>(i)];
      }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= std::max(1, shares[i]);
    return sum;
  }

 private:
  const EditInput& input_;
  const Handle& handle_;
  std::vector<std::unique_ptr<PanelSlide>> panels_;
};

}  // namespace

std::optional<Eigen::Matrix3Xd> slid_on_cloth(const EditInput& input, const std::vector<Handle>& handles, double by) {
  if (by == 0) return std::nullopt;
  Eigen::Matrix3Xd positions = input.drape;
  for (const Handle& handle : handles) {
    GarmentSlide slide(input, handle);
    double cloth = by;
    for (int round = 0;; ++round) {
      if (!slide.slide_boundaries(cloth)) return std::nullopt;
      const double moved = slide.moved();
      if (std::abs(moved - by) < 1e-6 || round == 12) break;
      if (moved * by <= 0) return std::nullopt;
      cloth *= by / moved;
    }
    if (!slide.slide_insides()) return std::nullopt;
    const auto at = slide.places(handle.moving);
    for (std::size_t i = 0; i < at.size(); ++i) positions.col(handle.moving[i]) = at[i];
  }
  return positions;
}

}  // namespace toile
