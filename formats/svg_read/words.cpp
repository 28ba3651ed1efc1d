#include "formats/svg_read/words.h"

#include <algorithm>
#include <cctype>

#include "formats/dxf_aama/ascii.h"
#include "formats/svg_read/word_lists.h"

namespace toile::svg {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)); }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

std::optional<int> small_number(const std::string& token) {
  if (token.empty() || token.size() > 3 || !std::all_of(token.begin(), token.end(), is_digit)) return {};
  return std::stoi(token);
}

// Lower case ASCII words and numbers: "2xIm-Bruch" -> "2", "xim", "bruch".
std::vector<std::string> tokens_of(const std::string& text) {
  std::vector<std::string> tokens(1);
  for (const char c : aama::ascii(text)) {
    const bool breaks = !tokens.back().empty() && is_digit(tokens.back().back()) != is_digit(c);
    if (!is_letter(c) && !is_digit(c)) {
      if (!tokens.back().empty()) tokens.emplace_back();
      continue;
    }
    if (breaks) tokens.emplace_back();
    tokens.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  if (tokens.back().empty()) tokens.pop_back();
  return tokens;
}

bool any_of(const std::vector<std::string>& tokens, const WordList& list) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    std::string joined;
    for (std::size_t k = i; k < std::min(i + 3, tokens.size()); ++k)
      if (in_list(joined += tokens[k], list)) return true;
  }
  return false;
}

}  // namespace

bool in_list(const std::string& word, const WordList& list) { return std::find(list.begin(), list.end(), word) != list.end(); }

Role role_in_words(const std::string& name) {
  std::string joined;
  int words = 0;
  for (const std::string& token : tokens_of(name)) {
    if (in_list(token, little_words) || is_digit(token[0])) continue;
    joined += token;
    ++words;
  }
  if (words == 0 || words > 4) return Role::unknown;
  for (const auto& [role, list] : role_words)
    if (in_list(joined, list)) return role;
  return Role::unknown;
}

bool speaks_of(const std::string& words, Role role) {
  const std::vector<std::string> tokens = tokens_of(words);
  for (const auto& [each, list] : role_words)
    if (each == role && any_of(tokens, list)) return true;
  return false;
}

std::optional<CutText> cut_text(const std::string& words) {
  if (words.size() > 200) return {};
  const std::vector<std::string> tokens = tokens_of(words);
  CutText text;
  std::optional<int> count;
  bool says_cut = false, pairs = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string& token = tokens[i];
    const auto number_at = [&](std::size_t k) { return k < tokens.size() ? small_number(tokens[k]) : std::nullopt; };
    if (in_list(token, cut_words)) {
      says_cut = true;
      for (const std::size_t k : {i + 1, i + 2, i - 1, i - 2})
        if (!count) count = number_at(k);
    }
    if (in_list(token, times_words)) {
      const std::optional<int> before = i > 0 ? number_at(i - 1) : std::nullopt;
      if (!count) count = before ? before : token == "x" ? number_at(i + 1) : std::nullopt;
    }
    if (in_list(token, pair_words)) {
      pairs = text.mirrored = true;
      const std::optional<int> before = i > 0 ? number_at(i - 1) : std::nullopt;
      if (!count)
        count = before.value_or(1) * 2;
      else if (before && i >= 2 && in_list(tokens[i - 2], cut_words))
        count = *before * 2;
    }
    if (in_list(token, mirror_words)) text.mirrored = true;
    if (text.material.empty())
      for (const auto& [material, list] : material_words)
        if (in_list(token, list)) text.material = material;
  }
  text.on_fold = speaks_of(words, Role::fold);
  const bool times_in_fold = count && !says_cut && (text.on_fold || pairs || text.mirrored);
  const bool only_times = count && tokens.size() <= 3;
  if (!count && says_cut && text.on_fold) count = 1;
  if (!count || *count < 1 || *count > 200 || (!says_cut && !times_in_fold && !only_times)) return {};
  text.copies = *count;
  return text;
}

