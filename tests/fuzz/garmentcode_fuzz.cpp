// Any bytes as a GarmentCode specification: read or refused in words, within memory and time.

#include "formats/garmentcode/garmentcode.h"
#include "fuzz/checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toile;
  fuzz::check_file(read_garmentcode_text(fuzz::text_of(data, size), "fuzz.json"));
  return 0;
}
