#include "formats/svg_read/line_roles.h"

#include <algorithm>

namespace toile::svg {
namespace {

const Group& group_at(const Drawing& drawing, int group) { return drawing.groups[static_cast<std::size_t>(group)]; }

// "url(#grainlineFrom)" -> grain.
Role role_of_marker(const std::string& marker) {
  const std::size_t begin = marker.find('#');
  if (begin == std::string::npos) return Role::unknown;
  std::string id = marker.substr(begin + 1, marker.find_first_of(")\"'", begin) - begin - 1);
  for (const char* end : {"From", "To", "Start", "End", "-start", "-end"})
    if (const std::size_t size = std::string(end).size(); id.size() > size && id.compare(id.size() - size, size, end) == 0)
      return role_in_words(id.substr(0, id.size() - size));
  return role_in_words(id);
}

Role role_by_data(const Names& names) {
  for (const char* key : {"type", "role", "kind", "line"})
    if (const std::string value = names.datum(key); !value.empty())
      if (const Role role = role_in_words(value); role != Role::unknown) return role;
  return Role::unknown;
}

Role role_by_names(const Names& names) {
  if (const Role role = role_by_data(names); role != Role::unknown) return role;
  for (const std::string& name : {names.label, names.id})
    if (const Role role = role_in_words(name); role != Role::unknown) return role;
  for (const std::string& name : names.classes)
    if (const Role role = role_in_words(name); role != Role::unknown) return role;
  return Role::unknown;
}

// FreeSewing's classes: a material alone is the sew line, with "sa" the cut line; with a line style it is something inside.
Role freesewing_role(const DrawnLine& line) {
  const auto has = [&](std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* name) { return line.names.has_class(name); });
  };
  if (has({"scalebox"})) return Role::test_square;
  if (has({"sa"})) return Role::cut;
  const bool styled =
      has({"help", "dashed", "dotted", "lashed", "hidden", "stroke-xs", "stroke-sm", "mark", "note", "contrast", "bartack"});
  if (has({"fabric", "lining", "canvas", "interfacing", "various"}) && !styled) return Role::sew;
  return Role::internal;
}

}  // namespace

int piece_group(const Drawing& drawing, int group, const Producer& producer) {
  for (; group > 0; group = group_at(drawing, group).parent) {
    const Names& names = group_at(drawing, group).names;
    if (producer.dialect == "FreeSewing" && names.id.find("-part-") != std::string::npos) return group;
    if (role_in_words(names.datum("type")) == Role::piece) return group;
  }
  return -1;
}

std::vector<Role> line_roles(const Drawing& drawing, const Producer& producer) {
  std::vector<Role> roles;
  for (const DrawnLine& line : drawing.lines) {
    Role role = role_by_data(line.names);
    for (const std::string& marker : {line.marker_start, line.marker_end})
      if (const Role marked = role_of_marker(marker); role == Role::unknown && (marked == Role::grain || marked == Role::fold))
        role = marked;
    if (role == Role::unknown && producer.dialect == "FreeSewing") role = freesewing_role(line);
    if (role == Role::unknown) role = role_by_names(line.names);
    for (int group = line.group; role == Role::unknown && group > 0; group = group_at(drawing, group).parent) {
      role = role_by_names(group_at(drawing, group).names);
      if (role == Role::piece) role = Role::unknown;
    }
    roles.push_back(role == Role::piece ? Role::unknown : role);
  }
  for (const std::size_t i : test_squares(drawing)) roles[i] = Role::test_square;
  return roles;
}

}  // namespace toile::svg
