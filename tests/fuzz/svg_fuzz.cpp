// Any bytes as an SVG, packed or not: read or refused in words, within memory and time.

#include "formats/svg_read/svg_read.h"
#include "fuzz/checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toile;
  fuzz::check_file(read_svg_bytes(fuzz::text_of(data, size), "fuzz.svg"));
  return 0;
}
