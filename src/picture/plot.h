#pragma once
// Figures by step as lines, one for each series, with axes and a key.

#include <string>
#include <vector>

#include "picture/image.h"

namespace toile {

struct Series {
  std::string name;
  std::vector<double> values;  // at 0, 1, 2, ...
};

struct LinePlot {
  std::string title, across, up;  // what the axes count
  std::vector<Series> series;
};

// 1200 pixels wide. Throws std::invalid_argument for a figure that is not finite or a plot without any.
Image line_plot(const LinePlot& plot);

}  // namespace toile
