#include "formats/html/figures.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "garment/units.h"

namespace toile::html {

std::string number(double value, int digits) {
  if (!std::isfinite(value)) throw std::invalid_argument("report: a figure is not finite");
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string mm(double metres, int digits) { return number(metres * mm_per_m, digits); }

// With its sign; a change that rounds to nothing has none.
std::string change(double metres) {
  const std::string text = mm(metres);
  return text == "-0.00" || text == "0.00" ? "0.00" : metres > 0 ? "+" + text : text;
}

std::string percent(double share, int digits) { return number(100 * share, digits); }

}  // namespace toile::html
