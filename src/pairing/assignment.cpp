#include "pairing/assignment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

#include "pairing/evidence.h"
#include "pairing/symmetry.h"

namespace toile {
namespace {

std::size_t u(int i) { return static_cast<std::size_t>(i); }

using Pairs = std::vector<std::pair<int, int>>;

constexpr double second_line = 4;
constexpr double lopsided = .6;  // for each seam without its mirror image
constexpr double least_pair = -2.2;
constexpr double least_zipped = -1;
constexpr std::size_t most_partners = 14, longest_zip = 4;
constexpr int steps_for_each_edge = 500;
constexpr double hot = 2.2, cold = .15;  // nats

// Deterministic dice.
struct Dice {
  std::uint64_t state = 0x9e3779b97f4a7c15ull;
  std::uint32_t roll() {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<std::uint32_t>(state >> 33);
  }
  double share() { return roll() / 2147483648.0; }
};

void unsew(Mates& mates, int edge) {
  if (mates[u(edge)] < 0) return;
  mates[u(mates[u(edge)])] = -1;
  mates[u(edge)] = -1;
}

void sew(Mates& mates, int a, int b) {
  unsew(mates, a);
  unsew(mates, b);
  mates[u(a)] = b;
  mates[u(b)] = a;
}

// Pairs worth trying: the best partners of each edge.
std::vector<std::vector<char>> worth_trying(const Problem& problem) {
  const int n = static_cast<int>(problem.pair.size());
  std::vector<std::vector<char>> good(u(n), std::vector<char>(u(n), 0));
  for (int a = 0; a < n; ++a) {
    std::vector<int> order;
    for (int b = 0; b < n; ++b)
      if (a != b && problem.pair[u(a)][u(b)] > least_pair) order.push_back(b);
    std::stable_sort(order.begin(), order.end(),
                     [&](int x, int y) { return problem.pair[u(a)][u(x)] > problem.pair[u(a)][u(y)]; });
    if (order.size() > most_partners) order.resize(most_partners);
    for (const int b : order) good[u(a)][u(b)] = good[u(b)][u(a)] = 1;
  }
  return good;
}

bool use_an_edge_twice(const Pairs& pairs) {
  std::vector<int> used;
  for (const auto& [a, b] : pairs) used.insert(used.end(), {a, b});
  std::sort(used.begin(), used.end());
  return std::adjacent_find(used.begin(), used.end()) != used.end();
}

// With the mirror images of its seams; nothing where they are unknown, the seams themselves, or in their way.
Pairs with_images(const Problem& problem, const Pairs& pairs) {
  Pairs both = pairs;
  for (const auto& [a, b] : pairs) {
    const int ia = problem.image[u(a)], ib = problem.image[u(b)];
    if (ia < 0 || ib < 0) return {};
    const std::pair<int, int> image = std::minmax(ia, ib), seam = std::minmax(a, b);
    if (image != seam) both.push_back(image);
  }
  if (both.size() == pairs.size() || use_an_edge_twice(both)) return {};
  return both;
}

// Seams to try at once: one, a run of neighbouring ones as a zip closes, each also with its mirror image.
std::vector<Pairs> candidates(const Problem& problem) {
  const auto good = worth_trying(problem);
  const int n = static_cast<int>(good.size());
  std::vector<Pairs> out;
  const auto add = [&](const Pairs& pairs) {
    out.push_back(pairs);
    if (Pairs both = with_images(problem, pairs); !both.empty()) out.push_back(std::move(both));
  };
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      if (!good[u(a)][u(b)]) continue;
      Pairs zip{{a, b}};
      if (a < b) add(zip);
      for (int x = a, y = b; zip.size() < longest_zip;) {
        x = problem.all->edges[u(x)].next;
        y = problem.all->edges[u(y)].previous;
        if (x == y || problem.pair[u(x)][u(y)] < least_zipped) break;
        zip.emplace_back(x, y);
        if (use_an_edge_twice(zip)) break;
        add(zip);
      }
    }
  return out;
}

void sew(Mates& mates, const Pairs& pairs) {
  for (const auto& [a, b] : pairs) sew(mates, a, b);
}

// What the seams push aside, sewn to each other.
void sew_rest(const Problem& problem, const Mates& before, Mates& mates, const Pairs& pairs) {
  for (const auto& [a, b] : pairs) {
    const int p = before[u(a)], q = before[u(b)];
    if (p >= 0 && q >= 0 && p != b && mates[u(p)] < 0 && mates[u(q)] < 0 && p != q && problem.pair[u(p)][u(q)] > least_pair)
      sew(mates, p, q);
  }
}

bool climb(const Problem& problem, const std::vector<Pairs>& moves, Assignment& at) {
  Assignment best = at;
  const auto try_out = [&](const Mates& mates) {
    const double value = score(problem, mates);
    if (value > best.score + 1e-9) best = {mates, value};
  };
  Mates mates;
  for (const Pairs& move : moves) {
    const bool sewn = std::all_of(move.begin(), move.end(), [&](const auto& m) { return at.mates[u(m.first)] == m.second; });
    mates = at.mates;
    if (sewn) {
      for (const auto& [a, b] : move) unsew(mates, a);
      try_out(mates);
      continue;
    }
    sew(mates, move);
    try_out(mates);
    const Mates once = mates;
    sew_rest(problem, at.mates, mates, move);
    if (mates != once) try_out(mates);
  }
  const bool better = best.score > at.score + 1e-9;
  at = std::move(best);
  return better;
}

// Simulated annealing over `steps` tries; leaves the best it met.
void anneal(const Problem& problem, const std::vector<Pairs>& moves, int steps, Dice& dice, Assignment& at) {
  Assignment best = at;
  Mates mates;
  for (int step = 0; step < steps && !moves.empty(); ++step) {
    const double heat = hot * std::pow(cold / hot, double(step) / steps);
    const Pairs& move = moves[dice.roll() % moves.size()];
    const bool sewn = std::all_of(move.begin(), move.end(), [&](const auto& m) { return at.mates[u(m.first)] == m.second; });
    mates = at.mates;
    if (sewn) {
      for (const auto& [a, b] : move) unsew(mates, a);
    } else {
      sew(mates, move);
      if (dice.roll() % 2) sew_rest(problem, at.mates, mates, move);
    }
    const double value = score(problem, mates);
    if (value < at.score && dice.share() >= std::exp((value - at.score) / heat)) continue;
    std::swap(at.mates, mates);
    at.score = value;
    if (at.score > best.score) best = at;
  }
  at = std::move(best);
}

// Whether the seam of a to b is carried on beyond a's end, darts in the way aside.
bool goes_on(const PanelEdges& all, const Mates& mates, int a, int b) {
  const auto past_darts = [&](int edge, bool forwards) {
    const int panel = all.edges[u(edge)].panel;
    const auto step = [&](int e) { return forwards ? all.edges[u(e)].next : all.edges[u(e)].previous; };
    int at = step(edge);
    while (at != edge && mates[u(at)] == step(at) && all.edges[u(mates[u(at)])].panel == panel) at = step(mates[u(at)]);
    return at;
  };
  return mates[u(past_darts(a, true))] == past_darts(b, false);
}

// Every way in which panels of one outline can change places: the new place of each edge.
std::vector<std::vector<int>> exchanges(const PanelEdges& all) {
  std::vector<std::vector<int>> out;
  const int count = static_cast<int>(all.panels.size());
  for (int p = 0; p < count; ++p)
    for (int q = p + 1; q < count; ++q) {
      const int start = same_outline(all, p, q);
      if (start < 0) continue;
      std::vector<int> to(all.edges.size());
      std::iota(to.begin(), to.end(), 0);
      int a = all.panels[u(p)].first, b = start;
      do {
        to[u(a)] = b;
        to[u(b)] = a;
        a = all.edges[u(a)].next;
        b = all.edges[u(b)].next;
      } while (a != all.panels[u(p)].first);
      out.push_back(std::move(to));
    }
  return out;
}

Mates exchanged(const Mates& mates, const std::vector<int>& to) {
  Mates out(mates.size(), -1);
  for (std::size_t e = 0; e < mates.size(); ++e)
    if (mates[e] >= 0) out[u(to[e])] = to[u(mates[e])];
  return out;
}

bool change_places(const Problem& problem, const std::vector<std::vector<int>>& places, Assignment& at) {
  Assignment best = at;
  for (const std::vector<int>& to : places) {
    Mates mates = exchanged(at.mates, to);
    const double value = score(problem, mates);
    if (value > best.score + 1e-9) best = {std::move(mates), value};
  }
  const bool better = best.score > at.score + 1e-9;
  at = std::move(best);
  return better;
}

}  // namespace

