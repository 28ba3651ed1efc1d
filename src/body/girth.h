#pragma once
// Girths of a body (or of anything closed) as a tape or a laser would measure them: where a plane cuts the triangles.

#include <Eigen/Core>
#include <vector>

namespace toile {

// `tape`: the convex hull of the section, what a taut tape reads and what size charts mean by bust, waist, hip, thigh.
// `contour`: along the surface itself, hollows included.
enum class GirthKind { tape, contour };

// One closed curve of a section, 3D points in the plane without repeated end point.
using SectionLoop = std::vector<Eigen::Vector3d>;

// All closed curves in which the plane (through `at`, normal `normal`) cuts the surface, counter-clockwise seen against
// `normal` for an outward surface, in the order of their first triangle. Open curves (surface with a hole) are left out.
std::vector<SectionLoop> section_loops(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
                                       const Eigen::Vector3d& at, const Eigen::Vector3d& normal);

// Length of a loop, m.
double loop_girth(const SectionLoop& loop, const Eigen::Vector3d& normal, GirthKind kind);

// Girth of the trunk at height `height_y`: of the loop that crosses the midplane x = 0 and encloses most, so arms and, below
// the crotch, legs are not part of it. 0 when no loop crosses the midplane there.
double trunk_girth(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles, double height_y,
                   GirthKind kind = GirthKind::tape);

// Girth of the limb round `at`, in the plane with normal `along`: of the loop that encloses `at`, else of the one nearest to
// it. Loops that also cross the midplane (thighs that touch) are measured on `at`'s side of it only. 0 when the plane meets
// nothing.
double limb_girth(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles, const Eigen::Vector3d& at,
                  const Eigen::Vector3d& along, GirthKind kind = GirthKind::tape);

}  // namespace toile
