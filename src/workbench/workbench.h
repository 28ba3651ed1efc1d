#pragma once
// The stages composed, each with its named result. No algorithm here.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adjust/adjust.h"
#include "body/body.h"
#include "draft/redraw.h"
#include "drape/dress.h"
#include "drape/openings.h"
#include "drape/simulator.h"
#include "garment/fabric.h"
#include "garment/pattern.h"
#include "garment/pattern_file.h"
#include "garment/target.h"
#include "workbench/recipe.h"

namespace toile {

// What a garment is draped with.
struct Scene {
  Body body;
  Fabric fabric;
  Simulator simulator;
  double hem = 30e-3;             // m, turned up at hems whose edges have no allowance of their own
  FindBody find_body = {};        // for edits that name another body
  FindGarment find_garment = {};  // and another garment
};

using DrapeSteps = std::function<void(const DrapeProgress&)>;

// How a drape is watched and cut short.
struct DrapeControl {
  DrapeSteps progress = {};
  std::optional<double> time_limit = {};  // s, of each drape; then the best state so far, not settled
  std::function<bool()> stop = {};        // asked between steps; once true, likewise
  std::function<void(int step, int steps)> dressing = {};
  // Called when dressing did not come together, before what there is of it is settled.
  std::function<void(const GarmentMesh&, const Stuck&)> stuck = {};
};

// A pattern sewn and hanging on the body.
struct Worn {
  Pattern pattern;  // as given; where it marked no hem, the edges of the lowest opening are marked
  GarmentMesh garment;
  Drape drape;
  double seam_gap = 0;   // m, widest seam just before it was welded
  bool links_ok = true;  // every opening holds a limb that may go through it
  std::vector<Opening> openings;
  Report report;  // errors of the guards: "drape.not-settled", "drape.penetrates", ...; warnings
};

// Triangulates, sews, dresses and settles. Throws BadInput when the pattern cannot be meshed or placed.
Worn wear(const Pattern& pattern, const Scene& scene, double edge_length, double tolerance, const DrapeControl& control = {});

// The same from an earlier drape of the same pattern and edge length (3 x garment vertices) instead of dressing. Throws
// BadInput("drape.other-garment") when it has another number of vertices.
Worn wear_from(const Pattern& pattern, const Scene& scene, double edge_length, double tolerance, const Eigen::Matrix3Xd& start,
               const DrapeControl& control = {});

// The same from the drape that the pattern came with (garment/pattern_file.h), on other triangles of the same pieces.
Worn wear_draped(const Pattern& pattern, const DrapedGarment& draped, const Scene& scene, double edge_length, double tolerance,
                 const DrapeControl& control = {});

// As edits know it: for Scene::find_garment.
WornGarment as_worn(Worn worn, double edge_length);

// Every edit of the recipe in turn, on the drape; after a grading on the target's body, which the scene has to have for what
// follows. Throws BadInput with the recipe's place.
Target edit(const Worn& worn, const Scene& scene, const std::vector<Edit>& edits);

// The pattern of target.garment.
const Pattern& edited_pattern(const Worn& worn, const Target& target);

// Phi with everything but the rest shape and the start fixed: hems of `pattern` turned up, then the scene's simulator. Keeps
// references to pattern and scene.
Simulate phi(const Pattern& pattern, const Scene& scene, const DrapeControl& control = {});

// Pattern adjustment whose every iterate can be cut.
Adjustment adjust_pattern(const Pattern& pattern, const Target& target, const Scene& scene, const AdjustOptions& options,
                          const DrapeControl& control = {});

// The redrawn pattern draped anew from the target: the figure that counts.
struct Verified {
  RestShape rest;
  Drape drape;
  AdjustStep step;
  Report report;
};
Verified verify(const Pattern& pattern, const Target& target, const RestShape& like, const Scene& scene, double tolerance,
                const DrapeControl& control = {});

// Findings about a drape that a pattern maker must not overlook; `what` names it ("source drape").
Report drape_findings(const Drape& drape, double tolerance, const std::string& what);

}  // namespace toile
