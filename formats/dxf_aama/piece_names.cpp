#include "formats/dxf_aama/piece_names.h"

#include <algorithm>
#include <map>

#include "formats/dxf_aama/ascii.h"
#include "formats/formats.h"

namespace toile {
namespace aama {

std::string unique_name(const std::string& wanted, std::vector<std::string>& taken, std::size_t longest) {
  std::string name = wanted;
  for (int i = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++i) {
    const std::string ending = "-" + std::to_string(i);
    name = wanted.substr(0, longest - ending.size()) + ending;
  }
  taken.push_back(name);
  return name;
}

std::vector<NamedPiece> named_pieces(const CutSheet& sheet) {
  std::vector<NamedPiece> pieces;
  std::map<std::string, std::vector<std::string>> taken;  // by size
  for (const PlacedPiece& placed : sheet.placed) {
    const CutPiece& cut = placed.cut;
    if (std::any_of(pieces.begin(), pieces.end(), [&](const NamedPiece& other) { return *other.piece == cut; })) continue;
    const std::string wanted = ascii(cut.piece.name);
    pieces.push_back({&cut, unique_name(wanted.empty() ? "piece" : wanted, taken[cut.size], 250)});
  }
  return pieces;
}

}  // namespace aama

Pattern as_named_in_dxf(Pattern pattern, const CutSheet& sheet) {
  std::map<std::string, std::string> written;
  for (const aama::NamedPiece& named : aama::named_pieces(sheet)) written.emplace(named.piece->piece.name, named.name);
  const auto rename = [&](std::string& name) {
    if (const auto found = written.find(name); found != written.end()) name = found->second;
  };
  for (Piece& piece : pattern.pieces) rename(piece.name);
  for (Seam& seam : pattern.seams) {
    rename(seam.a.piece);
    rename(seam.b.piece);
  }
  return pattern;
}

}  // namespace toile
