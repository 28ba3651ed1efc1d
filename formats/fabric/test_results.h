#pragma once
// What anyone can measure with weights, scales and a ruler, turned into the stiffnesses of a fabric.

#include <optional>
#include <string>

#include "formats/toml/toml.h"
#include "garment/fabric.h"
#include "garment/report.h"

namespace toile {

// A strip hung with a weight.
struct StripTest {
  double tension = 0;  // N per metre of the strip's width before it is loaded
  double stretch = 0;  // of its length
};

struct StripTests {
  StripTest warp, weft, bias;       // cut along the grain, across it, at 45 degrees
  std::optional<double> narrowing;  // of the warp strip: how much narrower, for how much longer
};

struct MembraneStiffness {
  double warp = 0, weft = 0, cross = 0, shear = 0;  // N/m
};

// The stiffnesses with which a cloth of St. Venant-Kirchhoff's law stretches exactly as tested. With stretch e under tension f
// the Green strain is E = e + e^2/2 and the second Piola-Kirchhoff stress s = f / (1 + e). Free to narrow, the strips give
//   Y1 = s/E (warp), Y2 = s/E (weft), and on the bias E/s = (1/Y1 + 1/Y2 - 2 n/Y1 + 1/G) / 4  with n the narrowing
// (for small stretch and stiff threads G = f / 4e, the FAST-3 rule G [N/m] = 123 / EB5 [%] at 5 gf/cm), then
//   C11 = Y1 / (1 - n^2 Y2/Y1), C22 = Y2 / (1 - n^2 Y2/Y1), C12 = n C22.
// Without a measured narrowing C12 is a fifth of the smaller of C11, C22. Nothing when n is more than any cloth's
// (n^2 Y2 > .9 Y1); shear is 0 when the bias gave less than warp and weft alone give.
std::optional<MembraneStiffness> membrane_stiffness(const StripTests&);

// N m; a strip of this weight (kg/m^2) and bending length (m), Peirce 1930: B = weight x gravity x length^3.
double bending_stiffness(double area_density, double bending_length);

// Which of a fabric's keys its [test] table stands for.
struct TestedKeys {
  bool area_density = false, membrane = false, bend_warp = false, bend_weft = false;
};
TestedKeys tested_keys(const TomlNode& test);

// Fills what `tested_keys` names; `fabric` has the rest already. Errors "fabric.missing", "fabric.bad-value",
// "fabric.out-of-range", "fabric.unknown-key", "fabric.test-contradicts", "fabric.test-beyond-limit".
void apply_tests(const TomlNode& test, const std::string& file, Fabric& fabric, Report& report);

}  // namespace toile
