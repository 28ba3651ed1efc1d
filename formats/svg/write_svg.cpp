#include "formats/svg/write_svg.h"

#include <charconv>
#include <cmath>

#include "formats/formats.h"
#include "formats/svg/heading.h"
#include "formats/svg/label_place.h"
#include "formats/svg/marks.h"
#include "garment/units.h"

namespace toile {
namespace {

using Eigen::Vector2d;

// Piece coordinates (m, y up) to the SVG page (mm, y down).
struct OnPage {
  Eigen::Matrix2d turn;
  Vector2d shift;
  double bottom;  // mm

  Vector2d operator()(const Vector2d& p) const {
    const Vector2d page = mm_per_m * (turn * p + shift);
    return {page.x(), bottom - page.y()};
  }
  Vector2d direction(const Vector2d& d) const {
    const Vector2d page = turn * d;
    return {page.x(), -page.y()};
  }
  template <class Points>
  std::vector<Vector2d> all(const Points& points) const {
    std::vector<Vector2d> placed;
    for (const auto& point : points) placed.push_back((*this)(point));
    return placed;
  }
};

OnPage on_page(const PlacedPiece& placed, double bottom) {
  const double c = std::cos(placed.turn), s = std::sin(placed.turn);
  OnPage page{.turn = {}, .shift = placed.shift, .bottom = bottom};
  page.turn << c, -s, s, c;
  return page;
}

std::vector<Vector2d> places(const std::vector<OutlinePoint>& points) {
  std::vector<Vector2d> at;
  for (const OutlinePoint& point : points) at.push_back(point.at);
  return at;
}

// With all digits: fractions and angles are not lengths.
std::string exact(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& one : lines) text += (text.empty() ? "" : "\n") + one;
  return text;
}

const char* in_word(NotchKind kind) {
  switch (kind) {
    case NotchKind::slit:
      return "slit";
    case NotchKind::v:
      return "v";
    case NotchKind::t:
      return "t";
    case NotchKind::castle:
      return "castle";
    case NotchKind::check:
      return "check";
    case NotchKind::u:
      return "u";
  }
  return "slit";
}

std::string seams_of(const CutSheet& sheet, const std::string& piece, const std::string& edge) {
  std::string names;
  for (std::size_t i = 0; i < sheet.seams.size(); ++i) {
    const Seam& seam = sheet.seams[i];
    const std::string name = seam.name.empty() ? "seam " + std::to_string(i + 1) : seam.name;
    for (const auto& [span, side] : {std::pair{&seam.a, "/a"}, std::pair{&seam.b, "/b"}})
      if (span->piece == piece && span->edge == edge) names += (names.empty() ? "" : ";") + name + side;
  }
  return names;
}

class PieceDrawing {
 public:
  PieceDrawing(XmlText& xml, const CutSheet& sheet, const PlacedPiece& placed, const SheetStyle& style, double bottom)
      : xml_(xml), sheet_(sheet), cut_(placed.cut), style_(style), page_(on_page(placed, bottom)), turn_(placed.turn) {}

  void draw() {
    const Piece& piece = cut_.piece;
    xml_.open("g").with("data-type", "piece").with("data-piece", piece.name).with("data-size", cut_.size);
    xml_.with("data-quantity", std::to_string(piece.quantity)).with("data-mirrored", std::to_string(piece.mirrored_quantity));
    xml_.with("data-shift", in_digits(page_.shift.x() * mm_per_m) + " " + in_digits(page_.shift.y() * mm_per_m));
    if (turn_ != 0) xml_.with("data-turn", exact(turn_ / units::degree));
    if (!piece.sewn) xml_.with("data-sewn", "false");
    if (!piece.material.empty()) xml_.with("data-material", piece.material);
    if (!piece.annotations.empty()) xml_.with("data-annotations", joined(piece.annotations));
    if (style_.cut.shown) line("cut", style_.cut, path_data(page_.all(places(cut_.cut_line)), true)).close();
    if (style_.sew.shown) sew_lines();
    if (style_.internal.shown)
      for (const InternalLine& inner : piece.internal_lines)
        line(inner.cut_out ? "cut-out" : "internal", inner.cut_out ? style_.cut : style_.internal,
             path_data(page_.all(inner.points), inner.cut_out))
            .close();
    if (style_.notch.shown) notches();
    if (style_.drill.shown)
      for (const DrillHole& hole : piece.drill_holes)
        line("drill", style_.drill, crossed_circle(page_(hole.at), hole.diameter > 0 ? hole.diameter * mm_per_m : 3))
            .with("data-diameter", hole.diameter * mm_per_m)
            .close();
    if (style_.turn_points.shown) turn_points();
    if (style_.grain.shown && piece.grainline) grain(*piece.grainline);
    label();
    xml_.close();
  }

