#pragma once
// The simulator "fem" (entry of simulators.cpp).

#include "drape/simulator.h"

namespace toile::fem {

Drape drape(const DrapeRequest& request);
Drape drape_projected(const DrapeRequest& request);

}  // namespace toile::fem
