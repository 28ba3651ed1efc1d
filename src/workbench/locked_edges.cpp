#include "workbench/locked_edges.h"

#include "garment/report.h"

namespace toile {

void lock_edges(Pattern& pattern, const std::vector<std::string>& names, const std::string& place) {
  for (const std::string& name : names) {
    bool found = false;
    std::string known;
    for (Piece& piece : pattern.pieces)
      for (Edge& edge : piece.outline) {
        const std::string full = piece.name + "." + edge.id;
        known += (known.empty() ? "" : ", ") + full;
        if (name != edge.id && name != full) continue;
        edge.locked = true;
        found = true;
      }
    if (!found)
      throw BadInput({"adjust.unknown-edge", Severity::error, place + ", adjust.locked",
                      "the pattern has no edge '" + name + "'", "There are: " + known});
  }
}

}  // namespace toile
