#pragma once
// A sheet cut into pages of one size that overlap. Millimetres, y down, origin at the sheet's upper left corner.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace toile {

// 14,400 points: PDF readers take no longer side of a page (PDF 32000-1, annex C).
inline constexpr double longest_pdf_side = 5080;  // mm

struct Tiling {
  Eigen::Vector2d page;    // of the paper
  Eigen::Vector2d margin;  // left and right; above and below
  double overlap = 0;      // what neighbours both show
  int rows = 1, columns = 1;

  Eigen::Vector2d window() const { return page - 2 * margin; }  // what a page shows of the sheet
  Eigen::Vector2d corner(int row, int column) const;            // upper left of it, on the sheet
  bool operator==(const Tiling&) const = default;
};

// The least pages of that size that cover `sheet`. Throws std::invalid_argument when the window is not larger than the overlap.
Tiling tiled(const Eigen::Vector2d& sheet, const Eigen::Vector2d& page, double margin, double overlap);

// One page of the sheet's size; where a side is longer than a PDF's may be, the least equal pages along it, with margins there.
Tiling unrolled(const Eigen::Vector2d& sheet, double margin, double overlap);

// Which pages are printed: those with something on them.
struct TilePlan {
  Tiling tiling;
  std::vector<bool> printed;  // rows x columns, row by row

  bool prints(int row, int column) const;  // false beyond the sheet
  int pages() const;
  void drop_empty_columns();  // at the right end: cloth that is wider than its pieces
};

// "A1": rows are letters (A to Z, AA ...), columns numbers from 1.
std::string tile_name(int row, int column);

}  // namespace toile
