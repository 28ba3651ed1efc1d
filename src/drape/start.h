#pragma once
// From where the pattern puts its panels to where sewing can begin: arms inside their sleeves, nothing touching the body or
// other panels, as few stitches as possible drawn through the body.

#include <Eigen/Core>
#include <vector>

#include "body/body.h"
#include "drape/sewing.h"
#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

struct Start {
  std::vector<Eigen::Matrix3Xd> placed;  // by panel
  std::vector<int> layer;                // by panel (layers.h)
  std::vector<double> lift;              // m, by panel, by which those of the trunk were raised
  double narrowed = 1;                   // share of their width beside the trunk that its panels have, so that wide ones are
                                         // sewn between the arms; they unfold while they are sewn
  bool widened = false;                  // panels of outer layers start wider than they are cut
  bool gathered = false;                 // legs of trousers start above the feet; they come down while they are sewn
  int blocked_stitches = 0;              // whose straight line goes through the body
  int intersections = 0;                 // pairs of triangles
};

// `higher`: m, added to the lift that is found: for another attempt when sewing got stuck.
Start start_positions(const Pattern& pattern, const GarmentMesh& garment, const Body& body, double higher = 0);

}  // namespace toile
