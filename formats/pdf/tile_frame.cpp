#include "formats/pdf/tile_frame.h"

#include <algorithm>

#include "formats/svg/heading.h"
#include "formats/svg/label_place.h"
#include "formats/svg/marks.h"
#include "formats/svg/xml_text.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double widest_mark = 5;   // mm, half a diamond
constexpr double mark_space = 100;  // mm, of frame a pair of diamonds
const LineStyle border{.colour = "#b0b0b0", .width = .15e-3, .dash = {}, .shown = true};
const LineStyle trim{.colour = "#606060", .width = .25e-3, .dash = {}, .shown = true};
const LineStyle lay{.colour = "#606060", .width = .25e-3, .dash = {3e-3, 2e-3}, .shown = true};

class Frame {
 public:
  Frame(XmlText& xml, const TilePlan& plan, int row, int column, const SheetStyle& style)
      : xml_(xml),
        plan_(plan),
        row_(row),
        column_(column),
        style_(style),
        low_(plan.tiling.margin),
        high_(plan.tiling.page - plan.tiling.margin) {}

  void draw(const std::string& title, int page, int pages) {
    const Tiling& tiling = plan_.tiling;
    open_page(xml_, tiling.page.x(), tiling.page.y());
    name();
    drawn(xml_.open("rect"), border).with("x", low_.x()).with("y", low_.y());
    xml_.with("width", tiling.window().x()).with("height", tiling.window().y()).close();
    for (const int axis : {0, 1}) {
      before(axis);
      behind(axis);
    }
    header(title, page, pages);
    bars();
    xml_.close();
  }

 private:
  // The neighbour before it along `axis` (0: left, 1: above): cut there and lay on it.
  void before(int axis) {
    const int row = row_ - axis, column = column_ - (1 - axis);
    if (row < 0 || column < 0) return;
    const bool there = plan_.prints(row, column);
    if (there) {
      line(trim, axis, low_[axis]);
      for (const double at : places(axis)) half_mark(trim, axis, at, low_[axis], +mark_size());
    }
    margin_words(axis, low_[axis] - .3 * letters(axis) - .4,
                 there ? "cut here, lay on " + tile_name(row, column) : tile_name(row, column) + " is empty: not printed");
  }

  // The neighbour behind it (right, below): comes up to the dashed line.
  void behind(int axis) {
    const int row = row_ + axis, column = column_ + (1 - axis);
    if (row >= plan_.tiling.rows || column >= plan_.tiling.columns) return;
    const bool there = plan_.prints(row, column);
    if (there) {
      const double joint = high_[axis] - plan_.tiling.overlap;
      line(lay, axis, joint);
      for (const double at : places(axis)) {
        half_mark(trim, axis, at, joint, -mark_size());
        if (plan_.tiling.overlap >= mark_size()) half_mark(lay, axis, at, joint, +mark_size());
      }
    }
    margin_words(axis, high_[axis] + letters(axis) + .6,
                 there ? tile_name(row, column) + " comes here, up to the dashed line"
                       : tile_name(row, column) + " is empty: not printed");
  }

  double mark_size() const { return std::min(widest_mark, std::max(3.0, plan_.tiling.overlap)); }

  // Along the frame, evenly; the same for both neighbours.
  std::vector<double> places(int axis) const {
    const double length = high_[1 - axis] - low_[1 - axis];
    const int count = std::max(2, static_cast<int>(length / mark_space));
    std::vector<double> at;
    for (int i = 0; i < count; ++i) at.push_back(low_[1 - axis] + length * (i + .5) / count);
    return at;
  }

  Vector2d point(int axis, double across, double along) const {
    return axis == 0 ? Vector2d(across, along) : Vector2d(along, across);
  }

  void line(const LineStyle& style, int axis, double across) {
    path(style, path_data({point(axis, across, low_[1 - axis]), point(axis, across, high_[1 - axis])}, false));
  }

