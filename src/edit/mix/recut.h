#pragma once
// Pieces drawn anew so that what was joined fits: the edges of a joint equally long.

#include "edit/mix/joined.h"

namespace toile {

// m, by how much the two sides of the joint differ in length at most, stretch by stretch, against their mean (a share).
double joint_mismatch(const JoinedPattern& joined);

struct Recut {
  Pattern pattern;
  GarmentMesh garment;  // the same triangles, cut from it
};

// Every triangle's rest shape changed as the cloth was stretched from `hanging` to `positions`, laid flat with the edges of the
// joint equally long, and the outlines drawn through it: ends moved, straight edges straight, curves changed smoothly, pieces
// that were alike still alike.
Recut recut(const JoinedPattern& joined, const JoinedGarment& hung, const Eigen::Matrix3Xd& positions);

// `pattern` with its outlines drawn through `flat`, a shape of `garment`'s panels, in the way of `recut`; lines and holes go
// along. `garment` lies on the outlines of `pattern`.
Recut drawn_through(const Pattern& pattern, const GarmentMesh& garment, const RestShape& flat);

}  // namespace toile
