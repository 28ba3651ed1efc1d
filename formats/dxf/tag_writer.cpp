#include "formats/dxf/tag_writer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace toile::dxf {

void put(std::string& out, int code, std::string_view value) {
  const std::string digits = std::to_string(code);
  out.append(digits.size() < 3 ? 3 - digits.size() : 0, ' ');
  out += digits;
  out += '\n';
  out += value;
  out += '\n';
}

void put(std::string& out, int code, int value) { put(out, code, std::to_string(value)); }

void put_number(std::string& out, int code, double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("dxf: a number to be written is not finite");
  std::array<char, 400> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 4);
  if (error != std::errc{}) throw std::invalid_argument("dxf: a number to be written is too large");
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  put(out, code, text == "-0.0000" ? "0.0000" : text);
}

void put_xy(std::string& out, int code, const Eigen::Vector2d& at) {
  put_number(out, code, at.x());
  put_number(out, code + 10, at.y());
}

void put_section(std::string& out, std::string_view name) {
  put(out, 0, "SECTION");
  put(out, 2, name);
}

void put_section_end(std::string& out) { put(out, 0, "ENDSEC"); }

void put_line(std::string& out, std::string_view layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  put(out, 0, "LINE");
  put(out, 8, layer);
  put_xy(out, 10, from);
  put_xy(out, 11, to);
}

void put_polyline(std::string& out, std::string_view layer, const std::vector<Eigen::Vector2d>& points, bool closed) {
  put(out, 0, "POLYLINE");
  put(out, 8, layer);
  put(out, 66, 1);
  put(out, 70, closed ? 1 : 0);
  for (const Eigen::Vector2d& point : points) {
    put(out, 0, "VERTEX");
    put(out, 8, layer);
    put_xy(out, 10, point);
  }
  put(out, 0, "SEQEND");
  put(out, 8, layer);
}

void put_text(std::string& out, std::string_view layer, const Eigen::Vector2d& at, double height, std::string_view text) {
  put(out, 0, "TEXT");
  put(out, 8, layer);
  put_xy(out, 10, at);
  put_number(out, 40, height);
  put(out, 1, text);
}

void put_insert(std::string& out, std::string_view layer, std::string_view block) {
  put(out, 0, "INSERT");
  put(out, 8, layer);
  put(out, 2, block);
  put_xy(out, 10, Eigen::Vector2d::Zero());
}

}  // namespace toile::dxf
