#include "formats/obj/panel_copies.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace toile {
namespace {

constexpr double alike_within = 2e-8;  // m, twice the digits written

// "gore:3" is 3; 0 when there is no number.
int copy_number(const std::string& name, std::size_t colon) {
  int number = 0;
  const char* end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + colon + 1, end, number);
  return read.ec == std::errc() && read.ptr == end && number > 0 ? number : 0;
}

bool alike(const Island& a, const Island& b, bool mirrored) {
  if (a.flat.cols() != b.flat.cols() || a.triangles.cols() != b.triangles.cols() || a.turned_over != b.turned_over)
    return false;
  const Eigen::Vector2d side(mirrored ? -1 : 1, 1);
  return ((side.asDiagonal() * a.flat) - b.flat).cwiseAbs().maxCoeff() <= alike_within;
}

}  // namespace

std::vector<PanelCopies> panel_copies(const std::vector<Island>& islands) {
  std::map<std::string, std::map<int, int>> families;  // name, number of the copy, island
  for (std::size_t i = 0; i < islands.size(); ++i)
    if (const auto colon = islands[i].name.rfind(':'); colon != std::string::npos && colon > 0)
      if (const int number = copy_number(islands[i].name, colon))
        families[islands[i].name.substr(0, colon)][number] = static_cast<int>(i);

  std::map<int, PanelCopies> by_first;
  std::vector<bool> taken(islands.size(), false);
  for (const auto& [name, members] : families) {
    const bool alone =
        std::none_of(islands.begin(), islands.end(), [&, &wanted = name](const Island& i) { return i.name == wanted; });
    if (!alone || members.begin()->first != 1 || members.rbegin()->first != static_cast<int>(members.size())) continue;
    PanelCopies copies{name, {}, 0};
    const Island& first = islands[static_cast<std::size_t>(members.begin()->second)];
    for (const auto& [number, i] : members) {
      const Island& island = islands[static_cast<std::size_t>(i)];
      const bool as_drawn = copies.mirrored == 0 && alike(first, island, false);
      if (!as_drawn && !alike(first, island, true)) break;
      copies.mirrored += !as_drawn;
      copies.islands.push_back(i);
    }
    if (copies.islands.size() != members.size()) continue;
    for (const int i : copies.islands) taken[static_cast<std::size_t>(i)] = true;
    by_first[*std::min_element(copies.islands.begin(), copies.islands.end())] = copies;
  }
  for (std::size_t i = 0; i < islands.size(); ++i)
    if (!taken[i]) by_first[static_cast<int>(i)] = {islands[i].name, {static_cast<int>(i)}, 0};
  std::vector<PanelCopies> all;
  for (auto& [first, copies] : by_first) all.push_back(std::move(copies));
  return all;
}

}  // namespace toile
