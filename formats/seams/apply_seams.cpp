#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "formats/formats.h"
#include "formats/seams/join.h"
#include "formats/seams/name_edges.h"
#include "formats/seams/seams.h"
#include "formats/seams/sit.h"
#include "garment/units.h"

namespace toile {
namespace {

// The tables of [[`key`]].
std::vector<const TomlNode*> tables_of(const TomlNode& root, const char* key, Sidecar& sidecar) {
  std::vector<const TomlNode*> tables;
  const TomlNode* list = find(root, key);
  if (!list) return tables;
  if (list->kind != TomlKind::array ||
      !std::all_of(list->items.begin(), list->items.end(), [](const TomlNode& n) { return n.kind == TomlKind::table; })) {
    sidecar.report.error("seams.bad-value", sidecar.at(*list), "'" + std::string(key) + "' must be a list of tables",
                         "Begin each with [[" + std::string(key) + "]]");
    return tables;
  }
  for (const TomlNode& item : list->items) tables.push_back(&item);
  return tables;
}

void read_copies(const TomlNode& entry, Piece& piece, Sidecar& sidecar) {
  const TomlNode* as_drawn = find(entry, "copies");
  const TomlNode* mirrored = find(entry, "mirrored_copies");
  if (as_drawn)
    if (const auto count = count_of(*as_drawn, sidecar)) piece.quantity = *count;
  if (mirrored)
    if (const auto count = count_of(*mirrored, sidecar)) piece.mirrored_quantity = *count;
  if ((as_drawn || mirrored) && copies(piece) == 0)
    sidecar.report.error("seam.copies", sidecar.at(as_drawn ? *as_drawn : *mirrored), "piece '" + piece.name + "' is never cut",
                         "Give at least one copy, or leave the piece out of the pattern");
}

void read_hems(const TomlNode& entry, Piece& piece, Sidecar& sidecar) {
  const TomlNode* hems = find(entry, "hems");
  if (!hems) return;
  const auto names = texts_of(*hems, sidecar);
  if (!names) return;
  for (const std::string& name : *names) {
    if (const Edge* edge = edge_by_name(piece, name)) {
      piece.outline[static_cast<std::size_t>(edge - piece.outline.data())].hem = true;
    } else {
      sidecar.report.error("seam.unknown-edge", sidecar.at(*hems), "piece '" + piece.name + "' has no edge '" + name + "'",
                           "Its edges are " + edge_names(piece));
    }
  }
}

void read_allowances(const TomlNode& entry, Piece& piece, Sidecar& sidecar) {
  const auto allowance_of = [&](const TomlNode& node) -> std::optional<double> {
    const auto metres = length_of(node, sidecar);
    if (metres && *metres >= 0) return metres;
    if (metres)
      sidecar.report.error("seams.bad-value", sidecar.at(node), "an allowance cannot be negative",
                           "Write for example \"1 cm\"");
    return std::nullopt;
  };
  if (const TomlNode* all = find(entry, "allowance"))
    if (const auto metres = allowance_of(*all))
      for (Edge& edge : piece.outline) edge.seam_allowance = *metres;
  const TomlNode* table = find(entry, "allowances");
  if (!table) return;
  if (table->kind != TomlKind::table) {
    sidecar.report.error("seams.bad-value", sidecar.at(*table), "'allowances' must be a table from edge names to lengths",
                         "Write for example allowances = { hem = \"3 cm\" }");
    return;
  }
  for (const TomlNode& node : table->items) {
    const Edge* edge = edge_by_name(piece, node.key);
    if (!edge) {
      sidecar.report.error("seam.unknown-edge", sidecar.at(node), "piece '" + piece.name + "' has no edge '" + node.key + "'",
                           "Its edges are " + edge_names(piece));
    } else if (const auto metres = allowance_of(node)) {
      piece.outline[static_cast<std::size_t>(edge - piece.outline.data())].seam_allowance = *metres;
    }
  }
}

void read_piece(const TomlNode& entry, Pattern& pattern, std::set<std::string>& seen, Sidecar& sidecar) {
  refuse_unknown_keys(entry,
                      {"name", "copies", "mirrored_copies", "sewn", "layer", "edges", "start", "hems", "allowance",
                       "allowances", "on", "place"},
                      sidecar.file, "seam.unknown-key", sidecar.report);
  const TomlNode* name_node = find(entry, "name");
  const auto name = name_node ? text_of(*name_node, sidecar) : std::nullopt;
  if (!name) {
    if (!name_node)
      sidecar.report.error("seam.syntax", sidecar.at(entry), "this [[piece]] has no 'name'",
                           "The pieces are " + piece_names(pattern));
    return;
  }
  const Piece* found = piece_by_name(pattern, *name);
  if (!found) {
    sidecar.report.error("seam.unknown-piece", sidecar.at(*name_node), "the pattern has no piece '" + *name + "'",
                         "Its pieces are " + piece_names(pattern));
    return;
  }
  if (!seen.insert(found->name).second) {
    sidecar.report.error("seam.syntax", sidecar.at(*name_node), "piece '" + found->name + "' is described twice",
                         "Put everything about it into one [[piece]]");
    return;
  }
  Piece& piece = pattern.pieces[static_cast<std::size_t>(found - pattern.pieces.data())];
  read_copies(entry, piece, sidecar);
  if (const TomlNode* sewn = find(entry, "sewn"))
    if (const auto is = truth_of(*sewn, sidecar)) piece.sewn = *is;
  if (const TomlNode* layer = find(entry, "layer"))
    if (const auto number = count_of(*layer, sidecar)) piece.layer = *number;
  name_edges(entry, piece, sidecar);
  read_hems(entry, piece, sidecar);
  read_allowances(entry, piece, sidecar);
  sit_on_body(entry, piece, sidecar);
}

void refuse_seams_of_unsewn(const Pattern& pattern, Sidecar& sidecar) {
  for (const Seam& seam : pattern.seams)
    for (const EdgeSpan* span : {&seam.a, &seam.b})
      if (const Piece* piece = find_piece(pattern, span->piece); piece && !piece->sewn)
        sidecar.report.error("seam.not-sewn", sidecar.file,
                             "piece '" + piece->name + "' is sewn in '" + seam.name + "' and is said not to be sewn",
                             "Take 'sewn = false' from the piece, or take away its seams");
}

// A run of an edge that takes part in more than one seam: several pieces in one seam, or a slip.
void look_for_double_seams(const Pattern& pattern, std::size_t first, Sidecar& sidecar) {
  struct Use {
    double low, high;
    std::string seam;
  };
  std::map<std::tuple<std::string, int, std::string>, std::vector<Use>> uses;
  std::set<std::pair<std::string, std::string>> said;  // once for all copies and parts of an edge
  for (std::size_t i = 0; i < pattern.seams.size(); ++i)
    for (const EdgeSpan* span : {&pattern.seams[i].a, &pattern.seams[i].b}) {
      const Use use{std::min(span->begin, span->end), std::max(span->begin, span->end), pattern.seams[i].name};
      auto& others = uses[{span->piece, span->copy, span->edge}];
      for (const Use& other : others)
        if (i >= first && std::min(use.high, other.high) - std::max(use.low, other.low) > 1e-6 &&
            said.emplace(span->piece, span->edge).second)
          sidecar.report.note("seam.edge-twice", sidecar.file,
                              "edge '" + span->edge + "' of piece '" + span->piece + "', copy " + std::to_string(span->copy) +
                                  ", is sewn in '" + other.seam + "' and again in '" + use.seam +
                                  "': the pieces meet in one seam, what is sewn later outside, unless 'layer' says otherwise",
                              "If that is not meant, give each seam its own run, such as [0..1/2] and [1/2..1]");
      others.push_back(use);
    }
}

}  // namespace

Report apply_seams(Pattern& pattern, const std::string& text, const std::string& file) {
  const auto root = parse_toml(text, file);
  if (!root.value) return root.report;
  Sidecar sidecar{file, {}};
  Pattern changed = pattern;
  refuse_unknown_keys(*root.value, {"piece", "seam"}, file, "seam.unknown-key", sidecar.report);
  std::set<std::string> seen;
  for (const TomlNode* entry : tables_of(*root.value, "piece", sidecar)) read_piece(*entry, changed, seen, sidecar);
  // Seams would only repeat what is wrong with the names.
  if (sidecar.report.ok())
    for (const TomlNode* entry : tables_of(*root.value, "seam", sidecar)) add_seams(*entry, changed, sidecar);
  if (sidecar.report.ok()) refuse_seams_of_unsewn(changed, sidecar);
  if (sidecar.report.ok()) {
    look_for_double_seams(changed, pattern.seams.size(), sidecar);
    pattern = std::move(changed);
  }
  return sidecar.report;
}

Report apply_seams(Pattern& pattern, const std::filesystem::path& sidecar) {
  const auto bytes = read_whole_file(sidecar);
  if (!bytes.value) return bytes.report;
  return apply_seams(pattern, *bytes.value, sidecar.filename().string());
}

}  // namespace toile