  void half_mark(const LineStyle& style, int axis, double along, double across, double size) {
    path(style, path_data({point(axis, across, along - mark_size()), point(axis, across + size, along),
                           point(axis, across, along + mark_size())},
                          false));
  }

  void path(const LineStyle& style, const std::string& data) { drawn(xml_.open("path"), style).with("d", data).close(); }

  double letters(int axis) const { return std::min(2.6, .3 * plan_.tiling.margin[axis]); }

  // In the margin, `across` at the base of the letters, in the middle of the frame; words beside the page run upwards.
  void margin_words(int axis, double across, const std::string& words) {
    if (letters(axis) <= 0) return;
    const Vector2d at = point(axis, across, (low_[1 - axis] + high_[1 - axis]) / 2);
    xml_.open("g").with("transform",
                        "translate(" + in_digits(at.x()) + "," + in_digits(at.y()) + ")" + (axis == 0 ? " rotate(-90)" : ""));
    lettered(xml_.open("text"), style_, letters(axis)).with("text-anchor", "middle").text(words).close();
    xml_.close();
  }

  void name() {
    const Vector2d middle = (low_ + high_) / 2;
    const double size = std::clamp((high_ - low_).minCoeff() / 6, 10.0, 60.0);
    xml_.open("text").with("font-family", style_.font).with("font-size", size).with("fill", "#dedede");
    xml_.with("text-anchor", "middle").with("x", middle.x()).with("y", middle.y() + .35 * size);
    xml_.text(tile_name(row_, column_)).close();
  }

  // Name, title and number of the page above the frame.
  void header(const std::string& title, int page, int pages) {
    const double size = letters(1);
    if (size <= 0) return;
    const double y = low_.y() - .3 * size - .4;
    const auto room = static_cast<std::size_t>((high_.x() - low_.x()) / 3 / text_width("n") / size);
    const std::string words = tile_name(row_, column_) + "  " + title;
    lettered(xml_.open("text"), style_, size).with("x", low_.x()).with("y", y).text(shortened(words, room)).close();
    lettered(xml_.open("text"), style_, size).with("text-anchor", "end").with("x", high_.x()).with("y", y);
    xml_.text("page " + std::to_string(page) + " of " + std::to_string(pages)).close();
  }

  // To `letters` letters, whole ones of UTF-8.
  static std::string shortened(const std::string& words, std::size_t letters) {
    std::size_t seen = 0, end = 0;
    for (; end < words.size(); ++end)
      if ((static_cast<unsigned char>(words[end]) & 0xC0U) != 0x80U && seen++ == letters) break;
    return words.substr(0, end);
  }

  // 50 mm and 2 in below the frame, where the words there leave room.
  void bars() {
    const double size = letters(1);
    if (size <= 0 || high_.x() - low_.x() < 185) return;
    bar(low_.x(), 50, "50 mm", false);
    bar(high_.x() - 50.8, 50.8, "2 in", true);
  }

  void bar(double from, double length, const char* words, bool words_before) {
    const double size = letters(1), y = high_.y() + 1.5 + size / 2, to = from + length;
    path(trim, path_data({{from, y - 1.2}, {from, y + 1.2}}, false) + " " + path_data({{to, y - 1.2}, {to, y + 1.2}}, false) +
                   " " + path_data({{from, y}, {to, y}}, false));
    lettered(xml_.open("text"), style_, size).with("text-anchor", words_before ? "end" : "start");
    xml_.with("x", words_before ? from - 1.5 : to + 1.5).with("y", y + .35 * size).text(words).close();
  }

  XmlText& xml_;
  const TilePlan& plan_;
  int row_, column_;
  const SheetStyle& style_;
  Vector2d low_, high_;  // corners of the frame on the page
};

}  // namespace

std::string tile_frame(const TilePlan& plan, int row, int column, const std::string& title, int page, int pages,
                       const SheetStyle& style) {
  XmlText xml;
  Frame(xml, plan, row, column, style).draw(title, page, pages);
  return xml.done();
}

}  // namespace toile
