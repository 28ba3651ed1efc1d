#include "edit/contact_region.h"

#include <Eigen/Dense>
#include <algorithm>

namespace toile {

ContactRegion contact_region(const EditInput& input) {
  const auto count = static_cast<std::size_t>(input.drape.cols());
  ContactRegion region{Eigen::VectorXd(input.drape.cols()), std::vector<bool>(count), std::vector<bool>(count)};
  const double near = 0.006 * input.body.form.height;
  bool any = false;
  for (std::size_t v = 0; v < count; ++v) {
    const DistanceSample sample = input.body.distance.sample(input.drape.col(static_cast<Eigen::Index>(v)));
    region.gap(static_cast<Eigen::Index>(v)) = sample.distance;
    region.tight[v] = sample.distance < near;
    region.bearing[v] = region.tight[v] && sample.gradient.y() > 0.05 * sample.gradient.norm();
    any = any || region.bearing[v];
  }
  if (!any) region.bearing = region.tight;
  return region;
}

double tight_share(const ContactRegion& region, const Eigen::Matrix3Xd& positions, const VertexLoop& loop) {
  double tight = 0, all = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int a = loop[i], b = loop[(i + 1) % loop.size()];
    const double half = (positions.col(a) - positions.col(b)).norm() / 2;
    all += 2 * half;
    for (const int v : {a, b}) tight += region.tight[static_cast<std::size_t>(v)] ? half : 0;
  }
  return all > 0 ? tight / all : 0;
}

}  // namespace toile
