#include "formats/obj/island_names.h"

#include <algorithm>
#include <map>
#include <set>

namespace toile {
namespace {

// Words that programs write where nothing was named.
bool says_nothing(const std::string& name) {
  return name.empty() || name == "default" || name == "off" || name == "(null)" || name == "None";
}

std::string most_common(const std::vector<int>& triangles, const std::vector<int>& face, const ObjLines& lines,
                        std::string ObjNames::*level) {
  std::map<std::string, int> count;
  for (const int t : triangles) {
    const auto f = static_cast<std::size_t>(face[static_cast<std::size_t>(t)]);
    ++count[lines.names[static_cast<std::size_t>(lines.names_of_face[f])].*level];
  }
  const auto most =
      std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return says_nothing(most->first) ? std::string() : most->first;
}

}  // namespace

std::vector<std::string> island_names(const std::vector<std::vector<int>>& members, const std::vector<int>& face,
                                      const ObjLines& lines) {
  std::vector<std::string> chosen(members.size());
  bool found = false;
  for (std::string ObjNames::*level : {&ObjNames::group, &ObjNames::object, &ObjNames::material}) {
    std::vector<std::string> names;
    for (const auto& triangles : members) names.push_back(most_common(triangles, face, lines, level));
    const std::set<std::string> distinct(names.begin(), names.end());
    const bool tells_apart = distinct.size() == names.size() && !distinct.contains("");
    if (tells_apart || (!found && distinct != std::set<std::string>{""})) chosen = names;
    found = found || distinct != std::set<std::string>{""};
    if (tells_apart) return chosen;
  }
  std::set<std::string> taken;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const std::string wanted = chosen[i].empty() ? "piece " + std::to_string(i + 1) : chosen[i];
    std::string name = wanted;
    for (int n = 2; taken.contains(name); ++n) name = wanted + "-" + std::to_string(n);
    taken.insert(name);
    chosen[i] = name;
  }
  return chosen;
}

}  // namespace toile
