#include "formats/svg_read/label.h"

#include <algorithm>

namespace toile::svg {
namespace {

// "fs-stack-penelope.back-part-penelope.back" -> "back".
std::string last_part(const std::string& id) {
  const std::size_t part = id.rfind("-part-");
  const std::string name = part == std::string::npos ? id : id.substr(part + 6);
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || dot + 1 == name.size() ? name : name.substr(dot + 1);
}

bool is_decoration(const DrawnText& text, const Producer& producer) {
  if (producer.dialect != "FreeSewing") return false;
  const std::string& words = text.words;
  return words.find("ephemeral") != std::string::npos || words.find("FreeSewing") == 0 ||
         words.find("plugin-annotations:support") == 0 || words.find("plugin-annotations:theWhite") == 0 ||
         words.find("plugin-annotations:theBlack") == 0;
}

// The best name among the texts: the worthiest, then the bold, then the largest, then the first.
const DrawnText* best_text(const Drawing& drawing, const PieceParts& parts, const Producer& producer) {
  const DrawnText* best = nullptr;
  int best_worth = 0;
  for (const std::size_t i : parts.texts) {
    const DrawnText& text = drawing.texts[i];
    if (is_decoration(text, producer)) continue;
    int worth = name_worth(text.words);
    // FreeSewing's title block: the name is its large bold line.
    if (producer.dialect == "FreeSewing" && worth > 0) worth = text.names.has_class("text-lg") && text.bold ? 1000 : 0;
    if (worth == 0) continue;
    worth += text.bold ? 1 : 0;
    if (!best || worth > best_worth || (worth == best_worth && text.size > 1.02 * best->size)) {
      best = &text;
      best_worth = worth;
    }
  }
  return best;
}

// The label or id of a group that holds this piece and, but for lines, nothing else, or of its outline.
std::string name_by_groups(const Drawing& drawing, const PieceParts& parts) {
  const auto named = [](const Names& names) -> std::string {
    for (const std::string& name : {names.datum("piece"), names.datum("name"), names.label, names.id})
      if (is_given_name(name)) return name;
    return {};
  };
  for (const Ring& ring : parts.rings)
    for (const std::size_t i : ring.lines)
      if (const std::string name = named(drawing.lines[i].names); !name.empty()) return name;
  if (parts.rings.empty() || parts.rings.front().lines.empty()) return {};
  for (int group = drawing.lines[parts.rings.front().lines.front()].group; group > 0;
       group = drawing.groups[static_cast<std::size_t>(group)].parent) {
    const Names& names = drawing.groups[static_cast<std::size_t>(group)].names;
    if (const std::string name = named(names); !name.empty()) return name;
  }
  return {};
}

}  // namespace

Label label_of(const Drawing& drawing, const PieceParts& parts, const Producer& producer) {
  Label label;
  const DrawnText* title = best_text(drawing, parts, producer);
  if (parts.group >= 0) {
    const Names& names = drawing.groups[static_cast<std::size_t>(parts.group)].names;
    for (const std::string& name : {names.datum("piece"), names.datum("name")})
      if (label.name.empty()) label.name = name;
  }
  if (label.name.empty() && title) label.name = without_key(title->words);
  if (label.name.empty() && parts.group >= 0)
    label.name = last_part(drawing.groups[static_cast<std::size_t>(parts.group)].names.id);
  if (label.name.empty()) label.name = name_by_groups(drawing, parts);

  for (const std::size_t i : parts.texts) {
    const DrawnText& text = drawing.texts[i];
    const std::optional<CutText> cut = cut_text(text.words);
    const std::optional<AllowanceText> allowance = allowance_text(text.words);
    const bool fold = speaks_of(text.words, Role::fold) && (cut || role_in_words(text.words) == Role::fold),
               grain = speaks_of(text.words, Role::grain);
    if (fold && (!label.fold_at || !cut)) label.fold_at = text.at;
    if (grain) label.grain_at.push_back(text.at);
    if (allowance && (!label.allowance || label.allowance->width == 0)) label.allowance = allowance;
    if (fold && !cut) label.cut.on_fold = true;
    if (cut) {
      // Cut from several materials: the cloth the garment is made of, else the first.
      const bool better = !label.says_cut || (cut->material == "fabric" && label.cut.material != "fabric");
      const bool on_fold = label.cut.on_fold || cut->on_fold;
      if (better) label.cut = *cut;
      label.cut.on_fold = on_fold;
      label.says_cut = true;
    }
    if (&text == title || is_decoration(text, producer)) continue;
    if ((!cut && !fold && !grain) || allowance) label.annotations.push_back(text.words);
    if (cut && (text.words.size() > 60 || cut->material != label.cut.material)) label.annotations.push_back(text.words);
  }
  return label;
}

}  // namespace toile::svg
