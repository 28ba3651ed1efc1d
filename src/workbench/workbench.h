#pragma once
// The stages composed, each with its named result. No algorithm here.

#include <functional>
#include <string>

#include "adjust/adjust.h"
#include "body/body.h"
#include "draft/redraw.h"
#include "drape/simulator.h"
#include "garment/fabric.h"
#include "garment/pattern.h"
#include "garment/target.h"
#include "workbench/recipe.h"

namespace toile {

// What a garment is draped with.
struct Scene {
  Body body;
  Fabric fabric;
  Simulator simulator;
  double hem = 30e-3;  // m, turned up at hems whose edges have no allowance of their own
};

using DrapeSteps = std::function<void(const DrapeProgress&)>;

// A pattern sewn and hanging on the body.
struct Worn {
  Pattern pattern;  // as given; where it marked no hem, the edges of the lowest opening are marked
  GarmentMesh garment;
  Drape drape;
  double seam_gap = 0;  // m, widest seam just before it was welded
  Report report;        // errors of the guards: "drape.not-settled", "drape.penetrates", ...; warnings
};

// Triangulates, sews, dresses and settles. Throws BadInput when the pattern cannot be meshed or placed.
Worn wear(const Pattern& pattern, const Scene& scene, double edge_length, double tolerance, const DrapeSteps& progress = {});

// Every edit of the recipe in turn, on the drape. Throws BadInput with the recipe's place.
Target edit(const Worn& worn, const Scene& scene, const std::vector<Edit>& edits);

// Phi with everything but the rest shape and the start fixed: hems of `pattern` turned up, then the scene's simulator. Keeps
// references to pattern and scene.
Simulate phi(const Pattern& pattern, const Scene& scene, const DrapeSteps& progress = {});

// Pattern adjustment whose every iterate can be cut.
Adjustment adjust_pattern(const Pattern& pattern, const Target& target, const Scene& scene, const AdjustOptions& options,
                          const DrapeSteps& progress = {});

// The redrawn pattern draped anew from the target: the figure that counts.
struct Verified {
  RestShape rest;
  Drape drape;
  AdjustStep step;
  Report report;
};
Verified verify(const Pattern& pattern, const Target& target, const RestShape& like, const Scene& scene, double tolerance,
                const DrapeSteps& progress = {});

// Findings about a drape that a pattern maker must not overlook; `what` names it ("source drape").
Report drape_findings(const Drape& drape, double tolerance, const std::string& what);

}  // namespace toile
