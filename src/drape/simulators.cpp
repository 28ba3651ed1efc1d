
#include "drape/external/external.h"
#include "drape/external/program.h"
#include "drape/fem/fem.h"
#include "drape/mass_spring/mass_spring.h"
#include "drape/simulator.h"
#include "garment/report.h"

namespace toile {

const std::vector<Simulator>& simulators() {
  static const std::vector<Simulator> list{
      {"fem", "quasi-static finite elements: orthotropic membrane, bending, contact, start-anchored friction", fem::drape,
       true},
      {"fem-projected", "the same energy by projected Newton: slower, the reference for fem", fem::drape_projected, true},
      {"mass-spring", "edge springs that stiffen at the strain limit, contact, start-anchored friction", mass_spring::drape,
       false},
      {"mass-spring-explicit", "the same springs moved to rest in small steps: slower, the reference for mass-spring",
       mass_spring::drape_explicitly, false},
  };
  return list;
}

Simulator find_simulator(const std::string& name) {
  if (const auto found = external::simulator(name)) return *found;
  std::string names;
  for (const Simulator& simulator : simulators()) {
    if (simulator.name == name) return simulator;
    names += (names.empty() ? "" : ", ") + simulator.name;
  }
  for (const std::string& program : external::program_names()) names += ", external:" + program;
  throw BadInput(
      {"simulator.unknown", Severity::error, "simulator '" + name + "'", "there is no such simulator", "Use one of: " + names});
}

}  // namespace toile
