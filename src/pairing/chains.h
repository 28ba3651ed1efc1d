#pragma once
// One long edge sewn to several: a waistband to fronts and backs, a sleeve's cap to the armhole, a side to two that were cut.

#include "pairing/attempt.h"

namespace toile {

// Splits edges of `attempt` as long as that makes the whole better. Returns whether it split any.
bool share_out(const Pattern& pattern, Attempt& attempt);

}  // namespace toile
