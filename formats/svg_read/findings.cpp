#include "formats/svg_read/findings.h"

#include <map>

namespace toile::svg {

void append_in_svg_words(const Report& from, Report& to) {
  static const std::map<std::string, std::string> remedies{
      {"aama.open-outline", "close the outline in the drawing program"},
      {"aama.second-outline", ""},
      {"aama.mirror-line", "draw the fold line along a straight edge of the piece"},
      {"aama.no-sew-line",
       "if it is the cut line, write the allowance beside it (\"seam allowance 1 cm included\") or draw the sew line"},
      {"aama.no-grain-line", "draw a grain line, or write \"grain\" beside one"},
      {"aama.crossing-outline", "correct its outline in the drawing program"},
      {"aama.notch-off-outline", "move the notch to the outline"},
  };
  for (Finding finding : from.findings) {
    if (finding.code == "aama.points") continue;  // counts what a DXF marks; here every point is marked by the reader itself
    if (const auto remedy = remedies.find(finding.code); remedy != remedies.end()) finding.remedy = remedy->second;
    for (const char* words : {" on layer 14", " on layer 1", " on layer 8", " on layer 7", " on layer 6"})
      if (const std::size_t at = finding.text.find(words); at != std::string::npos)
        finding.text.erase(at, std::string(words).size());
    if (finding.code.compare(0, 5, "aama.") == 0) finding.code.replace(0, 5, "svg.");
    to.findings.push_back(std::move(finding));
  }
}

}  // namespace toile::svg
