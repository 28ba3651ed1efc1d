#pragma once
// A whole pattern as a function of the unknowns of the fit.

#include <utility>
#include <vector>

#include "draft/outline_fit.h"
#include "draft/shape_model.h"

namespace toile {

// Points come in the frames of the shapes. Refers to the pattern and likeness it was made from.
class PatternModel {
 public:
  PatternModel(const Pattern& original, const Likeness& likeness, const std::vector<PanelOutline>& panels, double tolerance);

  ModelPoint on_edge(int piece, int edge, double at) const;
  std::vector<ModelPoint> edge_points(int piece, int edge) const;
  bool is_straight_edge(int piece, int edge) const { return part(piece, edge, 0).first->straight; }
  const Lay& lay(int piece) const { return likeness_.lays[static_cast<std::size_t>(piece)]; }
  void set_points_for(double chord_tolerance);

  Eigen::VectorXd unknowns;
  std::vector<ShapeModel> models;
  std::vector<std::vector<std::vector<double>>> fractions;  // [piece][edge]: of its points

 private:
  std::pair<const Run*, std::pair<int, const Run::Part*>> part(int piece, int edge, double at) const;
  Coordinate turn(int piece, int run, std::size_t index);
  void add_turns(std::vector<double>& values);

  const Pattern& original_;
  const Likeness& likeness_;
  std::vector<Sides> sides_;
  std::vector<std::vector<std::vector<Coordinate>>> turns_;  // [piece][run]: ends of its parts, in the shape's direction
};

}  // namespace toile
