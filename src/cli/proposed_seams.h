#pragma once
// Seams that the program finds itself, where a pattern comes without.

#include <filesystem>

#include "pairing/pairing.h"

namespace toile {

// With the templates of templates/garments. Throws BadInput for templates that cannot be read.
Proposal propose(const Pattern& pattern);

// "side 1 (front.e6 to back:1.e4)": 99 %, lengths agree within 0.3 mm"
std::string in_words(const Pattern& pattern, const ProposedSeam& seam);

// Whether the pattern lacks seams and has pieces that could have some.
bool wants_seams(const Pattern& pattern);

// Gives a pattern without seams those that are proposed, and says so: note "seams.proposed" for each seam. Pieces
// that lie on others are marked as not sewn. Throws
// BadInput("seams.unsure") listing what is unsure when confidence is too low, `file` being the pattern's.
Pattern with_proposed_seams(const Pattern& pattern, const std::filesystem::path& file, Report& report);

}  // namespace toile
