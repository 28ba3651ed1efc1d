#pragma once
// How one panel slides on its own cloth when a loop is moved along the body.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "edit/length/handle.h"
#include "edit/length/panel_chart.h"

namespace toile {

// One panel seen from one handle.
class PanelSlide {
 public:
  // `normals`: 3 x garment vertices, of the drape.
  PanelSlide(const EditInput& input, const Handle& handle, const Eigen::Matrix3Xd& normals, const std::vector<char>& moves,
             const std::vector<char>& on_loop, std::size_t p);
  PanelSlide(const PanelSlide&) = delete;
  PanelSlide& operator=(const PanelSlide&) = delete;

  // Slides the boundary by `cloth` metres, positive = longer. False when the seams do not lead the way.
  bool slide_boundary(double cloth);
  bool is_on_loop(int v) const { return on_loop(v); }
  bool on_its_edge() const;

  // Where a vertex has come to.
  Eigen::Vector3d place(int v) const;

  // Harmonic between what is known.
  bool slide_inside();

 private:
  std::ptrdiff_t count() const { return static_cast<std::ptrdiff_t>(panel_.boundary.size()); }
  int boundary(std::ptrdiff_t i) const;
  Eigen::Vector2d rest(std::ptrdiff_t i) const { return panel_.rest.col(boundary(i)); }
  double along(int v) const { return axis_.dot(draped_.col(v)); }
  bool on_loop(int v) const { return on_loop_[static_cast<std::size_t>(v)]; }
  void set(int v, const Eigen::Vector2d& slide);

  // Whether the outline turns a corner at boundary vertex `i`.
  bool is_corner(std::ptrdiff_t i) const;
  // A loop also runs up one side of a slit and down the other; these slide like seams.
  void leave_out_slits();
  // Whether the loop has corners between these two boundary vertices.
  bool turns_within(std::ptrdiff_t first, std::ptrdiff_t last) const;

  // From the end of a run of loop vertices along the seam to its end or the first vertex that stays: each slides along the
  // seam, in proportion to its distance from that one.
  bool slide_chain(std::ptrdiff_t start, std::ptrdiff_t step, double cloth);

  // Between its ends the loop keeps its distance from where it was, seen across it, and moves along itself as its ends do.
  void slide_run(std::ptrdiff_t first, std::ptrdiff_t last);

  const CarriedOn& nearest_run(const Eigen::Vector2d& at) const;

  const PanelMesh& panel_;
  Eigen::Vector3d axis_;
  Eigen::Matrix3Xd draped_, normals_;
  PanelChart chart_;
  std::vector<char> moves_, on_loop_, known_;
  Eigen::Matrix2Xd slide_;  // in the rest shape, m
  std::vector<CarriedOn> runs_;
  bool clockwise_ = false, longer_ = false;
};

}  // namespace toile
