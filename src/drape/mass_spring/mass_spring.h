#pragma once
// The simulator "mass-spring" (entry of simulators.cpp).

#include "drape/simulator.h"

namespace toile::mass_spring {

Drape drape(const DrapeRequest& request);
Drape drape_explicitly(const DrapeRequest& request);

}  // namespace toile::mass_spring
