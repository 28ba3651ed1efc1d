#pragma once
// The first drape: flat panels placed around the body and sewn by shrinking stitches, ready to be settled by a simulator.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "body/body.h"
#include "drape/openings.h"
#include "garment/mesh.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

struct DressOptions {
  int shrinking_steps = 150;  // over which every stitch shortens to nothing
  int holding_steps = 60;     // with the stitches closed; as many again and more while one is still closing
  int sweeps = 10;            // of the constraints per step
  double body_offset = 1e-3;  // m, kept from the body: more would add to the wearer's girth
  double closed_gap = 2e-3;   // m; a wider seam did not come together
  std::function<void(int step, int steps)> progress = {};
};

// What did not come together, to be looked at.
struct Stuck {
  std::vector<Eigen::Matrix3Xd> panels;  // m, by panel, as sewing left them, before their seams were welded
  std::vector<int> where;  // garment vertices, sorted: open stitches, cloth in cloth, cloth in the body, round wrong openings
  std::vector<Finding> errors;
};

struct Dressed {
  Eigen::Matrix3Xd positions;  // by garment vertex, seams welded
  double seam_gap = 0;         // m, widest seam just before it was welded; 0 where it was mended (untangle.h)
  Report report;               // errors: "drape.seam-open" naming the seam, "drape.not-around-body", "drape.linked-wrong",
                               // "drape.self-intersects" and "drape.through-body" naming the panels
  int self_intersections = 0;  // pairs of triangles that pass through each other, seams welded
  bool links_ok = true;        // every opening holds a limb that may go through it
  std::vector<Opening> openings;
  std::vector<std::string> open_seams;  // by name
  std::optional<Stuck> stuck;           // when the report has an error
};

// Position-based sewing (Mueller et al. 2007) without weight or friction, with the body and the cloth itself in the way.
// Deterministic.
Dressed dress(const Pattern& pattern, const GarmentMesh& garment, const Body& body, const DressOptions& options = {});

}  // namespace toile
