#include <algorithm>
#include <cmath>

#include "formats/formats.h"
#include "formats/seams/name_edges.h"
#include "formats/seams/seams.h"
#include "formats/seams/sit.h"
#include "formats/seams/span_text.h"

namespace toile {
namespace {

std::string list_text(const std::vector<std::string>& texts) {
  std::string out = "[";
  for (const std::string& text : texts) out += (out.size() > 1 ? ", " : "") + toml_quoted(text);
  return out + "]";
}

std::string mm_text(double metres) { return toml_quoted(exact_number(metres * 1e3) + " mm"); }

// The corner a piece's names begin at: a word for it where that stays clear when the piece is redrawn a little differently.
struct Start {
  std::size_t edge = 0;
  std::string text;
};

Start start_of(const Piece& piece) {
  Eigen::Vector2d low = piece.outline[0].points[0].at, high = low;
  for (const Edge& edge : piece.outline)
    for (const OutlinePoint& point : edge.points) {
      low = low.cwiseMin(point.at);
      high = high.cwiseMax(point.at);
    }
  const Eigen::Vector2d size = (high - low).cwiseMax(1e-9);
  for (const char* words : {"bottom left", "bottom right", "top right", "top left"}) {
    const auto best = corner_in_words(piece, words);
    if (!best) continue;
    const std::string corner(words);
    const Eigen::Vector2d towards(corner.ends_with("right") ? 1 : -1, corner.starts_with("top") ? 1 : -1);
    const auto score = [&](const Edge& edge) { return (edge.points[0].at - low).cwiseQuotient(size).dot(towards); };
    const bool clear = std::all_of(piece.outline.begin(), piece.outline.end(), [&](const Edge& edge) {
      return &edge == &piece.outline[*best] || score(edge) < score(piece.outline[*best]) - .1;
    });
    if (clear) return {*best, toml_quoted(corner)};
  }
  const Eigen::Vector2d& at = piece.outline[0].points[0].at;
  return {0, "[" + mm_text(at.x()) + ", " + mm_text(at.y()) + "]"};
}

std::string piece_text(const Piece& piece) {
  std::string text = "\n[[piece]]\nname = " + toml_quoted(piece.name) + "\ncopies = " + std::to_string(piece.quantity) + "\n";
  if (piece.mirrored_quantity) text += "mirrored_copies = " + std::to_string(piece.mirrored_quantity) + "\n";
  if (!piece.sewn) text += "sewn = false\n";
  if (piece.layer) text += "layer = " + std::to_string(*piece.layer) + "\n";
  if (!piece.outline.empty()) {
    const Start start = start_of(piece);
    std::vector<std::string> names, hems;
    std::string allowances;
    for (std::size_t k = 0; k < piece.outline.size(); ++k) {
      const Edge& edge = piece.outline[(start.edge + k) % piece.outline.size()];
      names.push_back(edge.id);
      if (edge.hem) hems.push_back(edge.id);
      if (edge.seam_allowance)
        allowances += (allowances.empty() ? "" : ", ") + toml_quoted(edge.id) + " = " + mm_text(*edge.seam_allowance);
    }
    text += "start = " + start.text + "\nedges = " + list_text(names) + "\n";
    if (!hems.empty()) text += "hems = " + list_text(hems) + "\n";
    if (!allowances.empty()) text += "allowances = { " + allowances + " }\n";
  }
  return text + sitting_text(piece);
}

std::string run_text(const Pattern& pattern, EdgeSpan span) {
  if (span.begin > span.end) std::swap(span.begin, span.end);
  const Piece* piece = find_piece(pattern, span.piece);
  const bool cut_once = piece && copies(*piece) == 1;
  const std::string text = span_text(span, cut_once);
  const auto back = parse_span(text);
  if (back && back->piece == span.piece && back->edge == span.edge && back->copy.value_or(1) == span.copy &&
      text.find_first_of("\"\\") == std::string::npos)
    return toml_quoted(text);
  return "{ piece = " + toml_quoted(span.piece) + ", copy = " + std::to_string(span.copy) +
         ", edge = " + toml_quoted(span.edge) + ", from = " + toml_quoted(exact_number(span.begin)) +
         ", to = " + toml_quoted(exact_number(span.end)) + " }";
}

std::string seam_text(const Pattern& pattern, const Seam& seam) {
  std::string text = "\n[[seam]]\n";
  if (!seam.name.empty()) text += "name = " + toml_quoted(seam.name) + "\n";
  text += "a = " + run_text(pattern, seam.a) + "\nb = " + run_text(pattern, seam.b) + "\n";
  const auto mirrored = [&](const EdgeSpan& span) {
    const Piece* piece = find_piece(pattern, span.piece);
    return piece && is_mirrored(*piece, span.copy);
  };
  const bool same_way = (seam.a.begin <= seam.a.end) == (seam.b.begin <= seam.b.end);
  if (same_way != (mirrored(seam.a) != mirrored(seam.b))) text += "reversed = true\n";
  if (seam.right_to_wrong) text += "right_to_wrong = true\n";
  const double difference = std::abs(span_length(pattern, seam.a) - span_length(pattern, seam.b));
  if (difference > 1e-3) text += "ease = " + toml_quoted(exact_number(std::ceil(difference * 1e4) / 10) + " mm") + "\n";
  return text;
}

}  // namespace

std::string seams_text(const Pattern& pattern) {
  std::string text = "# Edge names, seams and places on the body of the pattern of the same name.\n";
  for (const Piece& piece : pattern.pieces) text += piece_text(piece);
  for (const Seam& seam : pattern.seams) text += seam_text(pattern, seam);
  return text;
}

void write_seams(const std::filesystem::path& file, const Pattern& pattern) { write_whole_file(file, seams_text(pattern)); }

}  // namespace toile
