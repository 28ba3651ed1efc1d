#include "cli/unsewn.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace toile {

std::vector<Piece> take_unsewn(Pattern& pattern) {
  const auto first =
      std::stable_partition(pattern.pieces.begin(), pattern.pieces.end(), [](const Piece& piece) { return piece.sewn; });
  std::vector<Piece> unsewn(std::make_move_iterator(first), std::make_move_iterator(pattern.pieces.end()));
  pattern.pieces.erase(first, pattern.pieces.end());
  return unsewn;
}

Report set_unsewn_apart(Pattern& pattern, const std::filesystem::path& file, std::vector<Piece>& unsewn) {
  Report report;
  std::vector<Piece> taken = take_unsewn(pattern);
  if (taken.empty()) return report;
  std::string names;
  for (const Piece& piece : taken) names += (names.empty() ? "'" : ", '") + piece.name + "'";
  report.warn("pieces.not-sewn", file.filename().string(),
              "not draped, since they lie on other pieces or bind their edges: " + names,
              "They are on the cut sheet as they were: change them by hand to the new lengths");
  unsewn.insert(unsewn.end(), std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end()));
  return report;
}

}  // namespace toile
