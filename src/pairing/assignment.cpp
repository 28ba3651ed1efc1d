#include "pairing/assignment.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "pairing/evidence.h"

namespace toile {
namespace {

std::size_t u(int i) { return static_cast<std::size_t>(i); }

using Pairs = std::vector<std::pair<int, int>>;

constexpr double lopsided = .6;  // for each seam without its mirror image
constexpr double least_pair = -2.2;
constexpr std::size_t most_partners = 14;

// Deterministic dice.
struct Dice {
  std::uint64_t state = 0x9e3779b97f4a7c15ull;
  std::uint32_t roll() {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<std::uint32_t>(state >> 33);
  }
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

// Seams worth trying: each alone and with its mirror image.
std::vector<Pairs> candidates(const Problem& problem) {
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
  std::vector<Pairs> out;
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b) {
      if (!good[u(a)][u(b)]) continue;
      out.push_back({{a, b}});
      const int ia = problem.image[u(a)], ib = problem.image[u(b)];
      if (ia < 0 || ib < 0 || ia == ib) continue;
      if (std::minmax(ia, ib) == std::minmax(a, b)) continue;
      if (ia == a || ib == b || ia == b || ib == a) continue;  // the two would share an edge
      if (std::minmax(ia, ib) > std::minmax(a, b)) out.push_back({{a, b}, {ia, ib}});
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

// Takes the seams of a few neighbouring panels out.
void shake(const Problem& problem, Mates& mates, Dice& dice) {
  const auto panels = static_cast<std::uint32_t>(problem.all->panels.size());
  const int first = static_cast<int>(dice.roll() % panels), second = static_cast<int>(dice.roll() % panels);
  const std::uint32_t share = 40 + dice.roll() % 61;
  for (int e = 0; e < static_cast<int>(mates.size()); ++e) {
    const int panel = problem.all->edges[u(e)].panel;
    if (mates[u(e)] >= 0 && (panel == first || panel == second) && dice.roll() % 100 < share) {
      const int image = problem.image[u(e)];
      unsew(mates, e);
      if (image >= 0) unsew(mates, image);
    }
  }
}

}  // namespace

double score(const Problem& problem, const Mates& mates) {
  double sum = 0;
  for (int a = 0; a < static_cast<int>(mates.size()); ++a) {
    const int b = mates[u(a)];
    if (b <= a) continue;
    sum += problem.pair[u(a)][u(b)];
    const int ia = problem.image[u(a)], ib = problem.image[u(b)];
    if (ia >= 0 && ib >= 0 && mates[u(ia)] != ib) sum -= lopsided;
  }
  return sum + whole_score(*problem.all, mates, problem.openings);
}

Assignment assign(const Problem& problem, int rounds, const Mates& start) {
  const std::vector<Pairs> moves = candidates(problem);
  Assignment best;
  best.mates = start.empty() ? Mates(problem.pair.size(), -1) : start;
  best.score = score(problem, best.mates);
  while (climb(problem, moves, best)) {
  }
  Dice dice;
  for (int round = 0; round < rounds && !problem.all->panels.empty(); ++round) {
    Assignment next = best;
    shake(problem, next.mates, dice);
    next.score = score(problem, next.mates);
    while (climb(problem, moves, next)) {
    }
    if (next.score > best.score + 1e-9) best = next;
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
      const bool same = std::any_of(move.begin(), move.end(), [&](const auto& m) { return m.first == a && m.second == b; });
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
