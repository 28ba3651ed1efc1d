#include "pairing/sewn.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "garment/units.h"

namespace toile {
namespace {

std::size_t u(int i) { return static_cast<std::size_t>(i); }

// Panels that meet all round a point lie flat when their angles make a full turn.
double closed_corner(double angle) {
  const double apart = (angle / degree - 360) / 38;
  return std::max(-3.5, 1.3 - apart * apart);
}

// A sewn edge that runs on smoothly makes half a turn.
double open_corner(double angle) {
  const double apart = (angle / degree - 180) / 32;
  return std::max(-1.2, .9 - apart * apart);
}

int root(std::vector<int>& parent, int i) {
  while (parent[u(i)] != i) i = parent[u(i)] = parent[u(parent[u(i)])];
  return i;
}

struct Corners {
  int count = 0;
  double score = 0;
};

Corners corners(const PanelEdges& all, const Mates& mates) {
  Corners out;
  const int n = static_cast<int>(all.edges.size());
  std::vector<char> seen(u(n), 0);
  const auto fan = [&](int from, bool closed) {
    double angle = 0;
    int wedges = 0, edge = from;
    do {
      seen[u(edge)] = 1;
      angle += all.edges[u(edge)].angle;
      ++wedges;
      const int mate = mates[u(edge)];
      if (mate < 0) break;
      edge = all.edges[u(mate)].next;
    } while (edge != from && wedges <= n);
    ++out.count;
    if (closed)
      out.score += closed_corner(angle);
    else if (wedges > 1)
      out.score += open_corner(angle);
  };
  for (int e = 0; e < n; ++e)
    if (mates[u(all.edges[u(e)].previous)] < 0) fan(e, false);
  for (int e = 0; e < n; ++e)
    if (!seen[u(e)]) fan(e, true);
  return out;
}

int next_open(const PanelEdges& all, const Mates& mates, int edge) {
  int at = all.edges[u(edge)].next;
  while (mates[u(at)] >= 0) at = all.edges[u(mates[u(at)])].next;
  return at;
}

int loop_count(const PanelEdges& all, const Mates& mates) {
  std::vector<char> seen(mates.size(), 0);
  int count = 0;
  for (int e = 0; e < static_cast<int>(mates.size()); ++e) {
    if (mates[u(e)] >= 0 || seen[u(e)]) continue;
    ++count;
    for (int at = e; !seen[u(at)]; at = next_open(all, mates, at)) seen[u(at)] = 1;
  }
  return count;
}

}  // namespace

std::vector<std::vector<int>> open_loops(const PanelEdges& all, const Mates& mates) {
  const int n = static_cast<int>(all.edges.size());
  std::vector<char> seen(u(n), 0);
  std::vector<std::vector<int>> loops;
  for (int e = 0; e < n; ++e) {
    if (mates[u(e)] >= 0 || seen[u(e)]) continue;
    loops.emplace_back();
    for (int at = e; !seen[u(at)]; at = next_open(all, mates, at)) {
      seen[u(at)] = 1;
      loops.back().push_back(at);
    }
  }
  return loops;
}

std::vector<int> parts(const PanelEdges& all, const Mates& mates) {
  std::vector<int> parent(all.panels.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t e = 0; e < mates.size(); ++e) {
    if (mates[e] < 0) continue;
    const int a = root(parent, all.edges[e].panel), b = root(parent, all.edges[u(mates[e])].panel);
    if (a != b) parent[u(std::max(a, b))] = std::min(a, b);
  }
  std::vector<int> number(parent.size(), -1), out;
  int count = 0;
  for (int p = 0; p < static_cast<int>(parent.size()); ++p) {
    const int r = root(parent, p);
    if (number[u(r)] < 0) number[u(r)] = count++;
    out.push_back(number[u(r)]);
  }
  return out;
}

double whole_score(const PanelEdges& all, const Mates& mates, const std::vector<int>& openings) {
  const Corners met = corners(all, mates);
  int open = 0, sewn = 0;
  for (const int mate : mates) (mate < 0 ? open : sewn) += 1;
  const int loops = loop_count(all, mates);
  const std::vector<int> part = parts(all, mates);
  const int count = part.empty() ? 0 : 1 + *std::max_element(part.begin(), part.end());
  const int euler = met.count - (open + sewn / 2) + static_cast<int>(all.panels.size());
  const double handles = (2 * count - loops - euler) / 2.0;  // of cloth: a sleeve sewn to the other one
  int off = 99;
  for (const int wanted : openings) off = std::min(off, std::abs(loops - (wanted + count - 1)));
  return met.score - 4 * handles - 2.5 * (count - 1) - 1.5 * off;
}

}  // namespace toile
