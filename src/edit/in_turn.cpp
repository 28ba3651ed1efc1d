#include "edit/in_turn.h"

#include <algorithm>
#include <set>

#include "edit/edge_chain.h"
#include "edit/loops.h"
#include "style/normal_deviation.h"
#include "style/source_shape.h"

namespace toile {
namespace {

std::vector<int> both(const std::vector<int>& a, const std::vector<int>& b) {
  std::set<int> all(a.begin(), a.end());
  all.insert(b.begin(), b.end());
  return {all.begin(), all.end()};
}

}  // namespace

std::vector<std::string> names_apart(const EditInput& input, const std::string& list) {
  std::string edges;
  std::vector<std::string> others;
  for (const std::string& name : split_names(list)) {
    if (edges_named(input.pattern, input.garment, name).empty())
      others.push_back(name);
    else
      edges += (edges.empty() ? "" : ",") + name;
  }
  if (!edges.empty()) others.insert(others.begin(), edges);
  return others;
}

Target apply_in_turn(const EditInput& input, const EditArguments& arguments, const std::vector<std::string>& names,
                     const std::function<Target(const EditInput&, const EditArguments&)>& apply) {
  Target all;
  for (const std::string& name : names) {
    EditArguments own = arguments;
    own["loop"] = name;
    const bool first = all.positions.cols() == 0;
    EditInput from{input.pattern, input.garment, first ? input.drape : all.positions, input.body};
    if (first) from.memory = input.memory;
    Target next = apply(from, own);
    if (first) {
      all = std::move(next);
      continue;
    }
    all.positions = std::move(next.positions);
    all.held = both(all.held, next.held);
    all.anchor = both(all.anchor, next.anchor);
    all.before.shape += next.before.shape, all.before.proportion += next.before.proportion, all.before.fit += next.before.fit;
    all.after.shape += next.after.shape, all.after.proportion += next.after.proportion, all.after.fit += next.after.fit;
    all.report.append(next.report);
  }
  const NormalDeviation turned =
      normal_deviation(source_triangles(all.source, all.garment.triangles), all.source, all.positions);
  all.normal_deviation_mean = turned.mean;
  all.normal_deviation_max = turned.most;
  return all;
}

}  // namespace toile