double score(const Problem& problem, const Mates& mates) {
  double sum = 0;
  std::vector<std::tuple<int, int, int>> lines;  // kind and panels of each line of seams
  for (int a = 0; a < static_cast<int>(mates.size()); ++a) {
    const int b = mates[u(a)];
    if (b <= a) continue;
    sum += problem.pair[u(a)][u(b)];
    if (const int kind = problem.once[u(a)][u(b)]; kind >= 0 && !goes_on(*problem.all, mates, a, b)) {
      const auto [p, q] = std::minmax(problem.all->edges[u(a)].panel, problem.all->edges[u(b)].panel);
      lines.emplace_back(kind, p, q);
    }
    const int ia = problem.image[u(a)], ib = problem.image[u(b)];
    if (ia >= 0 && ib >= 0 && mates[u(ia)] != ib) sum -= lopsided;
  }
  std::sort(lines.begin(), lines.end());
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (lines[i] == lines[i - 1]) sum -= second_line;
  return sum + whole_score(*problem.all, mates, problem.openings);
}

Assignment assign(const Problem& problem, int rounds, const Mates& start) {
  const std::vector<Pairs> moves = candidates(problem);
  const auto places = exchanges(*problem.all);
  Assignment first;
  first.mates = start.empty() ? Mates(problem.pair.size(), -1) : start;
  first.score = score(problem, first.mates);
  Assignment best = first;
  Dice dice;
  for (int round = 0; round < rounds; ++round) {
    Assignment next = first;
    anneal(problem, moves, steps_for_each_edge * static_cast<int>(problem.pair.size()), dice, next);
    while (climb(problem, moves, next) || change_places(problem, places, next)) {
    }
    if (next.score > best.score + 1e-9) best = std::move(next);
  }
  return best;
}

std::vector<double> margins(const Problem& problem, const Assignment& found) {
  const int n = static_cast<int>(found.mates.size());
  std::vector<double> out(u(n), 0);
  const std::vector<Pairs> moves = candidates(problem);
  for (int a = 0; a < n; ++a) {
    const int b = found.mates[u(a)];
    if (b <= a) continue;
    Mates mates = found.mates;
    unsew(mates, a);
    double best = score(problem, mates);
    for (const Pairs& move : moves) {
      const bool touches = std::any_of(move.begin(), move.end(), [&](const auto& m) {
        return m.first == a || m.first == b || m.second == a || m.second == b;
      });
      const bool same = std::any_of(move.begin(), move.end(),
                                    [&](const auto& m) { return std::minmax(m.first, m.second) == std::minmax(a, b); });
      if (!touches || same) continue;
      mates = found.mates;
      sew(mates, move);
      best = std::max(best, score(problem, mates));
      sew_rest(problem, found.mates, mates, move);
      best = std::max(best, score(problem, mates));
    }
    out[u(a)] = out[u(b)] = std::max(0.0, found.score - best);
  }
  return out;
}

}  // namespace toile
