#include "cli/proposed_seams.h"

#include <algorithm>
#include <cmath>

#include "formats/garment_template/garment_template.h"
#include "formats/seams/span_text.h"
#include "garment/templates.h"

namespace toile {
namespace {

constexpr double sure_enough = .55;

std::string span_in_words(const Pattern& pattern, EdgeSpan span) {
  if (span.begin > span.end) std::swap(span.begin, span.end);
  span.begin = std::round(span.begin * 1e3) / 1e3;
  span.end = std::round(span.end * 1e3) / 1e3;
  const Piece* piece = find_piece(pattern, span.piece);
  return span_text(span, piece && copies(*piece) == 1);
}

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

}  // namespace

Proposal propose(const Pattern& pattern) {
  return propose_seams(pattern, value_or_throw(read_garment_templates(template_folder("garments"))));
}

std::string in_words(const Pattern& pattern, const ProposedSeam& seam) {
  std::string text = seam.seam.name + " (" + span_in_words(pattern, seam.seam.a) + " to " +
                     span_in_words(pattern, seam.seam.b) + "): " + percent(seam.confidence);
  for (const std::string& reason : seam.reasons) text += ", " + reason;
  return text;
}

bool wants_seams(const Pattern& pattern) {
  int panels = 0;
  for (const Piece& piece : pattern.pieces) panels += piece.sewn ? copies(piece) : 0;
  return pattern.seams.empty() && panels > 1;
}

Pattern with_proposed_seams(const Pattern& pattern, const std::filesystem::path& file, Report& report) {
  const Proposal proposal = propose(pattern);
  std::string unsure;
  for (const ProposedSeam& seam : proposal.seams)
    if (seam.confidence < sure_enough) unsure += (unsure.empty() ? "" : "; ") + in_words(proposal.pattern, seam);
  if (!proposal.apart.empty())
    unsure += (unsure.empty() ? "" : "; ") + std::string("nothing is found to sew ") + listed(proposal.apart) + " to";
  if (!proposal.unplaced.empty())
    unsure += (unsure.empty() ? "" : "; ") + std::string("no place on the body is known for ") + listed(proposal.unplaced);
  if (proposal.seams.empty()) unsure = "no two edges were found that are sewn together";
  if (!unsure.empty())
    throw BadInput({"seams.unsure", Severity::error, file.string(),
                    "nothing says what is sewn to what, and what the program finds itself is not sure enough: " + unsure,
                    "Let `toile sew` write its proposal, correct it, and keep it as " + file.stem().string() +
                        ".seams.toml beside the pattern",
                    Fault::ambiguous});
  for (const ProposedSeam& seam : proposal.seams)
    report.note("seams.proposed", file.filename().string(), in_words(proposal.pattern, seam));
  report.warn("seams.proposed", file.filename().string(),
              "nothing says what is sewn to what: sewn as a " + (proposal.garment.empty() ? "garment" : proposal.garment) +
                  " with " + std::to_string(proposal.seams.size()) + " seams that the program found, the least sure " +
                  percent(proposal.least_confidence),
              "Look at the drape; `toile sew` writes these seams to a file you can correct");
  return proposal.pattern;
}

}  // namespace toile
