#include "formats/seams/name_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "garment/units.h"

namespace toile {
namespace {

constexpr double nearest_corner_within = 5e-3;  // m, of a start given by coordinates
constexpr double smooth_join = 10 * units::degree;

const Eigen::Vector2d& corner(const Edge& edge) { return edge.points.front().at; }

std::string in_mm_at(const Eigen::Vector2d& at) { return "(" + in_mm(at.x()) + ", " + in_mm(at.y()) + ")"; }

// "1: (0.0 mm, 0.0 mm) to (237.5 mm, 3.8 mm), 238.9 mm long; 2: ..."
std::string edges_in_words(const Piece& piece, std::size_t start) {
  std::string words;
  const std::size_t count = piece.outline.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Edge& edge = piece.outline[(start + k) % count];
    words += (k ? "; " : "") + std::to_string(k + 1) + ": " + in_mm_at(corner(edge)) + " to " +
             in_mm_at(edge.points.back().at) + ", " + in_mm(length(edge)) + " long";
  }
  return words;
}

std::optional<std::size_t> corner_at(const TomlNode& node, const Piece& piece, Sidecar& sidecar) {
  if (node.items.size() != 2) {
    sidecar.report.error("seam.start", sidecar.at(node), "'start' must be a corner in words or two coordinates",
                         "Write for example \"bottom left\" or [\"120 mm\", \"0 mm\"]");
    return std::nullopt;
  }
  const auto x = length_of(node.items[0], sidecar);
  const auto y = length_of(node.items[1], sidecar);
  if (!x || !y) return std::nullopt;
  const Eigen::Vector2d wanted(*x, *y);
  std::size_t best = 0;
  for (std::size_t k = 1; k < piece.outline.size(); ++k)
    if ((corner(piece.outline[k]) - wanted).norm() < (corner(piece.outline[best]) - wanted).norm()) best = k;
  const double distance = (corner(piece.outline[best]) - wanted).norm();
  if (distance <= nearest_corner_within) return best;
  std::string turns;
  for (const Edge& edge : piece.outline) turns += (turns.empty() ? "" : ", ") + in_mm_at(corner(edge));
  sidecar.report.error(
      "seam.start", sidecar.at(node),
      "piece '" + piece.name + "' has no turn point at " + in_mm_at(wanted) + "; the nearest is " + in_mm(distance) + " away",
      "Its turn points are " + turns);
  return std::nullopt;
}

std::optional<std::size_t> start_of(const TomlNode& node, const Piece& piece, Sidecar& sidecar) {
  if (node.kind == TomlKind::array) return corner_at(node, piece, sidecar);
  if (node.kind == TomlKind::text)
    if (const auto k = corner_in_words(piece, node.text)) return k;
  sidecar.report.error("seam.start", sidecar.at(node), "'start' names no corner of piece '" + piece.name + "'",
                       "Write \"bottom left\", \"bottom right\", \"top right\", \"top left\" or coordinates such as "
                       "[\"120 mm\", \"0 mm\"]");
  return std::nullopt;
}

double turning(const Edge& before, const Edge& after) {
  const Eigen::Vector2d in = before.points.back().at - before.points[before.points.size() - 2].at;
  const Eigen::Vector2d out = after.points[1].at - after.points[0].at;
  return std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)));
}

// Appends `next` to `edge`, which it continues.
void join(Edge& edge, const Edge& next) {
  edge.points.back().turn = false;
  edge.points.insert(edge.points.end(), next.points.begin() + 1, next.points.end());
  if (edge.seam_allowance != next.seam_allowance) edge.seam_allowance.reset();
  edge.hem = edge.hem && next.hem;
}

// Where an edge went: into [begin, end] of the edge now called `to`.
struct Renamed {
  std::string from, to;
  double begin, end;
};

// Turns the outline and its names so that no edge runs over the beginning.
void begin_at_a_change_of_name(std::vector<Edge>& outline, std::vector<std::string>& names) {
  std::size_t back = 0;
  while (back + 1 < names.size() && names[names.size() - 1 - back] == names.front()) ++back;
  if (back + 1 == names.size()) return;
  std::rotate(outline.begin(), outline.end() - static_cast<std::ptrdiff_t>(back), outline.end());
  std::rotate(names.begin(), names.end() - static_cast<std::ptrdiff_t>(back), names.end());
}

// The edges [first, last) of the outline as one, called `name`.
Edge joined(const std::vector<Edge>& outline, std::size_t first, std::size_t last, const std::string& name,
            std::vector<Renamed>& renamed) {
  Edge edge = outline[first];
  for (std::size_t k = first + 1; k < last; ++k) join(edge, outline[k]);
  edge.id = name;
  const double total = length(edge);
  double sum = 0;
  for (std::size_t k = first; k < last; ++k) {
    const double begin = sum / total;
    sum += length(outline[k]);
    renamed.push_back({outline[k].id, name, begin, k + 1 == last ? 1 : sum / total});
  }
  return edge;
}

