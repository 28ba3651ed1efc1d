// Any bytes as a grade rule table.

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "formats/rul/rul.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto loaded = toile::read_rul_bytes({reinterpret_cast<const char*>(data), size}, "fuzz.rul");
  if (loaded.value.has_value() != loaded.report.ok()) std::abort();
  if (loaded.value)
    for (const auto& [number, moves] : loaded.value->rules)
      if (moves.size() != loaded.value->sizes.size()) std::abort();
  return 0;
}
