#pragma once
// Names in 7-bit ASCII, as AAMA files need them.

#include <string>
#include <string_view>

namespace toile::aama {

// UTF-8 to printable ASCII: letters without their accents ("Ärmel" -> "Aermel"), anything else that is no ASCII becomes '_',
// control characters and line breaks blanks; blanks at the ends are cut off. ASCII text comes back as it is. Not UTF-8: read as
// Latin-1.
std::string ascii(std::string_view text);

// A block name every reader takes: [A-Z0-9_-], at most 31 characters, not empty.
std::string block_name(std::string_view text);

}  // namespace toile::aama
