#pragma once
// What an SVG draws, in metres with y up: lines, texts and marks with what is written on them and the groups they are in.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formats/svg_read/path.h"
#include "formats/svg_read/style.h"
#include "garment/report.h"

namespace toile::svg {

// What is written on an element.
struct Names {
  std::string element, id, label;  // label: inkscape:label, aria-label or <title>
  std::vector<std::string> classes;
  std::map<std::string, std::string> data;  // "data-type" -> "piece"; keys without "data-"
  int line = 0;

  bool has_class(const std::string& name) const;
  std::string datum(const std::string& key) const;  // empty when absent
};

Names names_of(const Element& element);

struct Group {
  Names names;
  int parent = -1;  // index into Drawing::groups
  bool layer = false;
};

struct DrawnLine {
  Sampled shape;
  Names names;
  int group = 0;
  int path = 0;  // number of the element it is part of
  bool dashed = false, filled = false, stroked = false;
  std::string stroke, marker_start, marker_end;
};

struct DrawnText {
  std::string words;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double size = 0;  // m, of the letters
  bool bold = false;
  Names names;
  int group = 0;
};

// A <use> of a symbol that stands for one thing, such as a notch.
struct DrawnMark {
  std::string symbol;  // its id
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  Names names;
  int group = 0;
};

struct Drawing {
  std::vector<Group> groups;  // [0] is the root
  std::vector<DrawnLine> lines;
  std::vector<DrawnText> texts;
  std::vector<DrawnMark> marks;
  std::map<std::string, int> left_out;  // "hidden", "picture", ...: how many elements
  bool within(int group, int ancestor) const;
};

// `to_metres`: of the root's user units. Errors: "svg.too-many-elements", "svg.too-many-points", "svg.use-too-deep",
// "svg.bad-number" (NaN, beyond 1e300, or a coordinate beyond 10 km); warnings "svg.bad-path", "svg.bad-transform".
Drawing drawing_of(const Element& root, const Affine& to_metres, const std::string& name, Report& report);

}  // namespace toile::svg