void rename(std::vector<Notch>& notches, const std::vector<Renamed>& renamed) {
  for (Notch& notch : notches) {
    const auto found = std::find_if(renamed.begin(), renamed.end(), [&](const Renamed& r) { return r.from == notch.edge; });
    if (found == renamed.end()) continue;
    notch.at = found->begin + notch.at * (found->end - found->begin);
    notch.edge = found->to;
  }
}

bool can_be_a_name(const std::string& name) {
  return !name.empty() && name.find_first_of(".:[]\"\\") == std::string::npos && name.front() != ' ' && name.back() != ' ';
}

}  // namespace

std::optional<std::size_t> corner_in_words(const Piece& piece, const std::string& words) {
  const auto has = [&](const char* word) { return words.find(word) != std::string::npos; };
  if (has("left") == has("right") || has("top") == has("bottom") || piece.outline.empty()) return std::nullopt;
  const Eigen::Vector2d towards(has("right") ? 1 : -1, has("top") ? 1 : -1);
  Eigen::Vector2d low = corner(piece.outline.front()), high = low;
  for (const Edge& edge : piece.outline)
    for (const OutlinePoint& point : edge.points) {
      low = low.cwiseMin(point.at);
      high = high.cwiseMax(point.at);
    }
  const Eigen::Vector2d size = (high - low).cwiseMax(1e-9);
  std::size_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < piece.outline.size(); ++k) {
    const double score = (corner(piece.outline[k]) - low).cwiseQuotient(size).dot(towards);
    if (score > most + 1e-9) {
      most = score;
      best = k;
    }
  }
  return best;
}

void name_edges(const TomlNode& entry, Piece& piece, Sidecar& sidecar) {
  const TomlNode* edges = find(entry, "edges");
  const TomlNode* start_node = find(entry, "start");
  if (!edges) {
    if (start_node)
      sidecar.report.error("seam.start", sidecar.at(*start_node), "'start' says where 'edges' begins, and there is no 'edges'",
                           "Name the edges, or leave 'start' out");
    return;
  }
  auto names = texts_of(*edges, sidecar);
  const auto start = start_node ? start_of(*start_node, piece, sidecar) : std::optional<std::size_t>(0);
  if (!names || !start) return;
  const std::size_t count = piece.outline.size();
  if (names->size() != count) {
    sidecar.report.error("seam.edge-count", sidecar.at(*edges),
                         "piece '" + piece.name + "' has " + std::to_string(count) + " edges between its turn points, and " +
                             std::to_string(names->size()) + " names are given",
                         "Counter-clockwise from the start corner the edges are " + edges_in_words(piece, *start) +
                             ". The same name twice running joins two edges");
    return;
  }
  std::vector<Edge> drawn = piece.outline;
  std::rotate(drawn.begin(), drawn.begin() + static_cast<std::ptrdiff_t>(*start), drawn.end());
  for (std::size_t k = 0; k < count; ++k)
    if ((*names)[k].empty()) (*names)[k] = drawn[k].id;
  begin_at_a_change_of_name(drawn, *names);

  std::vector<Edge> outline;
  std::vector<Renamed> renamed;
  std::set<std::string> used;
  for (std::size_t first = 0, last = 0; first < count; first = last) {
    const std::string& name = (*names)[first];
    if (!can_be_a_name(name)) {
      sidecar.report.error("seam.edge-name", sidecar.at(*edges), "an edge cannot be named " + toml_quoted(name),
                           "Leave out points, colons, brackets, quotes and blanks at the ends");
      return;
    }
    if (!used.insert(name).second) {
      sidecar.report.error("seam.edge-name", sidecar.at(*edges),
                           "two edges of piece '" + piece.name + "' that do not touch are both named '" + name + "'",
                           "Give each its own name");
      return;
    }
    for (last = first + 1; last < count && (*names)[last] == name; ++last)
      if (turning(drawn[last - 1], drawn[last]) > smooth_join)
        sidecar.report.warn("seam.joined-corner", sidecar.at(*edges),
                            "edge '" + name + "' of piece '" + piece.name + "' has a corner inside, at " +
                                in_mm_at(corner(drawn[last])) + ", which will be treated as a curve",
                            "Give the two runs different names to keep the corner");
    outline.push_back(joined(drawn, first, last, name, renamed));
  }
  piece.outline = std::move(outline);
  rename(piece.notches, renamed);
}

}  // namespace toile
