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

// All blocks of one piece; the one to read.
class Nest {
 public:
  Nest(std::vector<PieceBlock> sizes, const StyleTexts& style, const std::string& file, Report& report)
      : sizes_(std::move(sizes)), style_(style), file_(file), report_(report) {}

  const PieceBlock& sample() {
    if (sizes_.size() == 1) return sizes_.front();
    std::vector<const PieceBlock*> found;
    for (const PieceBlock& piece : sizes_)
      if (!style_.sample_size.empty() && dxf::same_word(piece.texts.size, style_.sample_size)) found.push_back(&piece);
    if (found.size() > 1) duplicate(*found[0], *found[1]);
    if (!found.empty()) return *found.front();
    std::set<std::string> seen;
    for (const PieceBlock& piece : sizes_)
      if (!seen.insert(piece.texts.size).second) {
        duplicate(sizes_.front(), piece);
        return sizes_.front();
      }
    const auto richest = std::max_element(sizes_.begin(), sizes_.end(), [](const PieceBlock& a, const PieceBlock& b) {
      return details(*a.block) < details(*b.block);
    });
    report_.warn(
        "aama.sample-size", place(file_, *richest),
        "none of its sizes is the style's sample size '" + style_.sample_size + "'; size '" + richest->texts.size + "' is read",
        "set the sample size in the pattern program");
    return *richest;
  }

 private:
  void duplicate(const PieceBlock& a, const PieceBlock& b) {
    report_.error("aama.duplicate-piece", place(file_, b),
                  "two pieces are called '" + a.name + "'" + (a.texts.size.empty() ? "" : " in size " + a.texts.size) +
                      "; the other is at line " + std::to_string(a.block->line),
                  "give each piece a name of its own");
  }

  std::vector<PieceBlock> sizes_;
  const StyleTexts& style_;
  const std::string& file_;
  Report& report_;
};

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

}  // namespace

std::vector<PieceBlock> sample_size_blocks(const dxf::Drawing& drawing, const StyleTexts& style, const std::string& file,
                                           Report& report) {
  std::vector<PieceBlock> pieces;
  for (const dxf::Block& block : drawing.blocks) {
    if (std::none_of(block.entities.begin(), block.entities.end(), is_outline)) continue;
    PieceTexts texts = piece_texts(block.entities);
    std::string name = texts.name;
    pieces.push_back({&block, std::move(name), std::move(texts)});
  }
  if (pieces.empty()) {
    report.error("aama.no-piece", file,
                 drawing.entities.empty()
                     ? "the file has no pattern piece: no block has an outline on layer 1"
                     : "the file has no pattern piece: it is a flat drawing, its lines are in no block with layer 1",
                 "export as DXF-AAMA or DXF-ASTM (one block per piece, boundary on layer 1)");
    return {};
  }
  name_unnamed(pieces, file, report);

  std::vector<std::string> order;
  std::map<std::string, std::vector<PieceBlock>> by_name;
  for (PieceBlock& piece : pieces) {
    if (by_name.find(piece.name) == by_name.end()) order.push_back(piece.name);
    by_name[piece.name].push_back(std::move(piece));
  }
  std::vector<PieceBlock> chosen;
  std::vector<std::string> ignored;  // sizes, in file order
  for (const std::string& name : order) {
    std::vector<PieceBlock>& sizes = by_name[name];
    chosen.push_back(Nest(sizes, style, file, report).sample());
    for (const PieceBlock& piece : sizes)
      if (piece.texts.size != chosen.back().texts.size &&
          std::find(ignored.begin(), ignored.end(), piece.texts.size) == ignored.end())
        ignored.push_back(piece.texts.size);
  }
  if (!ignored.empty()) {
    std::string list;
    for (const std::string& size : ignored) list += (list.empty() ? "" : ", ") + (size.empty() ? "(no size)" : size);
    report.note("aama.sizes-ignored", file,
                "a nest: size '" + chosen.front().texts.size + "' is read, the others are not: " + list);
  }
  return chosen;
}

}  // namespace toile::aama
