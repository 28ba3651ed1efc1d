#pragma once
// The pictures of a run, as a pattern maker looks at them: front, side and back; distances in mm with their scale; outlines
// before and after. All about 1200 pixels wide.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "garment/mannequin.h"
#include "garment/mesh.h"
#include "picture/colour_map.h"
#include "picture/image.h"

namespace toile {

// What every picture of a run shows alike.
struct Showing {
  const Mannequin& body;
  const GarmentMesh& garment;
  Eigen::Matrix3Xd frame;  // points that must be in the picture, such as the source drape; none: the drape that is shown
  int samples = 3;         // per pixel side, for smooth edges
};

// The drape in front, side and back view with its seam lines.
Image drape_picture(const Showing& showing, const Eigen::Matrix3Xd& positions, const std::string& title);

// A drape coloured by a distance per garment vertex, m.
struct DistanceMap {
  const Eigen::Matrix3Xd& positions;
  const Eigen::VectorXd& distance;
  std::string title;
};

// Front, side and back with a scale of colours from 0 to `top` (m).
Image distance_picture(const Showing& showing, const DistanceMap& map, double top);
// Two drapes beside each other, front and back, on one scale.
Image compared_picture(const Showing& showing, const DistanceMap& left, const DistanceMap& right, double top);
// A round top for the scale of these distances, m: at least 1 mm, covering 98 % of them.
double scale_top(const std::vector<Eigen::VectorXd>& distances);

// Closed outlines of one piece at three stages, m, already laid over each other; an empty one is not drawn.
struct PanelOutlines {
  std::string name;
  std::vector<Eigen::Vector2d> original, flattened, adjusted;
};

// One entry per piece (its first copy), laid over each other by turning the boundary vertices as well as they go and matching
// one end of the original, or all of it: whichever leaves the most on the original.
std::vector<PanelOutlines> panel_outlines(const GarmentMesh& garment, const RestShape& flattened, const RestShape& adjusted);

// Original green, plain flattening red, adjusted blue, as the paper's Fig. 2f, all panels at one scale with a bar of 10 cm; at
// most `width` pixels wide.
Image panels_overlay(const std::vector<PanelOutlines>& panels, const std::string& title, int width = 1200);

}  // namespace toile
