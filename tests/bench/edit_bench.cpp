// How long a new target takes after a handle has moved: what an editor has to keep up with (100 ms at 10,000 triangles).

#include <benchmark/benchmark.h>

#include <filesystem>
#include <map>

#include "body/parametric.h"
#include "formats/formats.h"
#include "workbench/workbench.h"

namespace toile {
namespace {

struct Editing {
  Scene scene;
  Worn worn;
};

// A sample worn by a women's 38, about 10,000 triangles.
const Editing& editing(const std::string& sample, double edge_length) {
  static std::map<std::string, Editing> made;
  if (const auto known = made.find(sample); known != made.end()) return known->second;
  const std::filesystem::path root = TOILE_SOURCE_DIR;
  Editing e{{make_body(build_mannequin(value_or_throw(read_size_chart_row(root / "templates/mannequins/women.csv", "38")))),
             value_or_throw(read_fabric(root / "templates/fabrics/jersey.toml")), find_simulator("fem")},
            {}};
  const Pattern pattern = value_or_throw(read_pattern(root / "samples" / sample / (sample + ".dxf")));
  e.worn = wear(pattern, e.scene, edge_length, 1e-3);
  return made[sample] = std::move(e);
}

void new_target(benchmark::State& state, const char* sample, double edge_length, const Edit& request) {
  const Editing& e = editing(sample, edge_length);
  double deviation = 0;
  for ([[maybe_unused]] const auto _ : state) deviation = edit(e.worn, e.scene, {request}).normal_deviation_mean;
  state.counters["triangles"] = triangle_count(e.worn.garment);
  state.counters["deviation"] = deviation;
}

const Edit hem_shorter{"length", {{"loop", "hem"}, {"by", "-10 cm"}}, "bench"};
const Edit hem_longer{"length", {{"loop", "hem"}, {"by", "8 cm"}}, "bench"};
const Edit hip_wider{"fit", {{"loop", "hip"}, {"by", "1 cm"}}, "bench"};
const Edit sleeves_shorter{"length", {{"loop", "SLEEVE.hem"}, {"by", "-3 cm"}}, "bench"};
const Edit closer{"fit", {{"loop", "all"}, {"girth", "-3 cm"}}, "bench"};

void as_an_editor_sees_it(benchmark::internal::Benchmark* bench) { bench->UseRealTime()->Unit(benchmark::kMillisecond); }

BENCHMARK_CAPTURE(new_target, hem_shorter, "gored_skirt", 13e-3, hem_shorter)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(new_target, hem_longer, "gored_skirt", 13e-3, hem_longer)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(new_target, hip_wider, "gored_skirt", 13e-3, hip_wider)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(new_target, sleeves_shorter, "t_shirt", 13e-3, sleeves_shorter)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(new_target, closer, "t_shirt", 13e-3, closer)->Apply(as_an_editor_sees_it);

}  // namespace
}  // namespace toile

BENCHMARK_MAIN();
