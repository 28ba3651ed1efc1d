#pragma once
// The edit "grade": the garment on another body, its design kept (Brouet et al. 2012; paper Sec. 3).

#include "edit/operation.h"

namespace toile {

EditOperation grade_operation();

}  // namespace toile
