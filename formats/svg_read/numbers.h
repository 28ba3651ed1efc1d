#pragma once
// Numbers, lengths and transforms as SVG writes them.

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toile::svg {

using Affine = Eigen::Transform<double, 2, Eigen::Affine>;

// Reads what SVG attributes hold from the left: "1.5.5-3e2" is 1.5, .5, -300. Independent of the locale.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  void skip_blanks();  // and commas
  bool at_end();
  char peek();                     // the next character that is no blank or comma; 0 at the end
  char take();                     // the same, taken
  std::optional<double> number();  // may be infinite ("1e999"); nothing when there is none
  std::optional<bool> flag();      // of an arc: "0" or "1", glued to what follows
  std::string word();              // letters, '%'
  std::size_t place() const { return at_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

// A length and its unit in lower case: "", "px", "mm", "%", ...
struct Length {
  double value = 0;
  std::string unit;
};
std::optional<Length> length_of(std::string_view text);

// Metres of an absolute unit (mm, cm, m, in, pt, pc, q); nothing for px, % and the like.
std::optional<double> metres_per(const std::string& unit);

// In user units: px and none as they are, absolute units at 96 per inch, anything else nothing.
std::optional<double> user_units(std::string_view text);

std::vector<double> numbers_in(std::string_view text);

// translate, scale, rotate, skewX, skewY, matrix in any number; nothing when it cannot be read.
std::optional<Affine> transform_of(std::string_view text);

}  // namespace toile::svg
