#include "drape/fem/fem.h"

#include <chrono>
#include <stdexcept>

#include "drape/fem/newton.h"
#include "drape/guards.h"

namespace toile::fem {

Drape drape_at_equilibrium(const DrapeRequest& request, Model (*make)(const GarmentMesh&, const Fabric&, const Body&),
                           NewtonOptions options, const char* name) {
  if (request.start.cols() != request.garment.vertex_count)
    throw std::invalid_argument(std::string(name) + ": start has another number of vertices than the garment");
  if (!request.start.allFinite()) throw std::invalid_argument(std::string(name) + ": start is not finite");
  const auto began = std::chrono::steady_clock::now();
  const Model model = make(request.garment, request.fabric, request.body);
  options.tolerance = request.tolerance;
  options.time_limit = request.time_limit;
  options.stop = request.stop;
  if (request.progress)
    options.progress = [&](int step, double residual) { request.progress({step, residual, request.tolerance}); };
  Equilibrium found = find_equilibrium(model, request.start, options);
  Drape drape;
  drape.positions = std::move(found.x);
  drape.residual = found.residual;
  drape.steps = found.steps;
  drape.settled = found.settled;
  drape.simulator = name;
  measure_guards(request, drape);
  drape.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return drape;
}

Drape drape(const DrapeRequest& request) { return drape_at_equilibrium(request, make_model, {}, "fem"); }

Drape drape_projected(const DrapeRequest& request) {
  return drape_at_equilibrium(request, make_model, {.curvature = Curvature::clamped}, "fem-projected");
}

}  // namespace toile::fem
