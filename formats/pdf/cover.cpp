#include "formats/pdf/cover.h"

#include <algorithm>

#include "formats/svg/heading.h"
#include "formats/svg/marks.h"
#include "formats/svg/xml_text.h"
#include "garment/units.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double heading_margin = 10;  // mm, that a heading keeps by itself
const LineStyle grid{.colour = "#3060a0", .width = .2e-3, .dash = {}, .shown = true};
const LineStyle empty{.colour = "#b0b0b0", .width = .15e-3, .dash = {1e-3, 1e-3}, .shown = true};

std::vector<std::string> how_to_tape(const TilePlan& plan) {
  const Tiling& tiling = plan.tiling;
  const int left_out = tiling.rows * tiling.columns - plan.pages();
  std::vector<std::string> lines{
      std::to_string(plan.pages()) + (plan.pages() == 1 ? " page" : " pages") + ", named by row (letter) and column (number)" +
      (left_out > 0 ? "; " + std::to_string(left_out) + " with nothing on them left out (dashed in the map)" : "") + "."};
  if (plan.pages() > 1) {
    lines.emplace_back("Cut a page along its left and upper frame, where a neighbour is named there.");
    lines.emplace_back(
        "Lay it on that neighbour up to its dashed line, so that the half diamonds become whole, and glue or tape.");
    lines.emplace_back("First the pages of each row from left to right, then the rows from A on.");
  }
  return lines;
}

// The sheet small between `top` and the end of the page.
void draw_map(XmlText& xml, CoverPage& page, const Vector2d& sheet, const TilePlan& plan, double top, const SheetStyle& style) {
  const Tiling& tiling = plan.tiling;
  const Vector2d all = tiling.corner(tiling.rows - 1, tiling.columns - 1) + tiling.window();
  const Vector2d room = Vector2d(tiling.window().x(), tiling.page.y() - tiling.margin.y() - top);
  page.scale = room.cwiseQuotient(all).minCoeff();
  const Vector2d corner(tiling.margin.x() + (room.x() - page.scale * all.x()) / 2, top);
  page.map = {corner, sheet};
  for (int row = 0; row < tiling.rows; ++row)
    for (int column = 0; column < tiling.columns; ++column) {
      // What a page shows when all are taped together.
      const Vector2d low = corner + page.scale * tiling.corner(row, column);
      const Vector2d size = page.scale * (tiling.window() - Vector2d(column + 1 < tiling.columns ? tiling.overlap : 0,
                                                                     row + 1 < tiling.rows ? tiling.overlap : 0));
      const bool prints = plan.prints(row, column);
      drawn(xml.open("rect"), prints ? grid : empty).with("data-type", prints ? "page" : "empty-page");
      xml.with("x", low.x()).with("y", low.y()).with("width", size.x()).with("height", size.y()).close();
      if (!prints) continue;
      const double letters = std::min({tiling.page.x() / 40, .4 * size.y(), size.x() / 3.2});
      xml.open("text").with("font-family", style.font).with("font-size", letters).with("fill", grid.colour);
      xml.with("text-anchor", "middle").with("x", low.x() + size.x() / 2).with("y", low.y() + size.y() / 2 + .35 * letters);
      xml.text(tile_name(row, column)).close();
    }
}

}  // namespace

std::vector<CoverPage> cover_pages(const CutSheet& sheet, const TilePlan& plan, const SheetStyle& style) {
  const Tiling& tiling = plan.tiling;
  SheetStyle small = style;
  small.heading_text = std::min(style.heading_text, tiling.page.x() / 80 / mm_per_m);
  small.frame.shown = true;
  const Vector2d shift = tiling.margin - Vector2d::Constant(heading_margin);
  CutSheet told = sheet;
  Heading heading;
  for (std::size_t kept = sheet.notes.size();; --kept) {
    told.notes = how_to_tape(plan);
    told.notes.emplace_back();
    told.notes.insert(told.notes.end(), sheet.notes.begin(), sheet.notes.begin() + static_cast<std::ptrdiff_t>(kept));
    const std::size_t left_out = sheet.notes.size() - kept;
    if (left_out > 0) told.notes.push_back("and " + std::to_string(left_out) + " notes that have no room on this paper");
    heading = heading_of(told, small, tiling.window().x() + 2 * heading_margin);
    if (kept == 0 || shift.y() + heading.height <= tiling.page.y()) break;
  }

  std::vector<CoverPage> pages(1);
  XmlText xml;
  open_page(xml, tiling.page.x(), tiling.page.y());
  xml.open("g").with("transform", "translate(" + in_digits(shift.x()) + "," + in_digits(shift.y()) + ")");
  for (const auto& draw : heading.blocks) draw(xml);
  xml.close();
  const Vector2d size = mm_per_m * Vector2d(sheet.page_width, sheet.page_length);
  const double below = shift.y() + heading.height;
  if (below <= .6 * tiling.page.y()) {
    draw_map(xml, pages.front(), size, plan, below, style);
  } else {
    CoverPage& map = pages.emplace_back();
    XmlText second;
    open_page(second, tiling.page.x(), tiling.page.y());
    draw_map(second, map, size, plan, tiling.margin.y(), style);
    map.svg = second.done();
  }
  pages.front().svg = xml.done();
  return pages;
}

}  // namespace toile
