#include "edit/length/panel_slide.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "garment/units.h"

namespace toile {
namespace {

constexpr double corner_angle = 30 * units::degree;
constexpr double steep = 0.7;         // share of a chord along the axis
constexpr double behind_edge = 0.05;  // m of cloth or seam that say how it goes on beyond the loop

}  // namespace

PanelSlide::PanelSlide(const EditInput& input, const Handle& handle, const Eigen::Matrix3Xd& normals,
                       const std::vector<char>& moves, const std::vector<char>& on_loop, std::size_t p)
    : panel_(input.garment.panels[p]),
      axis_(handle.axis),
      draped_(3, panel_.rest.cols()),
      normals_(3, panel_.rest.cols()),
      chart_(panel_, draped_, normals_) {
  const auto n = static_cast<std::size_t>(panel_.rest.cols());
  moves_.resize(n);
  on_loop_.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    const int g = input.garment.welded[p](static_cast<Eigen::Index>(v));
    draped_.col(static_cast<Eigen::Index>(v)) = input.drape.col(g);
    normals_.col(static_cast<Eigen::Index>(v)) = normals.col(g);
    moves_[v] = moves[static_cast<std::size_t>(g)];
    on_loop_[v] = on_loop[static_cast<std::size_t>(g)];
  }
  double twice_area = 0;
  for (std::ptrdiff_t i = 0; i < count(); ++i) {
    const Eigen::Vector2d a = rest(i), b = rest(i + 1);
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  clockwise_ = twice_area < 0;
  leave_out_slits();
}

bool PanelSlide::slide_boundary(double cloth) {
  slide_ = Eigen::Matrix2Xd::Zero(2, panel_.rest.cols());
  known_.assign(moves_.size(), 0);
  for (std::size_t v = 0; v < moves_.size(); ++v) known_[v] = !moves_[v];
  runs_.clear();
  for (std::ptrdiff_t i = 0; i < count(); ++i) {
    if (!on_loop(boundary(i)) || on_loop(boundary(i - 1))) continue;
    std::ptrdiff_t last = i;
    while (on_loop(boundary(last + 1)) && last - i < count()) ++last;
    if (last - i >= count() || last == i || turns_within(i, last)) return false;
    if (!slide_chain(i, -1, cloth) || !slide_chain(last, 1, cloth)) return false;
    slide_run(i, last);
  }
  for (const BoundaryVertex& b : panel_.boundary) known_[static_cast<std::size_t>(b.vertex)] = 1;  // other edges stay
  return true;
}

bool PanelSlide::on_its_edge() const {
  return std::any_of(on_loop_.begin(), on_loop_.end(), [](char on) { return on != 0; });
}

Eigen::Vector3d PanelSlide::place(int v) const {
  if (!moves_[static_cast<std::size_t>(v)]) return draped_.col(v);
  const Eigen::Vector2d at = panel_.rest.col(v) + slide_.col(v);
  if (longer_ && !chart_.contains(at)) return nearest_run(at).at(at);
  return chart_.at(at);
}

int PanelSlide::boundary(std::ptrdiff_t i) const {
  return panel_.boundary[static_cast<std::size_t>(((i % count()) + count()) % count())].vertex;
}

void PanelSlide::set(int v, const Eigen::Vector2d& slide) {
  slide_.col(v) = slide;
  known_[static_cast<std::size_t>(v)] = 1;
}

bool PanelSlide::is_corner(std::ptrdiff_t i) const {
  return (rest(i) - rest(i - 1)).normalized().dot((rest(i + 1) - rest(i)).normalized()) < std::cos(corner_angle);
}

void PanelSlide::leave_out_slits() {
  std::vector<char> level(on_loop_.size(), 0);
  bool any = false;
  for (std::ptrdiff_t i = 0; i < count(); ++i) {
    if (!on_loop(boundary(i)) || (on_loop(boundary(i - 1)) && !is_corner(i))) continue;
    std::ptrdiff_t last = i;
    while (on_loop(boundary(last + 1)) && last - i < count() && (last == i || !is_corner(last))) ++last;
    const Eigen::Vector3d chord = draped_.col(boundary(last)) - draped_.col(boundary(i));
    if (last == i || std::abs(axis_.dot(chord)) > steep * chord.norm()) continue;
    for (std::ptrdiff_t k = i; k <= last; ++k) level[static_cast<std::size_t>(boundary(k))] = 1;
    any = true;
  }
  if (any) on_loop_ = level;
}

bool PanelSlide::turns_within(std::ptrdiff_t first, std::ptrdiff_t last) const {
  for (std::ptrdiff_t i = first + 1; i < last; ++i)
    if (is_corner(i)) return true;
  return false;
}

bool PanelSlide::slide_chain(std::ptrdiff_t start, std::ptrdiff_t step, double cloth) {
  std::vector<int> chain{boundary(start)};
  std::vector<double> length{0};  // from the loop
  for (std::ptrdiff_t i = start + step; chain.size() <= panel_.boundary.size(); i += step) {
    const int v = boundary(i);
    if (on_loop(v)) return false;
    if (along(v) >= along(chain.back())) break;
    length.push_back(length.back() + (panel_.rest.col(v) - panel_.rest.col(chain.back())).norm());
    chain.push_back(v);
    if (!moves_[static_cast<std::size_t>(v)] || is_corner(i)) break;
  }
  if (chain.size() < 3) return false;
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

void PanelSlide::slide_run(std::ptrdiff_t first, std::ptrdiff_t last) {
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

const CarriedOn& PanelSlide::nearest_run(const Eigen::Vector2d& at) const {
  return *std::min_element(runs_.begin(), runs_.end(),
                           [&](const CarriedOn& a, const CarriedOn& b) { return a.distance(at) < b.distance(at); });
}

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

}  // namespace toile
