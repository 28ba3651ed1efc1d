#pragma once
// Triangle meshes as a picture, without a display: z-buffer, several samples per pixel, soft light from two sides.

#include <Eigen/Core>
#include <vector>

#include "picture/image.h"

namespace toile {

struct ShownMesh {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi triangles;
  std::vector<Colour> colours;  // one for all, or one per triangle, or one per vertex (told apart by number, in this order)
  double inside = 0.55;         // brightness of the triangles' back, where they are seen from there
};

struct ShownLine {
  std::vector<Eigen::Vector3d> points;
  Colour colour;
  double width = 1.5;  // pixels
};

struct Scene3D {
  std::vector<ShownMesh> meshes;
  std::vector<ShownLine> lines;  // lifted a little towards the viewer, so that lines on a surface are seen
  Colour background{1, 1, 1};
};

struct View {
  Eigen::Vector3d towards_viewer = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  double angle = 0.35;  // radians, height of the picture as seen; 0: orthographic
  int width = 600, height = 800;
  double margin = 0.05;    // of the picture's size, left free round the frame
  Eigen::Matrix3Xd frame;  // points that must be in the picture; none: everything shown
  int samples = 3;         // per pixel side
};

// Parts nearer to the viewer than the camera are left out. Throws std::invalid_argument for positions that are not finite,
// triangles naming unknown vertices, a wrong number of colours, or a view along `up`.
Image render(const Scene3D& scene, const View& view);

}  // namespace toile
