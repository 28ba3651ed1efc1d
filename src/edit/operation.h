#pragma once
// An edit in 3D: source drape in, target out. One entry per operation in operations().

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "body/body.h"
#include "garment/drape.h"
#include "garment/pattern.h"
#include "garment/target.h"

namespace toile {

// A parameter describes itself; flags, recipe checks and help come from this table.
struct Parameter {
  std::string name;
  std::string unit;  // "m", "deg" (given with their unit), "" (a number), "loop", "size", "file" (names)
  std::string meaning;
  std::optional<double> least, most;
  std::optional<std::string> by_default;  // as it would be written in a recipe; absent: must be given
  std::string instead_of = {};            // another parameter, of which exactly this or that is given
};

// A body that an edit names: a size of a chart, or a file.
struct BodyName {
  std::string size;            // as in the chart; empty: the file says it
  std::string file, skeleton;  // as written; no skeleton: the one beside the file
  bool operator==(const BodyName&) const = default;
};
// Makes it; throws BadInput. `place` is for messages.
using FindBody = std::function<std::shared_ptr<const Body>(const BodyName& name, const std::string& place)>;

// Another garment, sewn and hanging on the same body, of the same fabric.
struct WornGarment {
  Pattern pattern;
  GarmentMesh garment;
  Eigen::Matrix3Xd drape;
  double edge_length = 12e-3;  // m, that it was meshed with
  Report report;               // of its drape
};
// Wears the pattern file on the body; throws BadInput. `place` is for messages.
using FindGarment =
    std::function<std::shared_ptr<const WornGarment>(const std::string& file, const Body& body, const std::string& place)>;

class EditMemory;

struct EditInput {
  const Pattern& pattern;
  const GarmentMesh& garment;
  const Eigen::Matrix3Xd& drape;  // source positions
  const Body& body;
  FindBody find_body = {};        // for operations that name another body; without it they are refused
  FindGarment find_garment = {};  // likewise another garment
  EditMemory* memory = nullptr;   // of earlier edits of the same input (edit_session.h)
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
