#pragma once
// Runs of edges in a seams sidecar, found in the pattern.

#include <vector>

#include "formats/seams/values.h"

namespace toile {

// The runs that `node` names: one, or one for every copy in order when it names a piece that is cut several times, leaves the
// copy out and `all_copies` allows that. `node` is a text ("gore:1.right[0..1/2]") or a table {piece, copy, edge, from, to}.
// Every span's begin is before its end. Empty after an error.
std::vector<EdgeSpan> spans_of(const TomlNode& node, const Pattern& pattern, bool all_copies, Sidecar& sidecar);

}  // namespace toile
