#pragma once
// Where the pieces of a garment sit on the body, by the roles they play and what they are sewn to.

#include <string>
#include <vector>

#include "pairing/attempt.h"

namespace toile {

// Gives the copies of `pattern`'s pieces their body parts; returns the names of the pieces that sit nowhere the template knows.
std::vector<std::string> place_on_body(const Attempt& attempt, Pattern& pattern);

}  // namespace toile
