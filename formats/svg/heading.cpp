#include "formats/svg/heading.h"

#include <algorithm>
#include <string>

#include "formats/svg/label_place.h"
#include "formats/svg/marks.h"
#include "garment/units.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double margin = 10;  // mm

struct Block {
  double width, height;
  std::function<void(XmlText&, const Vector2d&)> draw;  // from its upper left corner
};

std::vector<std::string> wrapped(const std::string& words, double width, double size) {
  std::vector<std::string> lines(1);
  for (std::size_t begin = 0; begin <= words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    if (!lines.back().empty() && size * text_width(lines.back() + " " + word) > width)
      lines.push_back(word);
    else
      lines.back() += (lines.back().empty() ? "" : " ") + word;
    begin = end + 1;
  }
  return lines;
}

struct Words {
  std::string words;
  double size;
};

Block text_block(const CutSheet& sheet, const SheetStyle& style, double width) {
  const double size = style.heading_text * mm_per_m;
  std::vector<Words> lines;
  const auto add = [&](const std::string& words, double letters) {
    for (const std::string& line : wrapped(words, width, letters)) lines.push_back({line, letters});
  };
  if (!sheet.title.empty()) add(sheet.title, 2 * size);
  add("Print or plot at actual size (100 %, never \"fit to page\"); measure both squares before cutting.", size);
  for (const std::string& note : sheet.notes) add(note, size);
  Block block{0, 0, {}};
  for (const Words& line : lines) {
    block.width = std::max(block.width, line.size * text_width(line.words));
    block.height += 1.4 * line.size;
  }
  block.draw = [lines, &style](XmlText& xml, const Vector2d& corner) {
    double y = corner.y();
    for (const Words& line : lines) {
      y += 1.4 * line.size;
      lettered(xml.open("text"), style, line.size)
          .with("x", corner.x())
          .with("y", y - 0.3 * line.size)
          .text(line.words)
          .close();
    }
  };
  return block;
}

Block test_square(double side, const std::string& words, const std::string& other, const char* name, const SheetStyle& style) {
  return {side, side, [=, &style](XmlText& xml, const Vector2d& corner) {
            drawn(xml.open("rect"), style.frame).with("data-type", "test-square").with("data-side", name);
            xml.with("x", corner.x()).with("y", corner.y()).with("width", side).with("height", side).close();
            double y = corner.y() + side / 2;
            for (const std::string& line : {words, other}) {
              lettered(xml.open("text"), style, 4)
                  .with("text-anchor", "middle")
                  .with("x", corner.x() + side / 2)
                  .with("y", y)
                  .text(line)
                  .close();
              y += 6;
            }
          }};
}

Block legend(const SheetStyle& style) {
  struct Row {
    LineStyle line;
    std::string words;
    const char* mark;
  };
  std::vector<Row> rows;
  const auto add = [&](const LineStyle& line, const char* words, const char* mark) {
    if (line.shown) rows.push_back({line, words, mark});
  };
  add(style.cut, "cut line", "line");
  add(style.sew, "sew line (net)", "line");
  add(style.notch, "notch: snip from the cut line", "notch");
  add(style.grain, "grain: along the warp", "grain");
  add(style.internal, "internal line: mark, do not cut", "line");
  add(style.drill, "drill hole", "drill");
  const double size = style.heading_text * mm_per_m;
  Block block{0, 1.6 * size * static_cast<double>(rows.size()), {}};
  for (const Row& row : rows) block.width = std::max(block.width, 30 + size * text_width(row.words));
  block.draw = [rows, size, &style](XmlText& xml, const Vector2d& corner) {
    double y = corner.y() + 0.8 * size;
    for (const Row& row : rows) {
      const Vector2d from(corner.x(), y), to(corner.x() + 25, y), middle = (from + to) / 2;
      const std::string mark = row.mark;
      std::string data = path_data({from, to}, false);
      if (mark == "notch") data += " " + path_data({middle, middle + Vector2d(0, 0.7 * size)}, false);
      if (mark == "drill") data = crossed_circle(middle, 0.7 * size);
      drawn(xml.open("path"), row.line).with("d", data).close();
      if (mark == "grain") xml.open("path").with("fill", row.line.colour).with("d", arrow_heads(from, to, 0.8 * size)).close();
      lettered(xml.open("text"), style, size).with("x", to.x() + 5).with("y", y + 0.35 * size).text(row.words).close();
      y += 1.6 * size;
    }
  };
  return block;
}

}  // namespace

Heading heading_of(const CutSheet& sheet, const SheetStyle& style, double width) {
  std::vector<Block> blocks{text_block(sheet, style, std::min(width - 2 * margin, 360.0))};
  if (style.frame.shown) {
    blocks.push_back(test_square(50, "50 mm", "5 cm square", "50mm", style));
    blocks.push_back(test_square(50.8, "2 in", "2 inch square", "2in", style));
    blocks.push_back(legend(style));
  }
  Heading heading;
  Vector2d corner(margin, margin);
  double row = 0;
  for (Block& block : blocks) {
    if (corner.x() > margin && corner.x() + block.width > width - margin) {
      corner = {margin, corner.y() + row + margin};
      row = 0;
    }
    heading.blocks.push_back([draw = std::move(block.draw), corner](XmlText& xml) { draw(xml, corner); });
    corner.x() += block.width + 1.5 * margin;
    row = std::max(row, block.height);
  }
  heading.height = corner.y() + row + margin;
  return heading;
}

XmlText& open_page(XmlText& xml, double width, double height) {
  xml.open("svg").with("xmlns", "http://www.w3.org/2000/svg").with("version", "1.1");
  xml.with("width", in_digits(width) + "mm").with("height", in_digits(height) + "mm");
  return xml.with("viewBox", "0 0 " + in_digits(width) + " " + in_digits(height));
}

XmlText& drawn(XmlText& xml, const LineStyle& line, const char* fill) {
  xml.with("fill", fill).with("stroke", line.colour).with("stroke-width", line.width * mm_per_m);
  std::string dash;
  for (const double part : line.dash) dash += (dash.empty() ? "" : " ") + in_digits(part * mm_per_m);
  return dash.empty() ? xml : xml.with("stroke-dasharray", dash);
}

XmlText& lettered(XmlText& xml, const SheetStyle& style, double size) {
  return xml.with("font-family", style.font).with("font-size", size).with("fill", style.text_colour);
}

}  // namespace toile
