#pragma once
// Phi of the paper (Eq. 2): patterns and a starting shape in, a drape at static equilibrium out.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "body/body.h"
#include "garment/drape.h"
#include "garment/fabric.h"
#include "garment/mesh.h"

namespace toile {

struct DrapeProgress {
  int step = 0;
  double residual = 0;
  double tolerance = 0;
};

struct DrapeRequest {
  const GarmentMesh& garment;     // its rest shapes are X
  const Eigen::Matrix3Xd& start;  // x^g: one column per garment vertex; friction holds where it touches
  const Body& body;
  const Fabric& fabric;
  double tolerance = 1e-3;                // on |unbalanced force| / |weight|
  std::optional<double> time_limit = {};  // s; then the best state so far, not settled
  std::function<void(const DrapeProgress&)> progress = {};
  std::function<bool()> stop = {};  // asked between steps; once true, the best state so far, as at the time limit
};

// One entry of the list of simulators. The same request gives the same bytes.
struct Simulator {
  std::string name;
  std::string summary;
  std::function<Drape(const DrapeRequest&)> drape;
  bool holds_bends = false;  // takes the fabric's bend_friction, from the start on
};

const std::vector<Simulator>& simulators();  // those of this program

// One of that list by its name, or one that is another program: "external:NAME" for templates/simulators/NAME.toml, or the path of
// such a file (drape/external). Throws BadInput("simulator.unknown") listing the names there are.
Simulator find_simulator(const std::string& name);

}  // namespace toile
