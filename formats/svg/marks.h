#pragma once
// Path data of the marks on a cut sheet, in the y-down millimetres of the SVG page.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "garment/cut_sheet.h"

namespace toile {

// "M x,y L x,y ..." with "Z" when closed.
std::string path_data(const std::vector<Eigen::Vector2d>& points, bool closed);

// The notch at `at` with unit direction `inwards`; depth and width as in `notch`. Depth 0 is a mark outside the line.
std::string notch_path(const Eigen::Vector2d& at, const Eigen::Vector2d& inwards, const Notch& notch);

// The two heads of a double-headed arrow, `size` long, filled.
std::string arrow_heads(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double size);

std::string crossed_circle(const Eigen::Vector2d& at, double diameter);

}  // namespace toile
