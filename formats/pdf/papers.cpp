#include "formats/pdf/papers.h"

#include <algorithm>
#include <cctype>

namespace toile {
namespace {

constexpr double inch = 25.4e-3;  // m

bool same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

}  // namespace

const std::vector<Paper>& papers() {
  static const std::vector<Paper> all{
      {"a4", .210, .297},
      {"letter", 8.5 * inch, 11 * inch},
      {"legal", 8.5 * inch, 14 * inch},
      {"a3", .297, .420},
      {"tabloid", 11 * inch, 17 * inch},
      {"a2", .420, .594},
      {"a1", .594, .841},
      {"arch-d", 24 * inch, 36 * inch},
      {"a0", .841, 1.189},
      {"arch-e", 36 * inch, 48 * inch},
  };
  return all;
}

const Paper* find_paper(std::string_view name) {
  for (const Paper& paper : papers())
    if (same(paper.name, name)) return &paper;
  return nullptr;
}

bool is_roll(std::string_view name) { return same(name, roll) || same(name, "none"); }

std::string paper_names() {
  std::string names;
  for (const Paper& paper : papers()) names += std::string(paper.name) + ", ";
  return names + std::string(roll);
}

}  // namespace toile
