#pragma once
// The edit "fit": a loop of the garment, or all of it, farther from the body or nearer to it (paper Sec. 3, "Alterations to a
// single garment").

#include "edit/operation.h"

namespace toile {

EditOperation fit_operation();

}  // namespace toile
