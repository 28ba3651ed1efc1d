// Any bytes as a draped garment: read or refused in words, within memory and time.

#include "formats/obj/garment.h"
#include "fuzz/checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toile;
  std::optional<double> unit;
  if (size > 0 && data[size - 1] % 2 == 0) unit = 1e-2;  // else as the garment says
  const Loaded<PatternFile> loaded = read_obj_garment(fuzz::text_of(data, size), "fuzz.obj", unit);
  fuzz::check_file(loaded);
  if (loaded.value)
    for (const DrapedGarment& drape : loaded.value->drape) check(drape.garment);
  return 0;
}
