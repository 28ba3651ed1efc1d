#include "formats/fabric/test_results.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "formats/fabric/quantity.h"

namespace toile {
namespace {

constexpr double standard_gravity = 9.80665;  // m/s^2
constexpr double usual_cross = 0.2;           // of the weaker direction
constexpr double most_coupled = 0.9;          // C12^2 / (C11 C22); 1 gives way when it is pulled

constexpr Quantity weight = quantity("weight", per_area, .01, 2, "180 g/m^2");
constexpr Quantity strip_width = quantity("strip_width", lengths, .005, .5, "5 cm");
constexpr Quantity load = quantity("load", loads, 1e-4, 1e3, "100 g");
constexpr Quantity stretch = quantity("stretch", shares, 1e-4, 2, "1.5 %");
constexpr Quantity narrowing{"narrowing", nullptr, 0, 0, 2, "0.25"};
constexpr Quantity bending_length_warp = quantity("bending_length_warp", lengths, 2e-3, .2, "1.9 cm");
constexpr Quantity bending_length_weft = quantity("bending_length_weft", lengths, 2e-3, .2, "1.7 cm");
constexpr const char* strips[] = {"warp", "weft", "bias"};

double green_strain(const StripTest& test) { return test.stretch + test.stretch * test.stretch / 2; }

// 1/Y: Green strain per second Piola-Kirchhoff stress.
double compliance(const StripTest& test) { return green_strain(test) * (1 + test.stretch) / test.tension; }

std::optional<double> needed(const TomlNode& test, const Quantity& q, const std::string& file, Report& report) {
  if (const TomlNode* node = find(test, q.key)) return quantity_in(*node, q, file, report);
  report_missing(q, toml_place(file, test), " under [test]", report);
  return std::nullopt;
}

// "100 g at 1.5 %"
std::optional<StripTest> strip_test(const TomlNode& test, const char* key, double width, const std::string& file,
                                    Report& report) {
  const std::string remedy =
      std::string("Write for example ") + key +
      " = \"100 g at 1.5 %\": the load that hangs on the strip and how much longer it makes it; loads in " + unit_names(load);
  const TomlNode* node = find(test, key);
  if (!node) {
    report.error("fabric.missing", toml_place(file, test), "the [test] table has no " + in_quotes(key), remedy);
    return std::nullopt;
  }
  const std::string& text = node->text;
  const std::size_t at = node->kind == TomlKind::text ? text.find(" at ") : std::string::npos;
  const auto force = at == std::string::npos ? std::nullopt : in_si(std::string_view(text).substr(0, at), load);
  const auto longer = at == std::string::npos ? std::nullopt : in_si(std::string_view(text).substr(at + 4), stretch);
  if (!force || !longer) {
    report.error("fabric.bad-value", toml_place(file, *node),
                 in_quotes(key) + " must be a load and a stretch, not " +
                     (node->kind == TomlKind::text ? toml_quoted(text) : in_words(node->kind)),
                 remedy);
    return std::nullopt;
  }
  if (!(*force >= load.low && *force <= load.high && *longer >= stretch.low && *longer <= stretch.high)) {
    report.error("fabric.out-of-range", toml_place(file, *node),
                 in_quotes(key) + " is far from what any clothing fabric does: " + text,
                 "Check the units; the stretch must be at least 0.01 %. Cloth that gives less needs a longer strip");
    return std::nullopt;
  }
  return StripTest{*force / width, *longer};
}

void apply_strips(const TomlNode& test, const std::string& file, Fabric& fabric, Report& report) {
  const auto width = needed(test, strip_width, file, report);
  if (!width) return;
  StripTests tests;
  StripTest* into[] = {&tests.warp, &tests.weft, &tests.bias};
  bool complete = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto strip = strip_test(test, strips[i], *width, file, report);
    complete = complete && strip;
    if (!strip) continue;
    *into[i] = *strip;
    if (i < 2 && green_strain(*strip) > fabric.most_stretch) {
      complete = false;
      report.error("fabric.test-beyond-limit", toml_place(file, *find(test, strips[i])),
                   in_quotes(strips[i]) + " was stretched beyond 'most_stretch', where cloth stiffens",
                   "Test with a smaller load, one that a hanging garment puts on its cloth (5-50 g per cm of width), or raise "
                   "'most_stretch'");
    }
  }
  if (const TomlNode* node = find(test, narrowing.key)) {
    tests.narrowing = quantity_in(*node, narrowing, file, report);
    complete = complete && tests.narrowing;
  }
  if (!complete) return;
  const auto stiffness = membrane_stiffness(tests);
  if (!stiffness) {
    report.error("fabric.test-contradicts", toml_place(file, *find(test, narrowing.key)),
                 "'narrowing' is more than a cloth of these stretches can do",
                 "Measure the width in the middle of the warp strip; or leave 'narrowing' out");
    return;
  }
  if (stiffness->shear <= 0) {
    report.error("fabric.test-contradicts", toml_place(file, *find(test, "bias")),
                 "the bias strip gave less than the threads alone give, as 'warp' and 'weft' were tested",
                 "Test all three strips again with loads of the same order; the bias gives most");
    return;
  }
  for (const auto& [key, value] : {std::pair{"warp", stiffness->warp}, {"weft", stiffness->weft}, {"bias", stiffness->shear}})
    if (!(value >= .1 && value <= 1e6))
      report.error("fabric.out-of-range", toml_place(file, *find(test, key)),
                   in_quotes(key) + " makes a stiffness far from that of any clothing fabric",
                   "Check the load, the stretch and 'strip_width'");
  fabric.stretch_warp = stiffness->warp;
  fabric.stretch_weft = stiffness->weft;
  fabric.stretch_cross = stiffness->cross;
  fabric.shear = stiffness->shear;
}

}  // namespace

