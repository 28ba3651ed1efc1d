#pragma once
// What the pictures of a run are put together from.

#include <functional>
#include <string>
#include <vector>

#include "picture/colour_map.h"
#include "picture/image.h"
#include "picture/pictures.h"
#include "picture/render.h"

namespace toile {

constexpr int page_width = 1200;  // pixels

// Views beside each other: 0 front, 1 the wearer's left, 2 back.
struct ViewRow {
  std::vector<std::size_t> sides;
  int width = 0;                      // of one view, pixels
  std::vector<ShownLine> marks = {};  // beside the seam lines
};

// `colours` of the garment as in ShownMesh. Throws std::invalid_argument for a wrong number of positions.
Image view_row(const Showing& showing, const Eigen::Matrix3Xd& positions, const std::vector<Colour>& colours,
               const ViewRow& row);

// Words are made smaller until they fit.
Image title_strip(const std::string& title, int width);

struct ColourLegend {
  ColourScale scale;
  std::function<Colour(double value)> colour;  // of a value in the unit of the scale
  std::string note;                            // a line below, when there is something to say
};
Image scale_strip(const ColourLegend& legend, int width);

// "-0.25" with as many digits as steps of `step` need.
std::string figure_words(double value, double step);

}  // namespace toile
