#include "cli/sew_verb.h"

#include <cstdio>

#include "cli/exit_codes.h"
#include "cli/proposed_seams.h"
#include "formats/formats.h"
#include "formats/seams/seams.h"
#include "garment/units.h"

namespace toile {
namespace {

// The sidecar's text with what is known of each seam above it. The seams stand in the order of the pattern.
std::string commented(const Proposal& proposal) {
  const std::string text = seams_text(proposal.pattern);
  std::string out = "# Proposed by toile sew" +
                    (proposal.garment.empty() ? std::string(": by the shapes alone") : ", as a " + proposal.garment) +
                    ". Correct what is wrong, then keep this file beside the pattern.\n";
  for (const std::string& name : proposal.apart) out += "# Not sewn to anything: " + name + "\n";
  for (const std::string& name : proposal.extras)
    out += "# Lies on other pieces or binds their edges, not sewn: " + name + "\n";
  for (const std::string& name : proposal.unplaced) out += "# Where on the body it sits is not known: " + name + "\n";
  std::size_t seam = 0, at = 0;
  const std::string head = "[[seam]]\n";
  for (std::size_t next; (next = text.find("\n" + head, at)) != std::string::npos && seam < proposal.seams.size(); ++seam) {
    out += text.substr(at, next + 1 - at);
    const ProposedSeam& found = proposal.seams[seam];
    out +=
        "# " + in_words(proposal.pattern, found) + "; " + in_mm(found.length_a) + " and " + in_mm(found.length_b) + "\n" + head;
    at = next + 1 + head.size();
  }
  return out + text.substr(at);
}

}  // namespace

int sew_pattern(const SewOptions& options) {
  PatternReadOptions read;
  if (!options.units.empty()) {
    const auto unit = parse_length("1" + options.units);
    if (!unit)
      throw BadInput(
          {"option.no-length", Severity::error, "--units", "'" + options.units + "' is no unit", "Write mm, cm, m or in"});
    read.unit_in_metres = *unit;
  }
  read.size = options.size;
  std::error_code ignored;
  if (std::filesystem::exists(options.out, ignored) && !options.force)
    throw BadInput({"output.exists", Severity::error, options.out.string(), "there is such a file already",
                    "Name another, or say --force", Fault::cannot_create});
  const Loaded<Pattern> loaded = read_pattern(options.pattern, read);
  for (const Finding& finding : loaded.report.findings)
    if (finding.severity != Severity::note) std::fprintf(stderr, "toile: %s\n", in_words(finding).c_str());
  if (!loaded.value) {
    for (const Finding& finding : loaded.report.findings)
      if (finding.severity == Severity::error) return exit_code(finding.fault);
    return exit_bad_input;
  }
  const Proposal proposal = propose(*loaded.value);
  write_whole_file(options.out, commented(proposal));
  std::printf("%zu seams%s, the least sure %.0f %%; %zu pieces not sewn, %zu not placed; written to %s\n",
              proposal.seams.size(), proposal.garment.empty() ? " by the shapes alone" : (" of a " + proposal.garment).c_str(),
              100 * proposal.least_confidence, proposal.apart.size() + proposal.extras.size(), proposal.unplaced.size(),
              options.out.string().c_str());
  return exit_ok;
}

}  // namespace toile
