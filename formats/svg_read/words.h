#pragma once
// What layer names and texts on a pattern mean, in English, German, French, Spanish, Italian and Dutch.

#include <optional>
#include <string>
#include <vector>

namespace toile::svg {

enum class Role {
  unknown,
  cut,
  sew,
  internal,
  cut_out,
  grain,
  notch,
  fold,
  drill,
  dart,
  text,
  page,
  test_square,
  decoration,
  piece
};

// Of a name such as "Cutting line", "NAHTLINIE", "droit fil", "seam-allowance", "layer: CUT": unknown unless the whole name,
// but for words like "line" and "layer" and numbers, is one thing.
Role role_in_words(const std::string& name);
// Whether a sentence speaks of a fold, of the grain.
bool speaks_of(const std::string& words, Role role);

// "Cut 2 (1 pair)", "2x im Stoffbruch zuschneiden", "couper 1 fois au pli", "plugin-annotations:cut,2,...:mirrored".
struct CutText {
  int copies = 1;  // all, mirrored ones too
  bool mirrored = false;
  bool on_fold = false;
  std::string material;  // empty: not said
};
std::optional<CutText> cut_text(const std::string& words);

// What a text says of the seam allowance.
struct AllowanceText {
  bool included = false;  // the drawn line has it
  double width = 0;       // m, 0: not said
};
std::optional<AllowanceText> allowance_text(const std::string& words);

// Lengths with their unit in a text, m: "10cm x 5cm" is .1, .05; also 4" x 2".
std::vector<double> lengths_in(const std::string& words);

// How well a text would do as the name of a piece; 0: not at all. Names of pieces (front, Ärmel, manche, ...) do best.
int name_worth(const std::string& words);
// Whether an id or label was given by a person: not "path12", "g-3", "Layer 1", "rect4567".
bool is_given_name(const std::string& name);
// "plugin-annotations:cut" -> "cut", "aaron:armBinding" -> "armBinding"; blanks trimmed.
std::string without_key(const std::string& words);

}  // namespace toile::svg
