#include "cli/inspect_verb.h"

#include <cstdio>

#include "cli/exit_codes.h"
#include "cli/inspect_picture.h"
#include "formats/formats.h"
#include "formats/inspection/inspection.h"
#include "garment/units.h"

namespace toile {

int inspect_pattern(const InspectOptions& options) {
  PatternReadOptions reading;
  reading.seams = options.seams;
  reading.size = options.size;
  if (!options.units.empty()) {
    reading.unit_in_metres = parse_length("1" + options.units);
    if (!reading.unit_in_metres)
      throw BadInput({"option.no-length", Severity::error, "--units", "'" + options.units + "' is no unit of length",
                      "Write mm, cm, m or in"});
  }
  const Loaded<PatternFile> loaded = read_pattern_file(options.file, reading);
  std::vector<PieceRow> rows;
  if (loaded.value) rows = piece_rows(*loaded.value, !options.size.empty());
  const std::string said =
      options.json ? inspection_json(loaded, rows) : inspection_table(options.file.filename().string(), loaded, rows);
  std::fwrite(said.data(), 1, said.size(), stdout);
  if (!loaded.value) {
    for (const Finding& finding : loaded.report.findings)
      if (finding.severity == Severity::error) {
        if (options.json) std::fprintf(stderr, "toile: %s\n", in_words(finding).c_str());
        return exit_code(finding.fault);
      }
    return exit_bad_input;
  }
  if (options.png)
    write_whole_file(*options.png,
                     png_bytes(contact_sheet(*loaded.value, options.file.filename().string(), options.size.empty())));
  return exit_ok;
}

}  // namespace toile
