#pragma once
// DXF files composed in the tests, as programs write them.

#include <Eigen/Core>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "formats/dxf/tag_writer.h"
#include "garment/report.h"

namespace toile {

using Xy = std::vector<Eigen::Vector2d>;

inline std::string line_on(const char* layer, Eigen::Vector2d a, Eigen::Vector2d b) {
  std::string out;
  dxf::put_line(out, layer, a, b);
  return out;
}
inline std::string polyline_on(const char* layer, const Xy& points, bool closed) {
  std::string out;
  dxf::put_polyline(out, layer, points, closed);
  return out;
}
inline std::string point_on(const char* layer, Eigen::Vector2d at, const std::string& more = {}) {
  std::string out;
  dxf::put(out, 0, "POINT");
  dxf::put(out, 8, layer);
  dxf::put_xy(out, 10, at);
  return out + more;
}
inline std::string tag(int code, const std::string& value) {
  std::string out;
  dxf::put(out, code, value);
  return out;
}
inline std::string text_on(const char* layer, const std::string& text, Eigen::Vector2d at = {0, 0}) {
  std::string out;
  dxf::put_text(out, layer, at, 1, text);
  return out;
}
inline std::string block(const std::string& name, const std::string& entities) {
  return tag(0, "BLOCK") + tag(8, "0") + tag(2, name) + tag(70, "64") + tag(10, "0") + tag(20, "0") + entities +
         tag(0, "ENDBLK");
}
inline std::string section(const std::string& name, const std::string& members) {
  return tag(0, "SECTION") + tag(2, name) + members + tag(0, "ENDSEC");
}
// A HEADER-less file with these blocks and style texts.
inline std::string pattern_file(const std::string& blocks, const std::vector<std::string>& style = {"Units: METRIC"}) {
  std::string entities;
  for (const std::string& text : style) entities += text_on("1", text);
  return section("BLOCKS", blocks) + section("ENTITIES", entities) + tag(0, "EOF");
}

// Corners of a rectangle counter-clockwise from its lower left one.
inline Xy rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

inline const Finding* find(const Report& report, const std::string& code) {
  for (const Finding& finding : report.findings)
    if (finding.code == code) return &finding;
  return nullptr;
}
inline int count(const Report& report, const std::string& code) {
  int n = 0;
  for (const Finding& finding : report.findings) n += finding.code == code;
  return n;
}
inline std::string all_words(const Report& report) {
  std::string words;
  for (const Finding& finding : report.findings) words += in_words(finding) + "\n";
  return words;
}

}  // namespace toile
