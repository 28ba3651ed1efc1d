#pragma once
// An edit in 3D: source drape in, target out. One entry per operation in operations().

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "body/body.h"
#include "garment/drape.h"
#include "garment/pattern.h"
#include "garment/target.h"

namespace toile {

// A parameter describes itself; flags, recipe checks and help come from this table.
struct Parameter {
  std::string name;
  std::string unit;  // "m" (given with its unit), "" (a number), "loop" (a name)
  std::string meaning;
  std::optional<double> least, most;
  std::optional<std::string> by_default;  // as it would be written in a recipe; absent: must be given
};

struct EditInput {
  const Pattern& pattern;
  const GarmentMesh& garment;
  const Eigen::Matrix3Xd& drape;  // source positions
  const Body& body;
};

using EditArguments = std::map<std::string, std::string>;  // as written: {"loop", "hem"}, {"by", "-10 cm"}

struct EditOperation {
  std::string name;
  std::string summary;
  std::vector<Parameter> parameters;
  std::function<Target(const EditInput&, const EditArguments&)> apply;  // throws BadInput
};

const std::vector<EditOperation>& operations();
const EditOperation& find_operation(const std::string& name);  // throws BadInput("edit.unknown-operation")

}  // namespace toile
