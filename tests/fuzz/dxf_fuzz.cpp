// Any bytes as a DXF with a small rule table beside it: read or refused in words, within memory and time.

#include "formats/dxf_aama/dxf_aama.h"
#include "formats/formats.h"
#include "fuzz/checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toile;
  PatternReadOptions options;
  if (size > 0 && data[size - 1] % 2 == 0) options.unit_in_metres = 1e-3;  // else as the file says
  const auto rules = [](const std::string&, Report&) {
    GradeTable table;
    table.sizes = {"36", "38", "40"};
    table.sample_size = "38";
    for (int rule = 0; rule < 8; ++rule) table.rules[rule] = {{-rule, -.5 * rule}, {0, 0}, {rule, .5 * rule}};
    return std::optional<GradeTable>(table);
  };
  fuzz::check_file(read_dxf_pattern_bytes(fuzz::text_of(data, size), "fuzz.dxf", options, rules));
  return 0;
}
