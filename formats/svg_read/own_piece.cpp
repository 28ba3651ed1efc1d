#include "formats/svg_read/own_piece.h"

#include <algorithm>
#include <cmath>

#include "formats/dxf_aama/chains.h"
#include "garment/units.h"

namespace toile::svg {
namespace {

using Eigen::Vector2d;

std::optional<double> number_of(const Names& names, const std::string& key) {
  const std::vector<double> numbers = numbers_in(names.datum(key));
  if (numbers.size() != 1 || !std::isfinite(numbers.front())) return {};
  return numbers.front();
}

int count_of(const Names& names, const std::string& key, int otherwise) {
  const double count = number_of(names, key).value_or(otherwise);
  return count >= 0 && count <= 1000 ? static_cast<int>(count) : otherwise;
}

NotchKind kind_of(const std::string& name) {
  for (const auto& [word, kind] : {std::pair{"v", NotchKind::v},
                                   {"t", NotchKind::t},
                                   {"castle", NotchKind::castle},
                                   {"check", NotchKind::check},
                                   {"u", NotchKind::u}})
    if (name == word) return kind;
  return NotchKind::slit;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

Vector2d middle_of(const Points<2>& points) {
  Vector2d low = points.front(), high = points.front();
  for (const Vector2d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (low + high) / 2;
}

// From the page back to the coordinates of the piece.
struct OffPage {
  Eigen::Rotation2Dd turn{0};
  Vector2d shift = Vector2d::Zero();
  Vector2d operator()(const Vector2d& p) const { return turn.inverse() * Vector2d(p - shift); }
};

OffPage off_page(const Names& names, double bottom) {
  OffPage page;
  const std::vector<double> shift = numbers_in(names.datum("shift"));
  if (shift.size() == 2 && std::isfinite(shift[0]) && std::isfinite(shift[1]))
    page.shift = Vector2d(shift[0], shift[1]) / mm_per_m;
  page.turn = Eigen::Rotation2Dd(number_of(names, "turn").value_or(0) * units::degree);
  page.shift.y() -= bottom;
  return page;
}

}  // namespace

std::optional<ReadPiece> own_piece(const Drawing& drawing, int group, double bottom) {
  const Names& names = drawing.groups[static_cast<std::size_t>(group)].names;
  const OffPage off = off_page(names, bottom);
  ReadPiece read;
  Piece& piece = read.piece;
  piece.name = names.datum("piece");
  piece.quantity = count_of(names, "quantity", 1);
  piece.mirrored_quantity = count_of(names, "mirrored", 0);
  piece.sewn = names.datum("sewn") != "false";
  piece.material = names.datum("material");
  piece.annotations = lines_of(names.datum("annotations"));
  struct DrawnOwnNotch {
    const DrawnLine* line;
    Notch notch;
  };
  for (const DrawnLine& line : drawing.lines) {
    if (!drawing.within(line.group, group)) continue;
    const std::string type = line.names.datum("type");
    Points<2> points;
    for (const Vector2d& p : line.shape.points) points.push_back(off(p));
    if (type == "sew") {
      if (line.names.datum("edge").empty() || line.shape.closed) return {};
      Edge edge;
      edge.id = line.names.datum("edge");
      for (const Vector2d& p : points) edge.points.push_back({p, false, {}});
      edge.points.front().turn = edge.points.back().turn = true;
      if (const std::optional<double> width = number_of(line.names, "allowance")) edge.seam_allowance = *width / mm_per_m;
      edge.hem = line.names.datum("hem") == "true";
      piece.outline.push_back(std::move(edge));
    } else if (type == "internal" || type == "cut-out") {
      InternalLine inner{points, type == "cut-out"};
      if (line.shape.closed && (points.back() - points.front()).norm() > 1e-6) inner.points.push_back(points.front());
      piece.internal_lines.push_back(std::move(inner));
    } else if (type == "grain" && points.size() == 2 && !piece.grainline) {
      piece.grainline = Grainline{points.front(), points.back()};
    } else if (type == "drill" && line.shape.closed) {
      piece.drill_holes.push_back({middle_of(points), number_of(line.names, "diameter").value_or(0) / mm_per_m});
    } else if (type == "notch" && !line.names.datum("edge").empty()) {
      const bool again =
          std::any_of(&drawing.lines.front(), &line, [&](const DrawnLine& other) { return other.path == line.path; });
      const std::optional<double> at = number_of(line.names, "at");
      if (again || !at || *at < 0 || *at > 1) continue;
      Notch notch;
      notch.edge = line.names.datum("edge");
      notch.at = *at;
      notch.kind = kind_of(line.names.datum("kind"));
      notch.depth = number_of(line.names, "depth").value_or(4) / mm_per_m;
      notch.width = number_of(line.names, "width").value_or(0) / mm_per_m;
      piece.notches.push_back(notch);
    }
  }
  const std::size_t n = piece.outline.size();
  if (n == 0) return {};
  for (std::size_t i = 0; i < n; ++i) {
    Edge &edge = piece.outline[i], &next = piece.outline[(i + 1) % n];
    if (edge.points.size() < 2 || (edge.points.back().at - next.points.front().at).norm() > aama::closing_gap) return {};
    next.points.front().at = edge.points.back().at;
  }
  if (signed_area(piece) <= 0) return {};
  for (const Notch& notch : piece.notches)
    if (!find_edge(piece, notch.edge)) return {};
  read.facts.piece = piece.name;
  read.facts.has_sew_line = true;
  read.facts.sew_line_source = "data-type";
  return read;
}

}  // namespace toile::svg
