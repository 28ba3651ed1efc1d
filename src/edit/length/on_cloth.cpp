#include "edit/length/on_cloth.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "edit/length/panel_slide.h"
#include "geometry/normals.h"
#include "parallel/threads.h"

namespace toile {
namespace {

constexpr double apart_limit = 2e-3;  // m, of the places that two panels give a vertex of their seam

// All panels of one handle.
class GarmentSlide {
 public:
  GarmentSlide(const EditInput& input, const Handle& handle, const Eigen::Matrix3Xd& normals) : input_(input), handle_(handle) {
    std::vector<char> moves(static_cast<std::size_t>(input.garment.vertex_count), 0);
    std::vector<char> on_loop = moves;
    for (const int v : handle.moving) moves[static_cast<std::size_t>(v)] = 1;
    for (const int v : handle.loop) on_loop[static_cast<std::size_t>(v)] = 1;
    panels_.resize(input.garment.panels.size());
    for (std::size_t p = 0; p < panels_.size(); ++p) {
      auto panel = std::make_unique<PanelSlide>(input, handle, normals, moves, on_loop, p);
      if (panel->on_its_edge()) panels_[p] = std::move(panel);
    }
  }

  bool slide_boundaries(double cloth) {
    return std::all_of(panels_.begin(), panels_.end(), [&](auto& panel) { return !panel || panel->slide_boundary(cloth); });
  }
  bool slide_insides() {
    const int count = static_cast<int>(panels_.size());
    std::vector<char> slid(panels_.size(), 1);
    placed_.resize(panels_.size());
    in_ranges(count, count, [&](int, int begin, int end) {
      for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p) {
        if (!panels_[p] || !(slid[p] = panels_[p]->slide_inside())) continue;
        placed_[p].resize(3, input_.garment.welded[p].size());
        for (Eigen::Index v = 0; v < placed_[p].cols(); ++v) placed_[p].col(v) = panels_[p]->place(static_cast<int>(v));
      }
    });
    return std::all_of(slid.begin(), slid.end(), [](char done) { return done != 0; });
  }

  // m, along the axis, in the mean over the loop.
  double moved() const {
    std::vector<char> counts(static_cast<std::size_t>(input_.garment.vertex_count), 0);
    for (std::size_t p = 0; p < panels_.size(); ++p)
      for (Eigen::Index v = 0; panels_[p] && v < input_.garment.welded[p].size(); ++v)
        if (panels_[p]->is_on_loop(static_cast<int>(v))) counts[static_cast<std::size_t>(input_.garment.welded[p](v))] = 1;
    std::vector<int> loop;
    for (const int v : handle_.loop)
      if (counts[static_cast<std::size_t>(v)]) loop.push_back(v);
    const auto at = places(loop);
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) sum += handle_.axis.dot(at[i] - input_.drape.col(loop[i]));
    return sum / static_cast<double>(std::max<std::size_t>(1, at.size()));
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
        sum[static_cast<std::size_t>(i)] += place(p, v);
        ++shares[static_cast<std::size_t>(i)];
      }
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] = shares[i] > 0 ? Eigen::Vector3d(sum[i] / shares[i]) : Eigen::Vector3d(input_.drape.col(vertices[i]));
    return sum;
  }

  // Whether panels agree about the vertices of their seams at `at`, the places of `vertices`.
  bool agree(const std::vector<int>& vertices, const std::vector<Eigen::Vector3d>& at) const {
    std::vector<int> wanted(static_cast<std::size_t>(input_.garment.vertex_count), -1);
    for (std::size_t i = 0; i < vertices.size(); ++i) wanted[static_cast<std::size_t>(vertices[i])] = static_cast<int>(i);
    for (std::size_t p = 0; p < panels_.size(); ++p) {
      const Eigen::VectorXi& welded = input_.garment.welded[p];
      for (Eigen::Index v = 0; v < welded.size(); ++v) {
        const int i = wanted[static_cast<std::size_t>(welded(v))];
        if (i < 0) continue;
        const Eigen::Vector3d here = panels_[p] ? place(p, v) : Eigen::Vector3d(input_.drape.col(welded(v)));
        if ((here - at[static_cast<std::size_t>(i)]).norm() > apart_limit) return false;
      }
    }
    return true;
  }

 private:
  Eigen::Vector3d place(std::size_t p, Eigen::Index v) const {
    return placed_.empty() ? panels_[p]->place(static_cast<int>(v)) : Eigen::Vector3d(placed_[p].col(v));
  }

  const EditInput& input_;
  const Handle& handle_;
  std::vector<std::unique_ptr<PanelSlide>> panels_;
  std::vector<Eigen::Matrix3Xd> placed_;  // by panel, once the insides have slid
};

}  // namespace

std::optional<Eigen::Matrix3Xd> slid_on_cloth(const EditInput& input, const std::vector<Handle>& handles, double by) {
  if (by == 0) return std::nullopt;
  Eigen::Matrix3Xd positions = input.drape;
  const Eigen::Matrix3Xd normals = vertex_normals(input.drape, input.garment.triangles);
  for (const Handle& handle : handles) {
    GarmentSlide slide(input, handle, normals);
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
    if (!slide.agree(handle.moving, at)) return std::nullopt;
    for (std::size_t i = 0; i < at.size(); ++i) positions.col(handle.moving[i]) = at[i];
  }
  return positions;
}

}  // namespace toile
