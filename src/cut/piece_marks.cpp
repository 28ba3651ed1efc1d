#include "cut/piece_marks.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <stdexcept>

#include "garment/units.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double deepest = 0.8;  // of the allowance, so that no snip reaches the seam

Vector2d outward_at(const Points<2>& edge, double at) {
  const double beside = 1e-6;
  return turned_right((direction_at<2>(edge, at - beside) + direction_at<2>(edge, at + beside)).normalized());
}

std::optional<double> first_hit(const Polygon& line, const Vector2d& from, const Vector2d& direction, double reach) {
  std::optional<double> nearest;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto crossed = crossing(from, from + reach * direction, line[i], line[(i + 1) % line.size()]);
    if (crossed && (!nearest || crossed->first * reach < *nearest)) nearest = crossed->first * reach;
  }
  return nearest;
}

Vector2d nearest_on_loop(Polygon line, const Vector2d& point) {
  line.push_back(line.front());
  return point_at<2>(line, nearest_on<2>(line, point).at);
}

// Millimetres or inches without trailing zeros.
std::string number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  std::string words = text;
  while (words.back() == '0') words.pop_back();
  if (words.back() == '.') words.pop_back();
  return words;
}

}  // namespace

std::vector<CutNotch> notches_on(const Piece& piece, const std::vector<double>& widths, const Polygon& cut_line) {
  const double widest = widths.empty() ? 0 : *std::max_element(widths.begin(), widths.end());
  std::vector<CutNotch> notches;
  for (const Notch& notch : piece.notches) {
    const Edge* edge = find_edge(piece, notch.edge);
    if (!edge)
      throw std::invalid_argument("add_allowance: notch on unknown edge '" + notch.edge + "' of piece '" + piece.name + "'");
    const Points<2> line = positions(*edge);
    const Vector2d place = point_at<2>(line, notch.at);
    CutNotch moved{.at = place, .direction = -outward_at(line, notch.at), .notch = notch};
    const Vector2d nearest = nearest_on_loop(cut_line, place);
    if ((nearest - place).norm() > 1e-9) {
      const auto hit = first_hit(cut_line, place, -moved.direction, 4 * widest);
      moved.at = hit ? Vector2d(place - *hit * moved.direction) : nearest;
      if (!hit) moved.direction = (place - moved.at).normalized();
    }
    moved.notch.depth = std::min(notch.depth, deepest * (moved.at - place).norm());
    notches.push_back(std::move(moved));
  }
  return notches;
}

std::string cut_quantity(const Piece& piece) {
  const int all = copies(piece);
  const std::string count = "Cut " + std::to_string(all);
  if (piece.mirrored_quantity == 0) return count;
  if (piece.quantity == piece.mirrored_quantity)
    return "Cut " + std::to_string(piece.quantity) + (piece.quantity == 1 ? " pair (" : " pairs (") + std::to_string(all) +
           " mirrored)";
  return count + " (" + std::to_string(piece.mirrored_quantity) + " mirrored)";
}

std::string in_both_units(double metres) {
  return number(metres * mm_per_m, 1) + " mm (" + number(metres / 0.0254, 2) + " in)";
}

std::vector<std::string> labels_of(const Piece& piece, const std::vector<double>& widths, const std::vector<bool>& hems) {
  std::vector<std::string> labels{piece.name, cut_quantity(piece)};
  if (!piece.material.empty()) labels.push_back("Material: " + piece.material);

  std::map<long, double> seam_lengths;  // by tenths of a millimetre
  const auto tenths = [](double width) { return std::lround(width * 1e4); };
  for (std::size_t e = 0; e < widths.size(); ++e)
    if (!hems[e]) seam_lengths[tenths(widths[e])] += length(piece.outline[e]);
  const auto usual = std::max_element(seam_lengths.begin(), seam_lengths.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; });
  std::string general = "Allowance included:";
  if (usual != seam_lengths.end()) general.append(1, ' ').append(in_both_units(static_cast<double>(usual->first) * 1e-4));
  labels.push_back(general);
  for (std::size_t e = 0; e < widths.size(); ++e) {
    if (!hems[e] && tenths(widths[e]) == usual->first) continue;
    const std::string name = hems[e] && piece.outline[e].id != "hem" ? "hem " + piece.outline[e].id : piece.outline[e].id;
    labels.push_back("  " + name + ": " + (widths[e] > 0 ? in_both_units(widths[e]) : "none"));
  }
  return labels;
}

}  // namespace toile
