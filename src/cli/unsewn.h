#pragma once
// Pieces that lie on others (pockets, facings, interlinings) or bind their edges: they are cut, but they hang with the garment,
// so what is draped and edited is the garment without them.

#include <filesystem>
#include <vector>

#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

// Takes the pieces that are not sewn out of the pattern.
std::vector<Piece> take_unsewn(Pattern& pattern);

// Moves them to the end of `unsewn` and says so: warning "pieces.not-sewn" naming them; `file` is the pattern's.
Report set_unsewn_apart(Pattern& pattern, const std::filesystem::path& file, std::vector<Piece>& unsewn);

}  // namespace toile
