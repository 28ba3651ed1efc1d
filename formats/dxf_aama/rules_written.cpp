#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "formats/dxf_aama/ascii.h"
#include "formats/dxf_aama/profiles.h"
#include "garment/units.h"

namespace toile {
namespace {

using Moves = std::vector<std::array<long, 2>>;  // by size, thousandths of a millimetre

constexpr double digits = 1e6;  // per metre

// Sizes are parted by blanks.
std::string one_word(const std::string& size) {
  std::string word = aama::ascii(size);
  std::replace(word.begin(), word.end(), ' ', '_');
  return word;
}

const OutlinePoint& same_point(const Pattern& other, std::size_t p, std::size_t e, std::size_t i, const Pattern& sample) {
  if (other.pieces.size() != sample.pieces.size() || other.pieces[p].outline.size() != sample.pieces[p].outline.size() ||
      other.pieces[p].outline[e].points.size() != sample.pieces[p].outline[e].points.size())
    throw std::invalid_argument("with_rules: the sizes of piece '" + sample.pieces[p].name + "' have other points");
  return other.pieces[p].outline[e].points[i];
}

}  // namespace

RuledPattern with_rules(const PatternFile& graded, const std::string& name, const DxfProfile& profile) {
  const auto sample = std::find(graded.sizes.begin(), graded.sizes.end(), graded.pattern.sample_size);
  if (sample == graded.sizes.end() || graded.graded.size() != graded.sizes.size())
    throw std::invalid_argument("with_rules: the pattern is of none of its sizes");
  RuledPattern made{graded.graded[static_cast<std::size_t>(sample - graded.sizes.begin())], {}};
  const Pattern base = made.pattern;
  std::map<Moves, int> number{{Moves(graded.sizes.size()), 1}};
  std::vector<Moves> rules{Moves(graded.sizes.size())};
  for (std::size_t p = 0; p < base.pieces.size(); ++p)
    for (std::size_t e = 0; e < base.pieces[p].outline.size(); ++e) {
      auto& points = made.pattern.pieces[p].outline[e].points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        Moves moves;
        for (const Pattern& size : graded.graded) {
          const Eigen::Vector2d by = same_point(size, p, e, i, base).at - points[i].at;
          moves.push_back({std::lround(digits * by.x()), std::lround(digits * by.y())});
        }
        const auto found = number.try_emplace(moves, static_cast<int>(rules.size()) + 1);
        if (found.second) rules.push_back(moves);
        points[i].grade_rule = found.first->second;
      }
    }
  std::string& text = made.table;
  text = std::string(profile.rul_heading) + "\nAUTHOR: Toile\nUNITS: METRIC\nGRADE RULE TABLE: " + one_word(name) +
         "\nNUMBER OF SIZES: " + std::to_string(graded.sizes.size()) + "\nSIZE LIST:";
  for (const std::string& size : graded.sizes) text += " " + one_word(size);
  text += "\nSAMPLE SIZE: " + one_word(graded.pattern.sample_size) + "\n";
  for (std::size_t r = 0; r < rules.size(); ++r) {
    text += "RULE: DELTA " + std::to_string(r + 1) + "\n";
    for (std::size_t s = 0; s < rules[r].size(); ++s) {
      char pair[64];
      std::snprintf(pair, sizeof pair, "  %.3f, %.3f", static_cast<double>(rules[r][s][0]) / 1000,
                    static_cast<double>(rules[r][s][1]) / 1000);
      text += pair;
      if ((s + 1) % static_cast<std::size_t>(profile.pairs_in_line) == 0 || s + 1 == rules[r].size()) text += "\n";
    }
  }
  text += "END\n";
  return made;
}

}  // namespace toile
