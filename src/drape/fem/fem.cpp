#include "drape/fem/fem.h"

#include <chrono>
#include <stdexcept>

#include "drape/fem/newton.h"
#include "drape/guards.h"

namespace toile::fem {
namespace {

Drape run(const DrapeRequest& request, Curvature curvature, const char* name) {
  if (request.start.cols() != request.garment.vertex_count)
    throw std::invalid_argument("fem: start has another number of vertices than the garment");
  if (!request.start.allFinite()) throw std::invalid_argument("fem: start is not finite");
  const auto began = std::chrono::steady_clock::now();
  const Model model = make_model(request.garment, request.fabric, request.body);
  NewtonOptions options;
  options.tolerance = request.tolerance;
  options.curvature = curvature;
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

}  // namespace

Drape drape(const DrapeRequest& request) { return run(request, Curvature::full, "fem"); }

Drape drape_projected(const DrapeRequest& request) { return run(request, Curvature::clamped, "fem-projected"); }

}  // namespace toile::fem
