#pragma once

#include "edit/operation.h"

namespace toile {

// Part of one garment joined to part of another (paper Sec. 5).
EditOperation mix_operation();

}  // namespace toile
