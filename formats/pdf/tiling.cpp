#include "formats/pdf/tiling.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double slack = 1e-6;  // mm, that a sheet may be longer than its pages

int pages_along(double sheet, double window, double overlap) {
  if (!(overlap >= 0) || !(window > overlap)) throw std::invalid_argument("tiling: nothing is left of a page");
  return std::max(1, static_cast<int>(std::ceil((sheet - overlap - slack) / (window - overlap))));
}

}  // namespace

Vector2d Tiling::corner(int row, int column) const {
  return (window() - Vector2d::Constant(overlap)).cwiseProduct(Vector2d(column, row));
}

Tiling tiled(const Vector2d& sheet, const Vector2d& page, double margin, double overlap) {
  Tiling tiling{page, Vector2d::Constant(margin), overlap};
  tiling.columns = pages_along(sheet.x(), tiling.window().x(), overlap);
  tiling.rows = pages_along(sheet.y(), tiling.window().y(), overlap);
  return tiling;
}

Tiling unrolled(const Vector2d& sheet, double margin, double overlap) {
  Tiling tiling{sheet, Vector2d::Zero(), overlap};
  for (const int side : {0, 1}) {
    if (sheet[side] <= longest_pdf_side) continue;
    int& pages = side == 0 ? tiling.columns : tiling.rows;
    tiling.margin[side] = margin;
    pages = pages_along(sheet[side], longest_pdf_side - 2 * margin, overlap);
    tiling.page[side] = (sheet[side] + (pages - 1) * overlap) / pages + 2 * margin;
  }
  return tiling;
}

bool TilePlan::prints(int row, int column) const {
  if (row < 0 || column < 0 || row >= tiling.rows || column >= tiling.columns) return false;
  return printed[static_cast<std::size_t>(row) * static_cast<std::size_t>(tiling.columns) + static_cast<std::size_t>(column)];
}

int TilePlan::pages() const { return static_cast<int>(std::count(printed.begin(), printed.end(), true)); }

void TilePlan::drop_empty_columns() {
  int wide = 1;
  for (int row = 0; row < tiling.rows; ++row)
    for (int column = wide; column < tiling.columns; ++column)
      if (prints(row, column)) wide = column + 1;
  std::vector<bool> kept;
  for (int row = 0; row < tiling.rows; ++row)
    for (int column = 0; column < wide; ++column) kept.push_back(prints(row, column));
  printed = std::move(kept);
  tiling.columns = wide;
}

std::string tile_name(int row, int column) {
  std::string letters;
  for (int rest = row; rest >= 0; rest = rest / 26 - 1) letters.insert(letters.begin(), static_cast<char>('A' + rest % 26));
  return letters + std::to_string(column + 1);
}

}  // namespace toile
