#pragma once
// A number with its unit, as fabric files write it: "115 g/m^2".

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "formats/toml/toml.h"
#include "garment/report.h"

namespace toile {

struct Unit {
  const char* name;
  double si;
};

// 1 gf = 9.80665e-3 N. Bending stiffness in gf cm^2/cm is what a Kawabata (KES-FB2) tester prints, uN m what FAST-2 prints;
// stretch in gf/cm is a Kawabata tension. 1 momme is 4.340 g/m^2.
inline constexpr std::array<Unit, 6> per_area = {
    {{"kg/m^2", 1}, {"kg/m2", 1}, {"g/m^2", 1e-3}, {"g/m2", 1e-3}, {"oz/yd^2", 0.0339057475}, {"momme", 4.340e-3}}};
inline constexpr std::array<Unit, 4> force_per_length = {{{"N/m", 1}, {"kN/m", 1e3}, {"N/cm", 1e2}, {"gf/cm", 0.980665}}};
inline constexpr std::array<Unit, 5> bending_units = {
    {{"N m", 1}, {"mN m", 1e-3}, {"uN m", 1e-6}, {"\u00b5N m", 1e-6}, {"gf cm^2/cm", 9.80665e-5}}};
// Moment per width: a Kawabata tester prints 2HB in gf cm/cm.
inline constexpr std::array<Unit, 5> moment_units = {
    {{"N", 1}, {"mN", 1e-3}, {"uN", 1e-6}, {"\u00b5N", 1e-6}, {"gf cm/cm", 9.80665e-3}}};
inline constexpr std::array<Unit, 3> lengths = {{{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}}};
inline constexpr std::array<Unit, 1> shares = {{{"%", 1e-2}}};
// A mass stands for its weight.
inline constexpr std::array<Unit, 5> loads = {{{"g", 9.80665e-3}, {"gf", 9.80665e-3}, {"kg", 9.80665}, {"N", 1}, {"cN", 1e-2}}};

struct Quantity {
  const char* key;
  const Unit* units;
  std::size_t unit_count;  // 0: a bare number
  double low, high;        // SI; outside is not a clothing fabric
  const char* example;
};

template <std::size_t N>
constexpr Quantity quantity(const char* key, const std::array<Unit, N>& units, double low, double high, const char* example) {
  return {key, units.data(), N, low, high, example};
}

// SI; nothing when there is no number or its unit is not one of the quantity's.
std::optional<double> in_si(std::string_view text, const Quantity&);

// "kg/m^2, g/m^2, ..."
std::string unit_names(const Quantity&);

// The value of `node` in SI; else errors "fabric.bad-value" or "fabric.out-of-range" in `report`.
std::optional<double> quantity_in(const TomlNode& node, const Quantity&, const std::string& file, Report& report);

// Error "fabric.missing" with a line to add.
void report_missing(const Quantity&, const std::string& place, const std::string& hint, Report& report);

std::string in_quotes(std::string_view key);

}  // namespace toile
