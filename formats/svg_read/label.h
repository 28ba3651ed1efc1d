#pragma once
// What is written on a piece: its name, how often and from what it is cut, what its lines include.

#include <optional>
#include <string>
#include <vector>

#include "formats/svg_read/grouping.h"
#include "formats/svg_read/words.h"

namespace toile::svg {

struct Label {
  std::string name;  // empty: none found
  CutText cut;
  bool says_cut = false;
  std::optional<AllowanceText> allowance;
  std::optional<Eigen::Vector2d> fold_at;  // of a text that speaks of the fold
  std::vector<Eigen::Vector2d> grain_at;   // of texts that speak of the grain
  std::vector<std::string> annotations;    // all texts but name, quantity and those of fold and grain
};

Label label_of(const Drawing& drawing, const PieceParts& parts, const Producer& producer);

}  // namespace toile::svg