std::vector<double> lengths_in(const std::string& words) {
  std::vector<double> lengths;
  std::string plain = words;
  for (const char* quote : {"\xe2\x80\x9c", "\xe2\x80\x9d", "\xe2\x80\xb3", "\""})
    for (std::size_t at; (at = plain.find(quote)) != std::string::npos;) plain.replace(at, std::string(quote).size(), " in ");
  const std::string text = aama::ascii(plain);
  for (std::size_t i = 0; i < text.size();) {
    if (!is_digit(text[i])) {
      ++i;
      continue;
    }
    double value = 0, part = 1;
    bool fraction = false;
    for (; i < text.size() && (is_digit(text[i]) || (!fraction && (text[i] == '.' || text[i] == ',') && i + 1 < text.size() &&
                                                     is_digit(text[i + 1])));
         ++i) {
      if (!is_digit(text[i])) {
        fraction = true;
        continue;
      }
      if (fraction)
        value += (part /= 10) * (text[i] - '0');
      else
        value = std::min(10 * value + (text[i] - '0'), 1e9);
    }
    if (i + 1 < text.size() && text[i] == '/' && is_digit(text[i + 1]) && text[i + 1] != '0') {
      double below = 0;
      for (++i; i < text.size() && is_digit(text[i]); ++i) below = std::min(10 * below + (text[i] - '0'), 1e9);
      if (below > 0) value /= below;
    }
    while (i < text.size() && text[i] == ' ') ++i;
    std::string unit;
    for (std::size_t k = i; k < text.size() && is_letter(text[k]); ++k) unit += static_cast<char>(std::tolower(text[k]));
    for (const auto& [names, metres] : length_units)
      if (in_list(unit, names)) lengths.push_back(value * metres);
  }
  return lengths;
}

std::optional<AllowanceText> allowance_text(const std::string& words) {
  const std::vector<std::string> tokens = tokens_of(words);
  if (!any_of(tokens, allowance_words)) return {};
  AllowanceText text;
  const std::vector<double> lengths = lengths_in(words);
  const bool without = any_of(tokens, without_words);
  const bool with = any_of(tokens, with_words);
  if (!without && !with && lengths.empty()) return {};
  text.included = !without;
  for (const double length : lengths)
    if (text.included && text.width == 0 && length >= 2e-3 && length <= 80e-3) text.width = length;
  return text;
}

int name_worth(const std::string& words) {
  if (words.size() > 60) return 0;
  const std::vector<std::string> tokens = tokens_of(without_key(words));
  std::size_t letters = 0;
  for (const std::string& token : tokens)
    if (is_letter(token[0])) letters += token.size();
  if (letters == 0) return 0;
  if (cut_text(words) || allowance_text(words) || role_in_words(words) != Role::unknown) return 0;
  if (any_of(tokens, not_names) || speaks_of(words, Role::grain) || !lengths_in(words).empty()) return 0;
  if (letters < 3) return 1;
  int worth = tokens.size() <= 5 ? 10 : 3;
  for (const std::string& token : tokens)
    for (const std::string& piece : piece_words)
      if (token == piece || (piece.size() >= 5 && token.find(piece) != std::string::npos))
        worth = std::max(worth, tokens.size() <= 4 ? 100 : 30);
  return worth;
}

bool is_given_name(const std::string& name) {
  const std::vector<std::string> tokens = tokens_of(name);
  if (tokens.empty() || role_in_words(name) != Role::unknown) return false;
  std::size_t letters = 0;
  for (const std::string& token : tokens)
    if (is_letter(token[0]) && !in_list(token, little_words) && !in_list(token, program_words)) letters += token.size();
  return letters >= 2;
}

std::string without_key(const std::string& words) {
  std::string text = words;
  // A translation key has no blank before its colon: "aaron:armBinding".
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos && colon + 1 < text.size() && text[colon + 1] != ' ' && text.find(' ') > colon)
    text.erase(0, colon + 1);
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

}  // namespace toile::svg
