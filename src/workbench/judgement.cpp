#include "workbench/judgement.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "garment/units.h"
#include "geometry/surface_distance.h"
#include "geometry/triangle_shape.h"

namespace toile {
namespace {

constexpr double seam_limit = 3e-3;       // m, a seam that no longer fits
constexpr double far_from_target = 0.01;  // of the body's height
constexpr double noticeable = 0.01;       // distortion of a triangle laid flat
// In the mean, of a target that is missed too. Lengths, grading and fit of draped skirts: .001 to .007; bulges and pinches:
// .010 and more.
constexpr double doubtful_distortion = 0.0085;

// Of the distance that is left: where plain flattening comes nearer than this, it is the rules of cutting that cost.
constexpr double rules_cost = 0.6;

std::string percent(double share, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f %%", digits, 100 * share);
  return text;
}

int panel_of_triangle(const GarmentMesh& garment, Eigen::Index triangle) {
  const std::vector<int> offsets = triangle_offsets(garment);
  return static_cast<int>(std::upper_bound(offsets.begin(), offsets.end(), static_cast<int>(triangle)) - offsets.begin()) - 1;
}

Eigen::Vector3d centre_of(const GarmentMesh& garment, const Eigen::Matrix3Xd& x, Eigen::Index t) {
  return (x.col(garment.triangles(0, t)) + x.col(garment.triangles(1, t)) + x.col(garment.triangles(2, t))) / 3;
}

// The middle of what cannot be laid flat in the panel that has most of it.
std::string least_developable_place(const Judged& judged) {
  const GarmentMesh& garment = judged.target.garment;
  const Eigen::VectorXd distortion = flattening_distortion(judged.target, judged.adjustment.flattened);
  const std::vector<Eigen::Matrix2d> rest = rest_triangles(garment);
  std::vector<double> amount(garment.panels.size(), 0);
  std::vector<Eigen::Vector3d> sum(garment.panels.size(), Eigen::Vector3d::Zero());
  for (Eigen::Index t = 0; t < distortion.size(); ++t) {
    const double share = std::max(0.0, distortion(t) - noticeable) * std::abs(rest[static_cast<std::size_t>(t)].determinant());
    const auto panel = static_cast<std::size_t>(panel_of_triangle(garment, t));
    amount[panel] += share;
    sum[panel] += share * centre_of(garment, judged.target.positions, t);
  }
  const auto worst = static_cast<std::size_t>(std::max_element(amount.begin(), amount.end()) - amount.begin());
  if (!(amount[worst] > 0)) return "target";
  return place_of(garment, static_cast<int>(worst), sum[worst] / amount[worst], judged.form);
}

std::string furthest_place(const Judged& judged) {
  const GarmentMesh& garment = judged.target.garment;
  const Eigen::Matrix3Xd& x = judged.verified.drape.positions;
  const Eigen::VectorXd far = surface_distance({x, garment.triangles}, {judged.target.positions, garment.triangles}).a_vertices;
  Eigen::Index vertex = 0;
  far.maxCoeff(&vertex);
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t)
    if ((garment.triangles.col(t).array() == static_cast<int>(vertex)).any())
      return place_of(garment, panel_of_triangle(garment, t), x.col(vertex), judged.form);
  return "re-drape";
}

}  // namespace

std::string place_of(const GarmentMesh& garment, int panel, const Eigen::Vector3d& at, const Mannequin& form) {
  const Eigen::Vector3d middle = (form.positions.rowwise().maxCoeff() + form.positions.rowwise().minCoeff()) / 2;
  const double x = at.x() - middle.x(), z = at.z() - middle.z();
  const char* side = std::abs(x) > std::abs(z) ? (x > 0 ? "at the wearer's left" : "at the wearer's right")
                                               : (z > 0 ? "at the front" : "at the back");
  return "panel '" + garment.panels[static_cast<std::size_t>(panel)].name + "', " + in_mm(at.y(), 0) + " above the floor, " +
         side;
}

Eigen::VectorXd flattening_distortion(const Target& target, const RestShape& flat) {
  const std::vector<Eigen::Matrix2d> rest = rest_triangles(with_rest(target.garment, flat));
  Eigen::VectorXd distortion(target.garment.triangles.cols());
  for (Eigen::Index t = 0; t < distortion.size(); ++t) {
    const Eigen::Vector3i corner = target.garment.triangles.col(t);
    const Eigen::Matrix2d shape = triangle_shape(Eigen::Vector3d(target.positions.col(corner(0))),
                                                 target.positions.col(corner(1)), target.positions.col(corner(2)));
    const Eigen::Matrix2d& from = rest[static_cast<std::size_t>(t)];
    if (std::abs(from.determinant()) < 1e-14) {
      distortion(t) = 1;
      continue;
    }
    const Eigen::Vector2d sigma = (shape * from.inverse()).jacobiSvd().singularValues();
    distortion(t) = (sigma.array() - 1).abs().mean();
  }
  return distortion;
}

Report judge(const Judged& judged) {
  const AdjustStep& step = judged.verified.step;
  const bool far = step.hausdorff > far_from_target * judged.form.height;
  const bool folds_only = far && only_folds_differ(judged.tailoring);
  const double distortion = judged.adjustment.steps.front().embedding_distortion;
  const std::string how_far = "the pattern drapes up to " + in_mm(step.hausdorff) + " from the target (" +
                              percent(step.hausdorff / judged.form.height, 2) + " of the height)";
  Report report;
  if (judged.adjustment.stop == AdjustStop::not_developable || (far && !folds_only && distortion > doubtful_distortion))
    report.error("adjust.not-developable", least_developable_place(judged),
                 "this shape cannot be cut from flat cloth: laid flat it is distorted by " + percent(distortion, 1) +
                     " in the mean, and " + how_far,
                 "Make the change smaller, spread it over a larger part, or put a seam or dart there; what is written is the "
                 "nearest found",
                 Fault::checks_failed);
  else if (judged.adjustment.stop == AdjustStop::slipped)
    report.error("adjust.slips", furthest_place(judged), "a garment of this shape slips down: " + how_far,
                 "Let the edit leave the part that holds the garment", Fault::checks_failed);
  else if (folds_only)
    report.warn("adjust.other-folds", furthest_place(judged),
                how_far + ", but only the folds fall otherwise: girths, seams and openings measure the same",
                "Look at the pictures; a stiffer fabric or a finer mesh holds its folds better");
  else if (far && judged.adjustment.steps.front().hausdorff < rules_cost * step.hausdorff)
    report.error("adjust.cutting-rules", furthest_place(judged),
                 how_far + "; laid flat without the rules of cutting it comes within " +
                     in_mm(judged.adjustment.steps.front().hausdorff) +
                     ": pieces that are cut alike, straight edges or seams of a given ratio keep it away",
                 "Ask for less, or for the same change all round; or read in as pieces of their own those that have to differ",
                 Fault::checks_failed);
  else if (far)
    report.error("adjust.far-from-target", furthest_place(judged),
                 how_far + ": cloth does not hang in that shape; this is the nearest found",
                 "Look at the map of distances before you cut", Fault::checks_failed);
  if (judged.seam_mismatch > seam_limit)
    report.error("adjust.seam-mismatch", "pattern", "a seam is " + in_mm(judged.seam_mismatch) + " off",
                 "See the table of seams", Fault::checks_failed);
  return report;
}

}  // namespace toile
