#pragma once

#include <string>

namespace toile {

// The PDF `bytes` ready for a printer (qpdf): its viewer is asked for actual size (PrintScaling None), it has no date, and an
// ID that follows from what it holds, so that the same sheet is the same bytes. Throws std::invalid_argument when it is no PDF.
std::string ready_for_print(const std::string& bytes);

}  // namespace toile
