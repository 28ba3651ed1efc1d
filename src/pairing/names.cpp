#include "pairing/names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace toile {
namespace {

struct Letter {
  std::string_view from, to;
};

// UTF-8 letters of the templates' languages.
constexpr std::array<Letter, 29> letters{{{"ä", "ae"}, {"ö", "oe"}, {"ü", "ue"}, {"Ä", "Ae"}, {"Ö", "Oe"}, {"Ü", "Ue"},
                                          {"ß", "ss"}, {"é", "e"},  {"è", "e"},  {"ê", "e"},  {"ë", "e"},  {"É", "E"},
                                          {"È", "E"},  {"Ê", "E"},  {"à", "a"},  {"â", "a"},  {"á", "a"},  {"î", "i"},
                                          {"ï", "i"},  {"í", "i"},  {"ì", "i"},  {"ô", "o"},  {"ó", "o"},  {"ò", "o"},
                                          {"û", "u"},  {"ù", "u"},  {"ú", "u"},  {"ç", "c"},  {"ñ", "n"}}};

std::string plain(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto* found = std::find_if(letters.begin(), letters.end(),
                                     [&](const Letter& l) { return text.compare(i, l.from.size(), l.from) == 0; });
    if (found != letters.end()) {
      out += found->to;
      i += found->from.size();
    } else {
      out += text[i++];
    }
  }
  return out;
}

// How well `word` of a list is said by `words`: its length where a word is it, or, for long ones, contains it ("vorderteil").
std::size_t said(const std::vector<std::string>& words, const std::vector<std::string>& list) {
  std::size_t best = 0;
  for (const std::string& wanted : list)
    for (const std::string& word : words) {
      const bool contained = wanted.size() >= 4 && word.find(wanted) != std::string::npos;
      if (word == wanted || contained) best = std::max(best, wanted.size());
    }
  return best;
}

std::string best_of(const std::vector<std::string>& words, const GarmentTemplate& garment,
                    std::initializer_list<const char*> keys) {
  std::string best;
  std::size_t most = 0;
  for (const char* key : keys) {
    const auto list = garment.words.find(key);
    if (list == garment.words.end()) continue;
    const std::size_t length = said(words, list->second);
    if (length > most) {
      most = length;
      best = key;
    }
  }
  return best;
}

}  // namespace

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  std::string word;
  const auto end = [&] {
    if (!word.empty()) words.push_back(word);
    word.clear();
  };
  char before = ' ';
  for (const char c : plain(name)) {
    const auto u = static_cast<unsigned char>(c);
    const auto b = static_cast<unsigned char>(before);
    if (!std::isalnum(u)) {
      end();
    } else {
      if ((std::isupper(u) && std::islower(b)) || (std::isdigit(u) != 0) != (std::isdigit(b) != 0)) end();
      word += static_cast<char>(std::tolower(u));
    }
    before = c;
  }
  end();
  return words;
}

PieceName read_name(const std::string& name, const GarmentTemplate& garment) {
  const std::vector<std::string> words = words_of(name);
  PieceName out;
  std::size_t most = 0;
  for (std::size_t r = 0; r < garment.roles.size(); ++r) {
    const std::size_t length = said(words, garment.roles[r].names);
    if (length > most) {
      most = length;
      out.role = static_cast<int>(r);
      out.said = true;
    }
  }
  out.face = best_of(words, garment, {"front", "back", "side"});
  out.hand = best_of(words, garment, {"left", "right"});
  for (const std::string& word : words)
    if (word.size() <= 6 && std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c); }))
      out.number = std::stoi(word);
  if (out.role < 0 && !out.face.empty())
    for (std::size_t r = 0; r < garment.roles.size(); ++r)
      if (garment.roles[r].is_default) out.role = static_cast<int>(r);
  return out;
}

}  // namespace toile
