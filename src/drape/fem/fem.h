#pragma once
// The simulator "fem" (entry of simulators.cpp).

#include "drape/fem/newton.h"
#include "drape/simulator.h"

namespace toile::fem {

// What is asked, answered with `make_model(garment, fabric, body)` of any elasticity. `options` without what the request says.
Drape drape_at_equilibrium(const DrapeRequest& request, Model (*make)(const GarmentMesh&, const Fabric&, const Body&),
                           NewtonOptions options, const char* name);

Drape drape(const DrapeRequest& request);
Drape drape_projected(const DrapeRequest& request);

}  // namespace toile::fem
