#pragma once
// Loops brought to where the fit wants them, the rest of the garment following with the least change of style.

#include <string>
#include <vector>

#include "edit/fit/fit_loop.h"
#include "edit/styled.h"

namespace toile {

// `offsets`: by loop, m by loop vertex along its outward directions; the points are held there. Within `release` (m, along the
// cloth) of the points that move, the garment need not keep its distance to the body; free edges keep their place along it.
// `name`: the loops and the release, for the memory.
Styled offset_loops(const EditInput& input, const std::vector<FitLoop>& fits, const std::vector<Eigen::VectorXd>& offsets,
                    double release, EditMemory& memory, const std::string& name);

// m, shortest way along edges from any of `from` to every vertex; infinity where there is none.
Eigen::VectorXd way_along_cloth(const EditInput& input, EditMemory& memory, const std::vector<int>& from);

}  // namespace toile
