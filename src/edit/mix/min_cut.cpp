#include "edit/mix/min_cut.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace toile {
namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::bidirectionalS>;
struct NodeData {
  Traits::edge_descriptor predecessor;
  boost::default_color_type color = boost::white_color;
  long distance = 0;
};
struct EdgeData {
  std::int64_t capacity = 0, residual = 0;
  Traits::edge_descriptor reverse;
};
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS, NodeData, EdgeData>;

}  // namespace

std::vector<int> min_cut(const std::vector<int>& must, const std::vector<CutEdge>& edges) {
  double dearest = 0;
  for (const CutEdge& edge : edges) {
    if (!(edge.cost >= 0) || !std::isfinite(edge.cost)) throw std::invalid_argument("min_cut: costs must be 0 or more");
    dearest = std::max(dearest, edge.cost);
  }
  const double unit = dearest > 0 ? 1e6 / dearest : 1;
  const std::size_t count = must.size();
  const std::size_t source = count, sink = count + 1;
  Graph graph(count + 2);
  const auto join = [&](std::size_t a, std::size_t b, std::int64_t there, std::int64_t back) {
    const auto forward = boost::add_edge(a, b, graph).first, backward = boost::add_edge(b, a, graph).first;
    graph[forward].capacity = there;
    graph[backward].capacity = back;
    graph[forward].reverse = backward;
    graph[backward].reverse = forward;
  };
  const std::int64_t endless = static_cast<std::int64_t>(2e6) * static_cast<std::int64_t>(edges.size() + 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (must[i] == 0) join(source, i, endless, 0);
    if (must[i] == 1) join(i, sink, endless, 0);
  }
  for (const CutEdge& edge : edges) {
    const std::int64_t cost = std::llround(edge.cost * unit);
    join(static_cast<std::size_t>(edge.a), static_cast<std::size_t>(edge.b), cost, cost);
  }
  boost::boykov_kolmogorov_max_flow(graph, boost::get(&EdgeData::capacity, graph), boost::get(&EdgeData::residual, graph),
                                    boost::get(&EdgeData::reverse, graph), boost::get(&NodeData::predecessor, graph),
                                    boost::get(&NodeData::color, graph), boost::get(&NodeData::distance, graph),
                                    boost::get(boost::vertex_index, graph), source, sink);
  // What the source still reaches.
  std::vector<int> sides(count, 1);
  std::vector<bool> seen(count + 2, false);
  std::vector<std::size_t> stack{source};
  seen[source] = true;
  while (!stack.empty()) {
    const std::size_t at = stack.back();
    stack.pop_back();
    if (at < count) sides[at] = 0;
    for (auto [edge, end] = boost::out_edges(at, graph); edge != end; ++edge) {
      const std::size_t next = boost::target(*edge, graph);
      if (seen[next] || graph[*edge].residual <= 0) continue;
      seen[next] = true;
      stack.push_back(next);
    }
  }
  return sides;
}

}  // namespace toile
