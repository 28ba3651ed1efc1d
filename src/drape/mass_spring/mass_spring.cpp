#include "drape/mass_spring/mass_spring.h"

#include <chrono>
#include <stdexcept>

#include "drape/guards.h"
#include "drape/mass_spring/relaxation.h"

namespace toile::mass_spring {

Drape drape(const DrapeRequest& request) {
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
  drape.simulator = "mass-spring";
  measure_guards(request, drape);
  drape.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return drape;
}

}  // namespace toile::mass_spring
