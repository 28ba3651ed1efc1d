#include "workbench/coarse_start.h"

#include <stdexcept>

#include "edit/length/panel_chart.h"

namespace toile {

Eigen::Matrix3Xd carried_over(const GarmentMesh& coarse, const Eigen::Matrix3Xd& drape, const GarmentMesh& fine) {
  if (coarse.panels.size() != fine.panels.size())
    throw std::invalid_argument("carried_over: the meshes have different numbers of panels");
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, fine.vertex_count);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(fine.vertex_count);
  for (std::size_t p = 0; p < fine.panels.size(); ++p) {
    const PanelMesh& panel = coarse.panels[p];
    Eigen::Matrix3Xd hung(3, panel.rest.cols());
    for (Eigen::Index v = 0; v < hung.cols(); ++v) hung.col(v) = drape.col(coarse.welded[p](v));
    const PanelChart chart(panel, hung);
    for (Eigen::Index v = 0; v < fine.panels[p].rest.cols(); ++v) {
      sum.col(fine.welded[p](v)) += chart.at(fine.panels[p].rest.col(v));
      shares(fine.welded[p](v)) += 1;
    }
  }
  return sum.array().rowwise() / shares.transpose().array().max(1);
}

}  // namespace toile
