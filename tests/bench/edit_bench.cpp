// How long the first target of an edit takes, and the next ones while its handle is dragged: what an editor has to keep up with
// (100 ms at 10,000 triangles).

#include <benchmark/benchmark.h>

#include <filesystem>
#include <map>

#include "body/parametric.h"
#include "edit/edit_session.h"
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

struct Dragged {
  const char* sample;
  const char* operation;
  EditArguments arguments;
  EditArguments to[2];  // handle positions in turn
};

EditInput input_of(const Editing& e) { return {e.worn.pattern, e.worn.garment, e.worn.drape.positions, e.scene.body}; }

void count(benchmark::State& state, const Editing& e, const Target& target) {
  state.counters["triangles"] = triangle_count(e.worn.garment);
  state.counters["deviation"] = target.normal_deviation_mean;
}

void first_target(benchmark::State& state, const Dragged& handle) {
  const Editing& e = editing(handle.sample, 13e-3);
  Target target;
  for ([[maybe_unused]] const auto _ : state) target = EditSession(input_of(e), handle.operation, handle.arguments).first();
  count(state, e, target);
}

void next_target(benchmark::State& state, const Dragged& handle) {
  const Editing& e = editing(handle.sample, 13e-3);
  EditSession session(input_of(e), handle.operation, handle.arguments);
  session.first();
  Target target;
  int k = 0;
  for ([[maybe_unused]] const auto _ : state) target = session.target(handle.to[k++ % 2]);
  count(state, e, target);
}

const Dragged hem_shorter{
    "gored_skirt", "length", {{"loop", "hem"}, {"by", "-10 cm"}}, {{{"by", "-9 cm"}}, {{"by", "-12 cm"}}}};
const Dragged hem_longer{"gored_skirt", "length", {{"loop", "hem"}, {"by", "8 cm"}}, {{{"by", "7 cm"}}, {{"by", "9 cm"}}}};
const Dragged hip_wider{"gored_skirt", "fit", {{"loop", "hip"}, {"by", "1 cm"}}, {{{"by", "12 mm"}}, {{"by", "8 mm"}}}};
const Dragged sleeves_shorter{
    "t_shirt", "length", {{"loop", "SLEEVE.hem"}, {"by", "-3 cm"}}, {{{"by", "-25 mm"}}, {{"by", "-35 mm"}}}};
const Dragged closer{"t_shirt", "fit", {{"loop", "all"}, {"girth", "-3 cm"}}, {{{"girth", "-25 mm"}}, {{"girth", "-35 mm"}}}};

void as_an_editor_sees_it(benchmark::internal::Benchmark* bench) { bench->UseRealTime()->Unit(benchmark::kMillisecond); }

BENCHMARK_CAPTURE(first_target, hem_shorter, hem_shorter)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(first_target, hem_longer, hem_longer)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(first_target, hip_wider, hip_wider)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(first_target, sleeves_shorter, sleeves_shorter)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(first_target, closer, closer)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(next_target, hem_shorter, hem_shorter)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(next_target, hem_longer, hem_longer)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(next_target, hip_wider, hip_wider)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(next_target, sleeves_shorter, sleeves_shorter)->Apply(as_an_editor_sees_it);
BENCHMARK_CAPTURE(next_target, closer, closer)->Apply(as_an_editor_sees_it);

}  // namespace
}  // namespace toile

BENCHMARK_MAIN();
