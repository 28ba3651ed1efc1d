#pragma once
// Papers by name.

#include <string>
#include <string_view>
#include <vector>

namespace toile {

struct Paper {
  std::string_view name;
  double width, length;  // m, upright
};

// ISO A4 to A0, and letter, legal, tabloid, arch-d, arch-e as they are sold in North America; smallest first.
const std::vector<Paper>& papers();

// Upper and lower case alike; nullptr when there is none of that name.
const Paper* find_paper(std::string_view name);

// One page of the sheet's own size: a roll. "none" means the same.
inline constexpr std::string_view roll = "roll";
bool is_roll(std::string_view name);

// "a4, letter, ..., roll", for messages.
std::string paper_names();

}  // namespace toile
