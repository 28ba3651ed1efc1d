#include "pairing/chains.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pairing/evidence.h"
#include "pairing/symmetry.h"

namespace toile {
namespace {

std::size_t u(int i) { return static_cast<std::size_t>(i); }

constexpr std::size_t longest = 12;      // edges to one
constexpr double most_difference = .45;  // log of the ratio of lengths
constexpr std::size_t most_trials = 60;
constexpr int most_splits = 12;
constexpr double each_part = 2.2;  // nats: shared out, every part fits by itself, so that only the whole is evidence

// `others` in the order in which `edge` meets them.
struct Chain {
  int edge = 0;
  std::vector<int> others;
  double difference = 0;  // |log| of the ratio of lengths
};

double length_of(const Attempt& attempt, int edge) { return attempt.all.edges[u(edge)].length; }

// Mirror images have the same corners: none of their edges is shared out between the two.
bool of_twins(const Attempt& attempt, int a, int b) {
  const int image = attempt.problem.image[u(a)];
  const int panel = attempt.all.edges[u(a)].panel;
  return image >= 0 && attempt.all.edges[u(image)].panel != panel &&
         attempt.all.edges[u(b)].panel == attempt.all.edges[u(image)].panel;
}

void chains_of(const Attempt& attempt, int edge, std::vector<Chain>& out) {
  Mates mates = attempt.found.mates;
  if (mates[u(edge)] >= 0) {
    mates[u(mates[u(edge)])] = -1;
    mates[u(edge)] = -1;
  }
  const double whole = length_of(attempt, edge);
  for (const std::vector<int>& loop : open_loops(attempt.all, mates))
    for (std::size_t first = 0; first < loop.size(); ++first) {
      Chain chain{edge, {}, 0};
      double sum = 0;
      for (std::size_t k = 0; k < std::min(loop.size(), longest); ++k) {
        const int next = loop[(first + k) % loop.size()];
        if (next == edge || of_twins(attempt, edge, next)) break;
        chain.others.insert(chain.others.begin(), next);
        sum += length_of(attempt, next);
        if (sum > whole * std::exp(most_difference)) break;
        chain.difference = std::abs(std::log(sum / whole));
        if (chain.others.size() >= 2 && chain.difference <= most_difference) out.push_back(chain);
      }
    }
}

std::optional<Chain> image_of(const Attempt& attempt, const Chain& chain) {
  const std::vector<int>& image = attempt.problem.image;
  Chain out;
  out.edge = image[u(chain.edge)];
  if (out.edge < 0 || out.edge == chain.edge) return std::nullopt;
  for (const int other : chain.others) {
    const int there = image[u(other)];
    const auto taken = [&](int e) {
      return std::find(chain.others.begin(), chain.others.end(), e) != chain.others.end() || e == chain.edge;
    };
    if (there < 0 || taken(there) || taken(out.edge) || there == out.edge) return std::nullopt;
    out.others.insert(out.others.begin(), there);
  }
  return out;
}

void apply(const Pattern& pattern, Attempt& attempt, const Chain& chain) {
  double sum = 0;
  for (const int other : chain.others) sum += length_of(attempt, other);
  std::vector<double> shares;
  double at = 0;
  for (std::size_t k = 0; k + 1 < chain.others.size(); ++k) {
    at += length_of(attempt, chain.others[k]) / sum;
    shares.push_back(at);
  }
  Mates& mates = attempt.found.mates;
  const std::vector<int> parts = split_edge(pattern, attempt.all, chain.edge, shares);
  mates.resize(attempt.all.edges.size(), -1);
  const auto unsew = [&](int edge) {
    if (mates[u(edge)] >= 0) mates[u(mates[u(edge)])] = -1;
    mates[u(edge)] = -1;
  };
  for (std::size_t k = 0; k < parts.size(); ++k) {
    unsew(parts[k]);
    unsew(chain.others[k]);
    mates[u(parts[k])] = chain.others[k];
    mates[u(chain.others[k])] = parts[k];
  }
}

// The score with the chain sewn, without searching on. Only the pairs that are sewn are looked at.
double score_with(const Pattern& pattern, const Attempt& attempt, const Chain& chain, const std::optional<Chain>& image) {
  Attempt trial;
  trial.garment = attempt.garment;
  trial.names = attempt.names;
  trial.all = attempt.all;
  trial.found = attempt.found;
  apply(pattern, trial, chain);
  if (image) apply(pattern, trial, *image);
  const std::size_t n = trial.all.edges.size();
  trial.problem.all = &trial.all;
  trial.problem.openings = attempt.problem.openings;
  trial.problem.image = mirror_images(trial.all, trial.names);
  trial.problem.pair.assign(n, std::vector<double>(n, impossible));
  trial.problem.once.assign(n, std::vector<int>(n, -1));
  for (int a = 0; a < static_cast<int>(n); ++a) {
    const int b = trial.found.mates[u(a)];
    if (b < 0) continue;
    const Evidence seen = evidence(trial.all, a, b, trial.problem.image[u(a)] == b, trial.names, *trial.garment);
    trial.problem.pair[u(a)][u(b)] = seen.total();
    if (seen.rule >= 0 && trial.all.edges[u(a)].panel != trial.all.edges[u(b)].panel && trial.garment->seams[u(seen.rule)].once)
      trial.problem.once[u(a)][u(b)] = seen.rule;
  }
  return score(trial.problem, trial.found.mates);
}

bool split_once(const Pattern& pattern, Attempt& attempt) {
  std::vector<Chain> chains;
  for (int e = 0; e < static_cast<int>(attempt.all.edges.size()); ++e) {
    std::vector<Chain> of_edge;
    chains_of(attempt, e, of_edge);
    std::stable_sort(of_edge.begin(), of_edge.end(),
                     [](const Chain& x, const Chain& y) { return x.difference < y.difference; });
    if (of_edge.size() > most_trials) of_edge.resize(most_trials);
    chains.insert(chains.end(), of_edge.begin(), of_edge.end());
  }
  double best = attempt.found.score;
  const Chain* chosen = nullptr;
  for (const Chain& chain : chains) {
    const double value = score_with(pattern, attempt, chain, image_of(attempt, chain));
    const double parts = static_cast<double>(chain.others.size() - 1) * (image_of(attempt, chain) ? 2 : 1);
    if (value - each_part * parts > best) {
      best = value - each_part * parts;
      chosen = &chain;
    }
  }
  if (!chosen) return false;
  const std::optional<Chain> image = image_of(attempt, *chosen);
  apply(pattern, attempt, *chosen);
  if (image) apply(pattern, attempt, *image);
  pose(attempt);
  attempt.found = assign(attempt.problem, 1, attempt.found.mates);
  return true;
}

}  // namespace

bool share_out(const Pattern& pattern, Attempt& attempt) {
  int splits = 0;
  while (splits < most_splits && split_once(pattern, attempt)) ++splits;
  return splits > 0;
}

}  // namespace toile
