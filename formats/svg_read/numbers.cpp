#include "formats/svg_read/numbers.h"

#include <cctype>
#include <charconv>
#include <cmath>

#include "garment/units.h"

namespace toile::svg {

void Scanner::skip_blanks() {
  while (at_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[at_])) || text_[at_] == ',')) ++at_;
}

bool Scanner::at_end() { return peek() == 0; }

char Scanner::peek() {
  skip_blanks();
  return at_ < text_.size() ? text_[at_] : '\0';
}

char Scanner::take() {
  const char c = peek();
  if (c) ++at_;
  return c;
}

std::optional<double> Scanner::number() {
  skip_blanks();
  std::size_t i = at_;
  const auto digits = [&] {
    const std::size_t from = i;
    while (i < text_.size() && std::isdigit(static_cast<unsigned char>(text_[i]))) ++i;
    return i - from;
  };
  const bool plus = i < text_.size() && text_[i] == '+';
  if (i < text_.size() && (text_[i] == '+' || text_[i] == '-')) ++i;
  std::size_t count = digits();
  if (i < text_.size() && text_[i] == '.') {
    ++i;
    count += digits();
  }
  if (count == 0) return {};
  const std::size_t mantissa = i;
  if (i < text_.size() && (text_[i] == 'e' || text_[i] == 'E')) {
    ++i;
    if (i < text_.size() && (text_[i] == '+' || text_[i] == '-')) ++i;
    if (digits() == 0) i = mantissa;  // "1em"
  }
  double value = 0;
  const char* begin = text_.data() + at_ + (plus ? 1 : 0);
  const auto result = std::from_chars(begin, text_.data() + i, value);
  if (result.ec == std::errc::result_out_of_range) {
    const std::string_view exponent = text_.substr(mantissa, i - mantissa);
    value = exponent.find('-') != std::string_view::npos ? 0.0 : INFINITY;
  }
  at_ = i;
  return value;
}

std::optional<bool> Scanner::flag() {
  const char c = peek();
  if (c != '0' && c != '1') return {};
  ++at_;
  return c == '1';
}

std::string Scanner::word() {
  skip_blanks();
  std::string found;
  while (at_ < text_.size() && (std::isalpha(static_cast<unsigned char>(text_[at_])) || text_[at_] == '%'))
    found += text_[at_++];
  return found;
}

std::optional<Length> length_of(std::string_view text) {
  Scanner scanner(text);
  const std::optional<double> value = scanner.number();
  if (!value || !std::isfinite(*value)) return {};
  Length length{*value, {}};
  if (!scanner.at_end()) length.unit = scanner.word();
  for (char& c : length.unit) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (!scanner.at_end()) return {};
  return length;
}

std::optional<double> metres_per(const std::string& unit) {
  if (unit == "mm") return 1e-3;
  if (unit == "cm") return 1e-2;
  if (unit == "m") return 1.0;
  if (unit == "q") return .25e-3;
  if (unit == "in") return .0254;
  if (unit == "pt") return .0254 / 72;
  if (unit == "pc") return .0254 / 6;
  return {};
}

std::optional<double> user_units(std::string_view text) {
  const std::optional<Length> length = length_of(text);
  if (!length) return {};
  if (length->unit.empty() || length->unit == "px") return length->value;
  if (const std::optional<double> metres = metres_per(length->unit)) return length->value * *metres / .0254 * 96;
  return {};
}

std::vector<double> numbers_in(std::string_view text) {
  Scanner scanner(text);
  std::vector<double> numbers;
  while (const std::optional<double> number = scanner.number()) numbers.push_back(*number);
  return numbers;
}

namespace {

std::optional<Affine> one_transform(const std::string& name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  for (const double x : v)
    if (!std::isfinite(x)) return {};
  Affine t = Affine::Identity();
  if (name == "matrix" && n == 6) {
    t.linear() << v[0], v[2], v[1], v[3];
    t.translation() << v[4], v[5];
  } else if (name == "translate" && (n == 1 || n == 2)) {
    t.translate(Eigen::Vector2d(v[0], n == 2 ? v[1] : 0));
  } else if (name == "scale" && (n == 1 || n == 2)) {
    t.scale(Eigen::Vector2d(v[0], n == 2 ? v[1] : v[0]));
  } else if (name == "rotate" && (n == 1 || n == 3)) {
    const Eigen::Vector2d about = n == 3 ? Eigen::Vector2d(v[1], v[2]) : Eigen::Vector2d::Zero();
    t.translate(about).rotate(v[0] * units::degree).translate(-about);
  } else if ((name == "skewX" || name == "skewY") && n == 1) {
    t.linear()(name == "skewX" ? 0 : 1, name == "skewX" ? 1 : 0) = std::tan(v[0] * units::degree);
  } else {
    return {};
  }
  return t;
}

}  // namespace

std::optional<Affine> transform_of(std::string_view text) {
  Scanner scanner(text);
  Affine whole = Affine::Identity();
  while (!scanner.at_end()) {
    const std::string name = scanner.word();
    if (name == "none" && scanner.at_end()) return whole;
    if (name.empty() || scanner.take() != '(') return {};
    std::vector<double> values;
    while (const std::optional<double> value = scanner.number()) {
      values.push_back(*value);
      const std::string unit = scanner.peek() == ')' ? "" : scanner.word();  // CSS: "10px", "45deg"
      if (!unit.empty() && unit != "px" && unit != "deg") return {};
    }
    if (scanner.take() != ')') return {};
    const std::optional<Affine> one = one_transform(name, values);
    if (!one) return {};
    whole = whole * *one;
  }
  return whole;
}

}  // namespace toile::svg
