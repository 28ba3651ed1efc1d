#pragma once
// Which panels of a mixed garment become one piece and which keep a seam (paper Sec. 5, "Joining garment components").

#include "edit/mix/joined.h"

namespace toile {

struct Uniting {
  Pattern pattern;
  GarmentMesh garment;      // the same triangles in another order, cut from the pattern
  std::vector<int> vertex;  // [garment vertex] -> that of the garment before
  Report report;            // one note for each pair of pieces that meet, with its curvature
};

// `pattern` and `garment`: the joined ones, maybe recut; `positions`: the target's, one column per garment vertex. Where a cut
// runs across a panel of each side and these meet from end to end, they become one piece when the garment is flat enough there
// and both can be laid flat together; pieces that are alike are treated alike. `reach`: m, how
// far from the joint its curvature is spread. `never`: all stay seams.
Uniting unite_where_flat(const JoinedPattern& joined, const Pattern& pattern, const GarmentMesh& garment,
                         const Eigen::Matrix3Xd& positions, double reach, bool never, const std::string& place);

}  // namespace toile
