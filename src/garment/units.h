#pragma once
// One unit inside: metres, radians, kilograms, newtons. Every other unit is named where it enters or leaves.

#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace toile {

inline namespace units {
constexpr double operator""_m(long double v) { return static_cast<double>(v); }
constexpr double operator""_cm(long double v) { return static_cast<double>(v) * 1e-2; }
constexpr double operator""_mm(long double v) { return static_cast<double>(v) * 1e-3; }
constexpr double operator""_inch(long double v) { return static_cast<double>(v) * 0.0254; }
constexpr double degree = std::numbers::pi / 180;
constexpr double mm_per_m = 1e3;
constexpr double cm_per_m = 1e2;
}  // namespace units

// Reads a length with its unit into metres: "1.5 cm", "-10cm", "15mm", "5/8 in", "0.2 m". A bare number other than zero is
// refused (empty result), as is any other unit; the caller words the error, because it knows the place.
std::optional<double> parse_length(std::string_view text);

// "12.3 mm", with `digits` digits after the point.
std::string in_mm(double metres, int digits = 1);

}  // namespace toile
