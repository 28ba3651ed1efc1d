// How long a re-drape takes: Phi as the adjustment calls it first, the flattened target started at the target, of the sample
// skirt shortened by 10 cm. Counters say what it did for its time.

#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include "body/parametric.h"
#include "formats/formats.h"
#include "triangulate/triangulate.h"
#include "workbench/workbench.h"

namespace toile {
namespace {

constexpr double first_edge_length = 20e-3;  // m, of the mesh that is dressed; finer ones start from its drape
constexpr double tolerance = 1e-3;

struct Sample {
  Pattern pattern;
  Scene scene;
  Worn worn;
};

const Sample& sample() {
  static const Sample made = [] {
    const std::filesystem::path root = TOILE_SOURCE_DIR;
    Sample s{value_or_throw(read_pattern(root / "samples/gored_skirt/gored_skirt.dxf")),
             {make_body(build_mannequin(value_or_throw(read_size_chart_row(root / "templates/mannequins/women.csv", "38")))),
              value_or_throw(read_fabric(root / "templates/fabrics/jersey.toml")), find_simulator("fem")},
             {}};
    s.worn = wear(s.pattern, s.scene, first_edge_length, tolerance);
    return s;
  }();
  return made;
}

// Barycentric coordinates of `p` in the triangle nearest to it, and that triangle.
std::pair<int, Eigen::Vector3d> locate(const PanelMesh& panel, const Eigen::Vector2d& p) {
  std::pair<int, Eigen::Vector3d> best;
  double least = -std::numeric_limits<double>::infinity();
  for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
    Eigen::Matrix3d corners = Eigen::Matrix3d::Ones();
    for (int k = 0; k < 3; ++k) corners.col(k).head<2>() = panel.rest.col(panel.triangles(k, t));
    const Eigen::Vector3d at = corners.inverse() * p.homogeneous();
    if (at.minCoeff() > least) least = at.minCoeff(), best = {static_cast<int>(t), at};
  }
  return best;
}

// The drape of one mesh of the pattern carried over to another.
Eigen::Matrix3Xd carried(const Worn& from, const GarmentMesh& to) {
  Eigen::Matrix3Xd positions = Eigen::Matrix3Xd::Zero(3, to.vertex_count);
  for (std::size_t p = 0; p < to.panels.size(); ++p) {
    const PanelMesh& coarse = from.garment.panels[p];
    for (Eigen::Index v = 0; v < to.panels[p].rest.cols(); ++v) {
      const auto [t, weight] = locate(coarse, to.panels[p].rest.col(v));
      Eigen::Vector3d at = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k) at += weight(k) * from.drape.positions.col(from.garment.welded[p](coarse.triangles(k, t)));
      positions.col(to.welded[p](v)) = at;
    }
  }
  return positions;
}

struct Call {
  Pattern pattern;
  GarmentMesh garment;
  Eigen::Matrix3Xd start;
};

// The first call of Phi that the adjustment makes at about `triangles`.
const Call& first_call(int triangles) {
  static std::map<int, Call> calls;
  if (const auto known = calls.find(triangles); known != calls.end()) return known->second;
  const Sample& s = sample();
  const double edge_length = first_edge_length * std::sqrt(triangle_count(s.worn.garment) / static_cast<double>(triangles));
  const GarmentMesh garment = sew(s.pattern, triangulate(s.pattern, {.edge_length = edge_length}));
  const Worn worn = wear_from(s.pattern, s.scene, edge_length, tolerance, carried(s.worn, garment));
  const Target target = edit(worn, s.scene, {{"length", {{"loop", "hem"}, {"by", "-10 cm"}}, "bench"}});
  Call call{worn.pattern, {}, {}};
  struct Seen {};
  try {
    adjust(target,
           [&](const GarmentMesh& cloth, const Eigen::Matrix3Xd& start, double) -> Drape {
             call.garment = cloth;
             call.start = start;
             throw Seen{};
           },
           {}, {});
  } catch (const Seen&) {
  }
  return calls[triangles] = call;
}

void redrape(benchmark::State& state, const char* simulator) {
  const Call& call = first_call(static_cast<int>(state.range(0)));
  Scene scene = sample().scene;
  scene.simulator = find_simulator(simulator);
  Drape drape;
  for ([[maybe_unused]] const auto _ : state) drape = phi(call.pattern, scene)(call.garment, call.start, tolerance);
  state.counters["triangles"] = triangle_count(call.garment);
  state.counters["steps"] = drape.steps;
  state.counters["residual"] = drape.residual;
  state.counters["settled"] = drape.settled;
  state.counters["us_per_triangle"] = 1e6 * drape.seconds / triangle_count(call.garment);
}

BENCHMARK_CAPTURE(redrape, fem, "fem")
    ->Arg(10000)
    ->Arg(25000)
    ->Arg(65000)
    ->Iterations(1)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(redrape, mass_spring, "mass-spring")
    ->Arg(10000)
    ->Iterations(1)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace toile

BENCHMARK_MAIN();
