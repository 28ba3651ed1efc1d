#pragma once
// A panel between its rest shape and its drape: where a point of the cloth hangs, also of cloth that would be added at an edge.

#include <Eigen/Core>
#include <vector>

#include "garment/mesh.h"

namespace toile {

class PanelChart {
 public:
  // `draped`, `normals`: 3 x panel vertices. All are kept by reference.
  PanelChart(const PanelMesh& panel, const Eigen::Matrix3Xd& draped, const Eigen::Matrix3Xd& normals);

  // The draped place of a point of the rest shape (2, m), between vertices on the curved surface that their normals tell of
  // (Boubekeur and Alexa 2008, "Phong tessellation"); a little outside it, of the nearest triangle carried on.
  Eigen::Vector3d at(const Eigen::Vector2d& rest) const;
  bool contains(const Eigen::Vector2d& rest) const;

 private:
  struct Found {
    int triangle = -1;
    double inside = 0;  // least barycentric coordinate, negative outside
    Eigen::Vector3d weights;
  };
  Found find(const Eigen::Vector2d& rest) const;
  // Whether the triangle is nearer to holding `rest` than `best`, which it then becomes.
  bool takes(int triangle, const Eigen::Vector2d& rest, Found& best) const;
  // Of the grid; -1 outside it.
  int cell(const Eigen::Vector2d& rest) const;

  const PanelMesh& panel_;
  const Eigen::Matrix3Xd& draped_;
  const Eigen::Matrix3Xd& normals_;
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();  // m, of the grid over the rest shape
  double width_ = 1;                                  // m, of its cells
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<int>> touching_;  // by cell: triangles, ascending
};

// An edge of a panel beyond which its cloth is carried on: straight, as the cloth behind the edge hangs in the mean over
// `behind` metres, evened out along the edge, and neither stretched nor compressed.
class CarriedOn {
 public:
  // `edge`: vertices in order; `direction`: a column for each, the way the cloth goes on in the rest shape, of any length.
  CarriedOn(const PanelMesh& panel, const PanelChart& chart, std::vector<int> edge, Eigen::Matrix2Xd direction, double behind);

  Eigen::Vector3d at(const Eigen::Vector2d& rest) const;
  double distance(const Eigen::Vector2d& rest) const { return (rest - point(nearest(rest))).norm(); }  // m, from the edge

 private:
  // A point of the edge: between its vertices `first` and `first + 1`.
  struct Place {
    std::size_t first = 0;
    double share = 0;
  };
  Eigen::Vector2d point(const Place& place) const;
  Eigen::Vector2d direction(const Place& place) const;  // unit
  Place nearest(const Eigen::Vector2d& rest) const;

  const PanelMesh& panel_;
  const PanelChart& chart_;
  std::vector<int> edge_;
  Eigen::Matrix2Xd direction_;
  Eigen::Matrix3Xd goes_on_;  // by vertex of the edge, where the cloth goes on as it hangs; unit
};

}  // namespace toile
