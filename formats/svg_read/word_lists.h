#pragma once
// The vocabulary of words.h: lower case, as aama::ascii writes it, words that belong together without blank.

#include <string>
#include <utility>
#include <vector>

#include "formats/svg_read/words.h"

namespace toile::svg {

using WordList = std::vector<std::string>;
bool in_list(const std::string& word, const WordList& list);

extern const WordList little_words;   // say nothing: line, layer, de
extern const WordList program_words;  // begin the names drawing programs give: path, rect
extern const std::vector<std::pair<Role, WordList>> role_words;
extern const WordList cut_words, times_words, pair_words, mirror_words;
extern const std::vector<std::pair<std::string, WordList>> material_words;
extern const WordList allowance_words, with_words, without_words;
extern const std::vector<std::pair<WordList, double>> length_units;  // metres
extern const WordList piece_words, not_names;

}  // namespace toile::svg
