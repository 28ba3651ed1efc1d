#pragma once

#include <memory>

#include "edit/mix/join_style.h"
#include "edit/operation.h"

namespace toile {

// Part of one garment joined to part of another (paper Sec. 5).
EditOperation mix_operation();

// The two parts where they meet, before outlines are drawn anew.
struct Meeting {
  std::shared_ptr<const WornGarment> other;
  JoinedPattern joined;
  JoinedGarment hung;
  MixedShape shape;
  Report report;  // where the loops were found
};

// Of mix's own arguments; throws BadInput as the operation does.
Meeting meet(const EditInput& input, const EditArguments& arguments);

}  // namespace toile
