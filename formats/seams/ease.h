#pragma once
// How much longer one edge of a seam is meant to be: `ease` of a [[seam]].

#include <map>
#include <string>

#include "garment/pattern.h"

namespace toile {

// By the name of the seam, m. `text` is the sidecar from which `pattern` took its edge names and seams; a ring's ease is that
// of each of its seams, a long run's is shared out by length. Entries that do not read are left out: apply_seams complains of
// them.
std::map<std::string, double> meant_ease(const std::string& text, const std::string& file, const Pattern& pattern);

}  // namespace toile
