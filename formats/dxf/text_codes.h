#pragma once
// What a TEXT or MTEXT says, without the codes for how it is drawn.

#include <string>

namespace toile::dxf {

// TEXT: "%%d" degree, "%%p" plus-minus, "%%c" diameter, "%%065" a character by its number, "%%u" and the like nothing;
// "\U+00E4" a letter. MTEXT besides: groups in braces, fonts, heights, colours, stacked fractions ("1/2"); paragraphs are
// parted by '\n'. What is no code stays.
std::string plain_text(const std::string& text, bool mtext);

}  // namespace toile::dxf
