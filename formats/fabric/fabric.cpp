// Fabric data, templates/fabrics/NAME.toml; the README there has the keys.

#include <array>
#include <string_view>

#include "formats/fabric/quantity.h"
#include "formats/fabric/test_results.h"
#include "formats/formats.h"
#include "formats/toml/toml.h"

namespace toile {
namespace {

struct Field {
  Quantity quantity;
  double Fabric::*into;
  bool TestedKeys::*tested;  // by a [test] table instead; none
};

constexpr Quantity bend_friction = quantity("bend_friction", moment_units, 0, .1, "0.3 mN");
constexpr double usual_bend_friction = 30;  // 1/m, of the mean bending stiffness: where suitings and denims lie around
constexpr Quantity friction{"friction", nullptr, 0, 0, 2, "0.4"};
constexpr std::array fields = {
    Field{quantity("area_density", per_area, .01, 2, "115 g/m^2"), &Fabric::area_density, &TestedKeys::area_density},
    Field{quantity("stretch_warp", force_per_length, 1, 1e6, "1200 N/m"), &Fabric::stretch_warp, &TestedKeys::membrane},
    Field{quantity("stretch_weft", force_per_length, 1, 1e6, "800 N/m"), &Fabric::stretch_weft, &TestedKeys::membrane},
    Field{quantity("stretch_cross", force_per_length, 0, 1e6, "100 N/m"), &Fabric::stretch_cross, &TestedKeys::membrane},
    Field{quantity("shear", force_per_length, .1, 1e6, "50 N/m"), &Fabric::shear, &TestedKeys::membrane},
    Field{quantity("bend_warp", bending_units, 1e-8, 1e-2, "9 uN m"), &Fabric::bend_warp, &TestedKeys::bend_warp},
    Field{quantity("bend_weft", bending_units, 1e-8, 1e-2, "6 uN m"), &Fabric::bend_weft, &TestedKeys::bend_weft},
    Field{friction, &Fabric::friction, nullptr},
    Field{quantity("thickness", lengths, 2e-5, 2e-2, "0.3 mm"), &Fabric::thickness, nullptr},
    Field{quantity("most_stretch", shares, .005, 2, "8 %"), &Fabric::most_stretch, nullptr},
};

void read_fields(const TomlNode& root, const TestedKeys& tested, const std::string& file, Fabric& fabric, Report& report) {
  for (const Field& field : fields) {
    const TomlNode* node = find(root, field.quantity.key);
    const bool by_test = field.tested && tested.*field.tested;
    if (node && by_test)
      report.error("fabric.given-twice", toml_place(file, *node),
                   in_quotes(field.quantity.key) + " is given, and the [test] table stands for it too",
                   "Leave one of the two out");
    else if (node)
      fabric.*field.into = quantity_in(*node, field.quantity, file, report).value_or(fabric.*field.into);
    else if (!by_test)
      report_missing(field.quantity, file, field.tested ? ", or test results under [test]" : "", report);
  }
}

}  // namespace

Loaded<Fabric> read_fabric(const std::filesystem::path& path) {
  Loaded<Fabric> out;
  const auto bytes = read_whole_file(path);
  out.report = bytes.report;
  if (!bytes.value) return out;
  const std::string file = path.filename().string();
  const auto root = parse_toml(*bytes.value, file);
  out.report.append(root.report);
  if (!root.value) return out;
  refuse_unknown_keys(*root.value,
                      {"name", "source", "area_density", "stretch_warp", "stretch_weft", "stretch_cross", "shear", "bend_warp",
                       "bend_weft", "bend_friction", "friction", "thickness", "most_stretch", "test"},
                      file, "fabric.unknown-key", out.report);
  Fabric fabric;
  fabric.name = path.stem().string();
  for (const auto& [key, into] : {std::pair{"name", &fabric.name}, std::pair{"source", &fabric.source}}) {
    const TomlNode* node = find(*root.value, key);
    if (node && node->kind != TomlKind::text)
      out.report.error("fabric.bad-value", toml_place(file, *node), in_quotes(key) + " must be a text",
                       "Write it in double quotes");
    else if (node)
      *into = node->text;
  }
  const TomlNode* test = find(*root.value, "test");
  if (test && test->kind != TomlKind::table) {
    out.report.error("fabric.bad-value", toml_place(file, *test), "'test' must be a table, not " + in_words(test->kind),
                     "Begin a line with [test] and write the test results below it");
    return out;
  }
  read_fields(*root.value, test ? tested_keys(*test) : TestedKeys{}, file, fabric, out.report);
  if (test && out.report.ok()) apply_tests(*test, file, fabric, out.report);
  fabric.bend_friction = usual_bend_friction * (fabric.bend_warp + fabric.bend_weft) / 2;
  if (const TomlNode* node = find(*root.value, bend_friction.key))
    fabric.bend_friction = quantity_in(*node, bend_friction, file, out.report).value_or(0);
  if (out.report.ok() && fabric.stretch_cross * fabric.stretch_cross >= fabric.stretch_warp * fabric.stretch_weft)
    out.report.error(
        "fabric.unstable", toml_place(file, *find(*root.value, "stretch_cross")),
        "'stretch_cross' must be smaller than the geometric mean of 'stretch_warp' and 'stretch_weft', or the cloth "
        "gives way when it is pulled",
        "A tenth to a third of the smaller one is usual");
  if (out.report.ok()) out.value = fabric;
  return out;
}

}  // namespace toile