  void fill() {
    drawn(xml_.open("path").with("data-type", "cut").with("data-piece", cut_.piece.name), style_.cut, paper_grey);
    xml_.with("d", path_data(page_.all(places(cut_.cut_line)), true)).close();
  }

 private:
  XmlText& line(const char* type, const LineStyle& style, const std::string& data) {
    return drawn(xml_.open("path").with("data-type", type).with("data-piece", cut_.piece.name), style).with("d", data);
  }

  void sew_lines() {
    for (const Edge& edge : cut_.piece.outline) {
      line("sew", style_.sew, path_data(page_.all(places(edge.points)), false)).with("data-edge", edge.id);
      const std::string seams = seams_of(sheet_, cut_.piece.name, edge.id);
      if (!seams.empty()) xml_.with("data-seam", seams);
      if (edge.seam_allowance) xml_.with("data-allowance", *edge.seam_allowance * mm_per_m);
      if (edge.hem) xml_.with("data-hem", "true");
      xml_.close();
    }
  }

  void notches() {
    for (const CutNotch& notch : cut_.notches) {
      line("notch", style_.notch, notch_path(page_(notch.at), page_.direction(notch.direction), notch.notch));
      xml_.with("data-edge", notch.notch.edge).with("data-at", exact(notch.notch.at));
      xml_.with("data-kind", in_word(notch.notch.kind)).with("data-depth", notch.notch.depth * mm_per_m);
      xml_.with("data-width", notch.notch.width * mm_per_m).close();
    }
  }

  void turn_points() {
    for (const Edge& edge : cut_.piece.outline)
      for (const OutlinePoint& point : edge.points)
        if (point.turn)
          line("turn", style_.turn_points, crossed_circle(page_(point.at), 1.5)).with("data-edge", edge.id).close();
  }

  void grain(const Grainline& grain) {
    const Vector2d from = page_(grain.from), to = page_(grain.to);
    line("grain", style_.grain, path_data({from, to}, false)).close();
    const double size = std::min(6.0, (to - from).norm() / 4);
    xml_.open("path").with("data-type", "grain").with("data-piece", cut_.piece.name).with("fill", style_.grain.colour);
    xml_.with("d", arrow_heads(from, to, size)).close();
  }

  void label() {
    std::vector<Vector2d> outline;
    for (const Edge& edge : cut_.piece.outline)
      for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) outline.push_back(page_(edge.points[i].at));
    std::vector<Segment2> obstacles;
    if (cut_.piece.grainline) {
      const Vector2d from = page_(cut_.piece.grainline->from), to = page_(cut_.piece.grainline->to);
      const Vector2d across = 3 * Vector2d(-(to - from).y(), (to - from).x()).normalized();
      obstacles = {{from, to}, {from + across, to + across}, {from - across, to - across}};
    }
    for (const InternalLine& inner : cut_.piece.internal_lines)
      for (std::size_t i = 1; i < inner.points.size(); ++i)
        obstacles.emplace_back(page_(inner.points[i - 1]), page_(inner.points[i]));
    const double smallest = style_.smallest_text * mm_per_m;
    std::vector<std::string> lines = cut_.labels;
    LabelPlace place = placed(outline, obstacles, lines);
    if (place.scale < smallest && lines.size() > 2) {
      lines = {cut_.piece.name + (cut_.size.empty() ? "" : ", size " + cut_.size)};
      place = placed(outline, obstacles, lines);
    }
    if (place.scale == 0) place.centre = middle(outline);
    write(lines, place, std::max(place.scale, smallest));
  }

