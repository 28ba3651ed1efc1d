#pragma once
// The edit "length": moves a loop of the garment along the body (paper Sec. 3, "Alterations to a single garment").

#include "edit/operation.h"

namespace toile {

EditOperation length_operation();

}  // namespace toile