std::optional<MembraneStiffness> membrane_stiffness(const StripTests& tests) {
  const double warp = compliance(tests.warp), weft = compliance(tests.weft);
  // C12 as share of the weaker C is the narrowing of the strip of the stronger direction.
  const double usual = warp <= weft ? usual_cross : usual_cross * weft / warp;
  const double n = tests.narrowing.value_or(usual);
  const double square = n * n * warp / weft;
  if (square > most_coupled) return std::nullopt;
  MembraneStiffness found;
  found.warp = 1 / warp / (1 - square);
  found.weft = 1 / weft / (1 - square);
  found.cross = n * found.weft;
  const double slide = 4 * compliance(tests.bias) - (warp + weft - 2 * n * warp);
  found.shear = slide > 0 ? 1 / slide : 0;
  return found;
}

double bending_stiffness(double area_density, double bending_length) {
  return area_density * standard_gravity * bending_length * bending_length * bending_length;
}

TestedKeys tested_keys(const TomlNode& test) {
  const auto has = [&](const char* key) { return find(test, key) != nullptr; };
  return {has(weight.key), has(strip_width.key) || has(narrowing.key) || std::any_of(std::begin(strips), std::end(strips), has),
          has(bending_length_warp.key), has(bending_length_weft.key)};
}

void apply_tests(const TomlNode& test, const std::string& file, Fabric& fabric, Report& report) {
  refuse_unknown_keys(
      test,
      {weight.key, strip_width.key, "warp", "weft", "bias", narrowing.key, bending_length_warp.key, bending_length_weft.key},
      file, "fabric.unknown-key", report);
  const TestedKeys has = tested_keys(test);
  if (has.area_density) fabric.area_density = needed(test, weight, file, report).value_or(fabric.area_density);
  if (has.membrane) apply_strips(test, file, fabric, report);
  const auto bend = [&](const Quantity& length, double& into) {
    const auto c = needed(test, length, file, report);
    if (!c) return;
    into = bending_stiffness(fabric.area_density, *c);
    if (!(into >= 1e-8 && into <= 1e-2))
      report.error("fabric.out-of-range", toml_place(file, *find(test, length.key)),
                   in_quotes(length.key) + " makes a bending stiffness far from that of any clothing fabric",
                   "Check the unit: the bending length is half the overhang that droops to 41.5 degrees, usually 1 to 4 cm");
  };
  if (has.bend_warp) bend(bending_length_warp, fabric.bend_warp);
  if (has.bend_weft) bend(bending_length_weft, fabric.bend_weft);
}

}  // namespace toile
