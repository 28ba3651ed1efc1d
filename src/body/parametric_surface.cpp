#include "body/parametric_surface.h"

#include <algorithm>

namespace toile {
namespace {

struct Neighbour {
  int vertex;
  double weight;
};

std::vector<bool> on_midplane(const Net& net) {
  std::vector<bool> middle;
  for (const Eigen::Vector3d& p : net.points) middle.push_back(p.x() == 0);
  return middle;
}

// By vertex; edges inside the half body count twice at a vertex of the midplane, once for each half.
std::vector<std::vector<Neighbour>> neighbours(const Net& net, const std::vector<bool>& middle) {
  std::vector<std::vector<Neighbour>> result(net.points.size());
  for (const auto& triangle : net.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      for (const int other : {triangle[(k + 1) % 3], triangle[(k + 2) % 3]}) {
        auto& own = result[static_cast<std::size_t>(triangle[k])];
        if (std::any_of(own.begin(), own.end(), [&](const Neighbour& n) { return n.vertex == other; })) continue;
        const bool both_middle = middle[static_cast<std::size_t>(triangle[k])] && middle[static_cast<std::size_t>(other)];
        own.push_back({other, both_middle ? .5 : 1.0});
      }
  return result;
}

}  // namespace

void even_out(Net& net, const BodyForm& form, int rounds) {
  const std::vector<bool> middle = on_midplane(net);
  const auto around = neighbours(net, middle);
  Chain next = net.points;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < net.points.size(); ++i) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      double weight = 0;
      for (const Neighbour& n : around[i]) {
        sum += n.weight * net.points[static_cast<std::size_t>(n.vertex)];
        weight += n.weight;
      }
      const Eigen::Vector3d& here = net.points[i];
      const FormSample at = form.sample(here);
      const double squared = std::max(at.gradient.squaredNorm(), 1e-3);
      Eigen::Vector3d move = .5 * (sum / weight - here);
      if (middle[i]) move.x() = 0;
      move -= move.dot(at.gradient) / squared * at.gradient;
      next[i] = here + move - std::clamp(at.distance / squared, -.02, .02) * at.gradient;
      if (middle[i]) next[i].x() = 0;
    }
    std::swap(net.points, next);
  }
  for (std::size_t i = 0; i < net.points.size(); ++i) {
    net.points[i] = form.projected(net.points[i], 3);
    if (middle[i]) net.points[i].x() = 0;
  }
}

Surface mirrored_surface(const Net& net) {
  const std::vector<bool> middle = on_midplane(net);
  std::vector<int> mirror(net.points.size());
  int count = static_cast<int>(net.points.size());
  for (std::size_t i = 0; i < mirror.size(); ++i) mirror[i] = middle[i] ? static_cast<int>(i) : count++;
  Surface surface{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xi(3, 2 * static_cast<Eigen::Index>(net.triangles.size()))};
  for (std::size_t i = 0; i < mirror.size(); ++i) {
    const Eigen::Vector3d& p = net.points[i];
    surface.positions.col(static_cast<Eigen::Index>(i)) = p;
    if (!middle[i]) surface.positions.col(mirror[i]) << -p.x(), p.y(), p.z();
  }
  Eigen::Index t = 0;
  for (const auto& [a, b, c] : net.triangles) {
    const auto other = [&](int v) { return mirror[static_cast<std::size_t>(v)]; };
    surface.triangles.col(t++) << a, b, c;
    surface.triangles.col(t++) << other(a), other(c), other(b);
  }
  return surface;
}

}  // namespace toile
