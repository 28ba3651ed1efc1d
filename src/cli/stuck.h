#pragma once
// What is left to look at when dressing did not come together.

#include "cli/job.h"
#include "cli/output_folder.h"

namespace toile {

// `control`, which will also write stuck.png, stuck.obj (the loose panels) and body.obj into `out` when dressing gets stuck,
// and fill job.stuck. `job` and `out` must outlive it.
DrapeControl with_stuck_picture(DrapeControl control, Job& job, const OutputFolder& out);

// Has the errors of dressing among `findings` name the picture.
void name_stuck_picture(const StuckDressing& stuck, std::vector<Finding>& findings);

// For when something fails after dressing got stuck, likely because of it: keeps the picture and says what stuck.
void keep_stuck_picture(const Job& job, OutputFolder& out);

}  // namespace toile
