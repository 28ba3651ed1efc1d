#pragma once

#include <string>

#include "garment/report.h"

namespace toile {

// The finding `action` is refused with; an empty one when it is not.
template <class Action>
Finding refusal(const Action& action) {
  try {
    action();
  } catch (const BadInput& error) {
    return error.finding();
  }
  return {};
}

}  // namespace toile