  LabelPlace placed(const std::vector<Vector2d>& outline, const std::vector<Segment2>& obstacles,
                    const std::vector<std::string>& lines) const {
    double width = 0;
    for (const std::string& words : lines) width = std::max(width, text_width(words) + 1);
    return place_label(outline, obstacles, width, spacing * static_cast<double>(lines.size()) + 1,
                       style_.largest_text * mm_per_m);
  }

  static Vector2d middle(const std::vector<Vector2d>& outline) {
    Vector2d sum = Vector2d::Zero();
    for (const Vector2d& p : outline) sum += p;
    return sum / static_cast<double>(outline.size());
  }

  void write(const std::vector<std::string>& lines, const LabelPlace& place, double size) {
    const std::string at = in_digits(place.centre.x()) + "," + in_digits(place.centre.y());
    xml_.open("g").with("data-type", "label").with("data-piece", cut_.piece.name);
    xml_.with("transform", "translate(" + at + ")" + (place.upright ? "" : " rotate(-90)"));
    double y = -spacing * static_cast<double>(lines.size()) / 2;
    for (const std::string& words : lines) {
      y += spacing;
      lettered(xml_.open("text"), style_, size).with("text-anchor", "middle");
      xml_.with("x", 0.0).with("y", (y - 0.35) * size).text(words).close();
    }
    xml_.close();
  }

  static constexpr const char* paper_grey = "#eeeeee";
  static constexpr double spacing = 1.35;  // of the letter size, from line to line

  XmlText& xml_;
  const CutSheet& sheet_;
  const CutPiece& cut_;
  const SheetStyle& style_;
  OnPage page_;
  double turn_;  // radians
};

bool headed(SheetParts parts) { return parts == SheetParts::whole || parts == SheetParts::uncoloured; }

}  // namespace

std::string svg_text(const CutSheet& sheet, const SheetStyle& style, SheetParts parts) {
  if (sheet.placed.empty())
    throw BadInput({.code = "svg.empty-sheet",
                    .place = "cut sheet '" + sheet.title + "'",
                    .text = "there is no piece to draw",
                    .remedy = "give it a pattern with at least one piece"});
  const Vector2d size = svg_size(sheet, style, parts);
  XmlText xml;
  open_page(xml, size.x(), size.y());
  xml.open("title").text(sheet.title).close();
  if (parts == SheetParts::whole)
    xml.open("rect").with("data-type", "page").with("fill", "#ffffff").with("width", size.x()).with("height", size.y()).close();
  if (headed(parts)) {
    xml.open("g").with("data-type", "heading");
    for (const auto& draw : heading_of(sheet, style, size.x()).blocks) draw(xml);
    xml.close();
  }
  for (const PlacedPiece& placed : sheet.placed) {
    PieceDrawing drawing(xml, sheet, placed, style, size.y());
    parts == SheetParts::outlines ? drawing.fill() : drawing.draw();
  }
  xml.close();
  return xml.done();
}

Vector2d svg_size(const CutSheet& sheet, const SheetStyle& style, SheetParts parts) {
  const double width = sheet.page_width * mm_per_m;
  return {width, sheet.page_length * mm_per_m + (headed(parts) ? heading_of(sheet, style, width).height : 0)};
}

void write_svg(const std::filesystem::path& file, const CutSheet& sheet, const SheetStyle& style) {
  write_whole_file(file, svg_text(sheet, style));
}

void write_svg(const std::filesystem::path& file, const CutSheet& sheet) { write_svg(file, sheet, SheetStyle{}); }

}  // namespace toile
