#include "drape/mass_spring/mass_spring.h"

#include <chrono>
#include <stdexcept>

#include "drape/fem/fem.h"
#include "drape/guards.h"
#include "drape/mass_spring/relaxation.h"

namespace toile::mass_spring {

fem::Model make_model(const GarmentMesh& garment, const Fabric& fabric, const Body& body) {
  fem::Model model = fem::make_model(garment, fabric, body);
  model.contact = {};  // the full reach on replicas too: springs do not come to rest in a thinner one
  model.contact.friction = fabric.friction;
  model.self_contact = {};
  model.triangles.clear();
  model.spring_law.limit = fabric.most_stretch;
  model.springs = edge_springs(garment, fabric);
  model.bend_frictions.assign(model.hinges.size(), {});
  return model;
}

Drape drape_explicitly(const DrapeRequest& request) {
  if (request.start.cols() != request.garment.vertex_count)
    throw std::invalid_argument("mass-spring: start has another number of vertices than the garment");
  if (!request.start.allFinite()) throw std::invalid_argument("mass-spring: start is not finite");
  const auto began = std::chrono::steady_clock::now();
  const Cloth cloth = make_cloth(request.garment, request.fabric, request.body);
  RelaxationOptions options;
  options.tolerance = request.tolerance;
  options.time_limit = request.time_limit;
  options.stop = request.stop;
  if (request.progress)
    options.progress = [&](int step, double residual) { request.progress({step, residual, request.tolerance}); };
  Rest rest = relax(cloth, request.start, options);
  Drape drape;
  drape.positions = std::move(rest.x);
  drape.residual = rest.residual;
  drape.steps = rest.steps;
  drape.settled = rest.settled;
  drape.simulator = "mass-spring-explicit";
  measure_guards(request, drape);
  drape.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return drape;
}

Drape drape(const DrapeRequest& request) {
  fem::NewtonOptions options;
  options.holding = fem::Holding::cone;
  options.springs = {.clamped_above = 0.3, .floor = 0.3e-3};
  return fem::drape_at_equilibrium(request, make_model, options, "mass-spring");
}

}  // namespace toile::mass_spring
