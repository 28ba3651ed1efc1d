#pragma once
// What a size chart row says of a body, completed: heights of the levels, girths to reach, and the shapes of the sections.
// Every figure comes from four bodies measured on the CC0 MakeHuman base mesh fitted to chart girths (women 34, 38, 48, men
// 50).

#include <map>
#include <string>

#include "body/parametric_loft.h"
#include "garment/mannequin.h"

namespace toile {

// All in metres. Level and girth names are those of Mannequin::landmarks and Mannequin::measures.
struct Figure {
  bool female = true;
  double height = 0;
  std::map<std::string, double> levels;     // height above the floor
  std::map<std::string, double> girths;     // to be reached; the chart's own where it has them
  std::map<std::string, Section> sections;  // trunk (centre_u 0), with the girth above; limbs in their own plane, centred
  Eigen::Vector3d shoulder, elbow, wrist, fingertip;  // wearer's left
  Eigen::Vector3d hip_joint, knee, ankle, toe;
  Eigen::Vector3d neck_base, head_joint;
  double bust_point_distance = 0;               // between the two bust points
  double shoulder_factor = 1, neck_factor = 1;  // widths against women 38 of equal stature
  double chest_front = 0, chest_back = 0;       // how far the chest at the armpits lies before that of women 38, m
};

// Throws BadInput ("chart.implausible") when the row is no body: girths not ordered or far outside human proportions.
Figure complete_figure(const SizeChartRow& row);

}  // namespace toile
