#pragma once
// How hard a garment presses on the body.

#include <Eigen/Core>

#include "body/body.h"
#include "garment/fabric.h"
#include "garment/mesh.h"

namespace toile {

// m, how close to the body cloth counts as lying on it: wider than the contact of any simulator, since cloth that hangs free in
// that gap presses with nothing anyway.
constexpr double touching = 2.5e-3;

// Pa by garment vertex, >= 0: the push along the body's normal that keeps stretched, bent and heavy cloth where it is, over the
// area it is spread on. From the balance of forces and not from a contact law, so it holds for the drape of any simulator that
// had this fabric; for a taut tube it is Laplace's tension / radius. Evened out over the triangles round each vertex, as a
// sensor of about a square centimetre does. 0 where the cloth does not touch. Where cloth lies in layers, each gives its own
// part.
Eigen::VectorXd body_pressure(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Body& body,
                              const Fabric& fabric);

}  // namespace toile
