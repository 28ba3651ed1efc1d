#include "formats/dxf_aama/nest.h"

#include <algorithm>
#include <map>
#include <set>

#include "formats/dxf/tags.h"
#include "formats/dxf_aama/layers.h"

namespace toile::aama {
namespace {

bool is_outline(const dxf::Entity& entity) {
  if (entity.kind != dxf::Kind::line && entity.kind != dxf::Kind::polyline) return false;
  const Role role = role_of(entity.layer);
  return role == Role::cut_line || role == Role::sew_line || role == Role::dense_cut_line || role == Role::dense_sew_line;
}

// How much of what only sample sizes have a block has.
std::ptrdiff_t details(const dxf::Block& block) {
  return std::count_if(block.entities.begin(), block.entities.end(), [](const dxf::Entity& e) {
    const Role role = role_of(e.layer);
    return role == Role::turn_point || role == Role::curve_point || role == Role::notch;
  });
}

std::string place(const std::string& file, const PieceBlock& piece) {
  return file + ":" + std::to_string(piece.block->line) + ", piece '" + piece.name + "'";
}

std::size_t sample_of(const PieceGroup& group, const StyleTexts& style, const std::string& file, Report& report) {
  const std::vector<PieceBlock>& sizes = group.sizes;
  if (sizes.size() == 1) return 0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (!style.sample_size.empty() && dxf::same_word(sizes[i].texts.size, style.sample_size)) return i;
  const auto richest = std::max_element(sizes.begin(), sizes.end(), [](const PieceBlock& a, const PieceBlock& b) {
    return details(*a.block) < details(*b.block);
  });
  report.warn(
      "aama.sample-size", place(file, *richest),
      "none of its sizes is the style's sample size '" + style.sample_size + "'; size '" + richest->texts.size + "' is read",
      "set the sample size in the pattern program");
  return static_cast<std::size_t>(richest - sizes.begin());
}

// Blocks without a piece name go by their own; programs that write the same for several leave us to count.
void name_unnamed(std::vector<PieceBlock>& pieces, const std::string& file, Report& report) {
  std::set<std::string> taken;
  for (const PieceBlock& piece : pieces) taken.insert(piece.texts.name);
  for (PieceBlock& piece : pieces) {
    if (!piece.texts.name.empty()) continue;
    const std::string base = piece.block->name.empty() ? "piece" : piece.block->name;
    piece.name = base;
    for (int i = 2; !taken.insert(piece.name).second; ++i) piece.name = base + "-" + std::to_string(i);
    if (piece.name != base)
      report.warn("aama.piece-renamed", place(file, piece),
                  "another piece or block is called '" + base + "' too; this one is now '" + piece.name + "'",
                  "name the pieces in the pattern program");
  }
}

// "FRONT_38" of the piece "front": size 38, when no text says it.
void size_by_block_name(PieceBlock& piece) {
  const std::string& block = piece.block->name;
  const std::size_t length = piece.texts.name.size();
  if (!piece.texts.size.empty() || length == 0 || block.size() < length + 2) return;
  if (!dxf::same_word(block.substr(0, length), piece.texts.name) || (block[length] != '_' && block[length] != '-')) return;
  piece.texts.size = block.substr(length + 1);
}

// What only some sizes say holds for all (AccuMark: the sample size alone has the quantity).
void complete_texts(PieceGroup& group) {
  PieceTexts& to = group.sizes[group.sample].texts;
  for (const PieceBlock& other : group.sizes) {
    const PieceTexts& from = other.texts;
    if (to.material.empty()) to.material = from.material;
    if (to.annotations.empty()) to.annotations = from.annotations;
    if (to.quantity || !from.quantity) continue;
    to.quantity = from.quantity;
    to.mirrored = from.mirrored;
    to.quantity_text = from.quantity_text;
  }
}

}  // namespace

bool has_outline(const dxf::Block& block) { return std::any_of(block.entities.begin(), block.entities.end(), is_outline); }

std::vector<PieceGroup> piece_groups(const std::vector<dxf::Block>& blocks, const StyleTexts& style, const std::string& file,
                                     Report& report) {
  std::vector<PieceBlock> pieces;
  for (const dxf::Block& block : blocks) {
    if (!has_outline(block)) continue;
    PieceTexts texts = piece_texts(block.entities);
    std::string name = texts.name;
    pieces.push_back({&block, std::move(name), std::move(texts)});
    size_by_block_name(pieces.back());
  }
  name_unnamed(pieces, file, report);

  // A second block of one name and size is another piece.
  std::vector<PieceGroup> groups;
  std::set<std::string> names;
  for (const PieceBlock& piece : pieces) names.insert(piece.name);
  std::map<std::string, std::vector<std::size_t>> of_name;
  for (PieceBlock& piece : pieces) {
    std::vector<std::size_t>& alike = of_name[piece.name];
    const auto open = std::find_if(alike.begin(), alike.end(), [&](std::size_t i) {
      return std::none_of(groups[i].sizes.begin(), groups[i].sizes.end(),
                          [&](const PieceBlock& other) { return other.texts.size == piece.texts.size; });
    });
    if (open != alike.end()) {
      groups[*open].sizes.push_back(std::move(piece));
      continue;
    }
    std::string name = piece.name;
    if (!alike.empty()) {
      for (int i = 2; !names.insert(name).second; ++i) name = piece.name + "-" + std::to_string(i);
      report.warn("aama.piece-renamed", place(file, piece),
                  "two pieces are called '" + piece.name + "'" +
                      (piece.texts.size.empty() ? "" : " in size " + piece.texts.size) + "; this one is now '" + name + "'",
                  "name the pieces in the pattern program");
    }
    alike.push_back(groups.size());
    groups.push_back({name, {std::move(piece)}, 0});
  }
  for (PieceGroup& group : groups) {
    group.sample = sample_of(group, style, file, report);
    complete_texts(group);
  }
  return groups;
}

std::vector<std::string> sizes_of(const std::vector<PieceGroup>& groups) {
  std::vector<std::string> sizes;
  for (const PieceGroup& group : groups)
    for (const PieceBlock& piece : group.sizes)
      if (!piece.texts.size.empty() && std::find(sizes.begin(), sizes.end(), piece.texts.size) == sizes.end())
        sizes.push_back(piece.texts.size);
  return sizes;
}

}  // namespace toile::aama
