#include "edit/loop_ease.h"

#include <Eigen/Dense>

#include "body/girth.h"
#include "edit/loops.h"

namespace toile {

LoopEase loop_ease(const Mannequin& form, const Eigen::Matrix3Xd& positions, const VertexLoop& loop,
                   const Eigen::Vector3d& axis) {
  const Eigen::Vector3d centre = loop_centre(positions, loop);
  Eigen::Matrix3Xd flat(3, static_cast<Eigen::Index>(loop.size()));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d at = positions.col(loop[i]);
    flat.col(static_cast<Eigen::Index>(i)) = at - axis.dot(at - centre) * axis;
  }
  VertexLoop order(loop.size());
  SectionLoop round;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    order[i] = static_cast<int>(i);
    round.emplace_back(flat.col(static_cast<Eigen::Index>(i)));
  }
  LoopEase ease;
  ease.along = loop_length(positions, loop);
  ease.tape = loop_girth(round, axis, GirthKind::tape);
  SectionLoop inside;
  for (const SectionLoop& part : section_loops(form.positions, form.triangles, centre, axis)) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& at : part) middle += at / static_cast<double>(part.size());
    if (crossings(flat, order, middle - 0.01 * axis, middle + 0.01 * axis) != 0)
      inside.insert(inside.end(), part.begin(), part.end());
  }
  if (inside.size() > 2) ease.body = loop_girth(inside, axis, GirthKind::tape);
  return ease;
}

}  // namespace toile
