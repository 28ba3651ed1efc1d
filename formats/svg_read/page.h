#pragma once
// How large a drawing is meant to be: metres per user unit.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "formats/svg_read/drawing.h"
#include "garment/pattern_file.h"

namespace toile::svg {

struct Producer {
  std::string dialect;  // "Toile", "FreeSewing", "Valentina", "Seamly", "GarmentCode", "Inkscape", "Illustrator", "plain"
  std::string author;   // "FreeSewing 4.10.2"; empty when the file does not say
  double old_dpi = 0;   // pixels per inch the program draws with when that is not 96
};
Producer producer_of(const Element& root, std::string_view bytes);

struct Page {
  Eigen::Vector2d unit{.0254 / 96, .0254 / 96};      // metres per user unit, x and y
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // the view box's
  Eigen::Vector2d size = Eigen::Vector2d::Zero();    // m, zero: unknown
  FileUnits units;
  bool stated = false;  // by absolute lengths or by the user; otherwise pixels
  bool known = true;    // false: neither width nor height says anything ("100%" or nothing)

  Affine to_metres() const;  // y up
};

// From width, height and viewBox (SVG-AND-CUT-SHEETS A), or `override_unit` metres per user unit. Findings "svg.units",
// "svg.aspect".
Page page_of(const Element& root, const Producer& producer, std::optional<double> override_unit, const std::string& name,
             Report& report);

// By what factor what is drawn on `page` must be enlarged: by its test squares, else 1. Findings "svg.test-square".
double scale_by_test_squares(const Drawing& drawing, const Page& page, const std::string& name, Report& report);

// Which lines are test squares of the size that is written on them.
std::vector<std::size_t> test_squares(const Drawing& drawing);

// Whether sizes are those of garments; `largest`: the longer side of the largest piece, m. Where the file does not state its
// unit and another than the one taken fits as well or alone, the error "svg.units-ambiguous" asks.
void check_size(double largest, const Page& page, const std::string& name, Report& report);

}  // namespace toile::svg
