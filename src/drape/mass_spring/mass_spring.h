#pragma once
// The simulators "mass-spring" and "mass-spring-explicit" (entries of simulators.cpp): the same springs and hinges, brought to
// rest by Newton's method as fem is (drape/fem/newton.h, which adds contact of the cloth with itself and friction held from the
// start), or moved there in small explicit steps (relaxation.h).

#include "drape/fem/model.h"
#include "drape/simulator.h"

namespace toile::mass_spring {

// Springs in the place of the membrane, and bends without friction: the energy of cloth.h.
fem::Model make_model(const GarmentMesh& garment, const Fabric& fabric, const Body& body);

Drape drape(const DrapeRequest& request);
Drape drape_explicitly(const DrapeRequest& request);

}  // namespace toile::mass_spring
