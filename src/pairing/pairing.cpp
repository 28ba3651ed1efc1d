#include "pairing/pairing.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "pairing/attempt.h"
#include "pairing/evidence.h"
#include "pairing/places.h"

namespace toile {
namespace {

std::size_t u(int i) { return static_cast<std::size_t>(i); }

constexpr int few_rounds = 3, many_rounds = 8;
constexpr std::size_t many_edges = 48;
constexpr double unused_role = .4, unplaced_piece = 4;  // nats
constexpr double shapes_alone = .85;                    // of the confidence, without names

// Of two garments that explain the pieces as well, the simpler one, and one in which every piece has its place.
double worth(const Attempt& attempt, Pattern pattern) {
  int unused = 0;
  for (int r = 0; r < static_cast<int>(attempt.garment->roles.size()); ++r)
    unused += std::none_of(attempt.names.begin(), attempt.names.end(), [&](const PieceName& name) { return name.role == r; });
  const double nowhere = static_cast<double>(place_on_body(attempt, pattern).size());
  return attempt.found.score - unused_role * unused - unplaced_piece * nowhere;
}

// The templates that know the most of the pieces by their names.
std::vector<const GarmentTemplate*> in_question(const Pattern& pattern, const std::vector<GarmentTemplate>& templates) {
  std::vector<const GarmentTemplate*> out;
  std::pair<int, int> most{1, 0};
  for (const GarmentTemplate& garment : templates) {
    std::pair<int, int> known{0, 0};  // pieces with a role; of these, said by name
    for (const PieceName& name : names_of(pattern, garment)) {
      known.first += name.role >= 0;
      known.second += name.role >= 0 && name.said;
    }
    if (known > most) out.clear();
    if (known >= most) out.push_back(&garment);
    most = std::max(most, known);
  }
  return out;
}

Attempt best_attempt(const Pattern& pattern, const std::vector<GarmentTemplate>& templates, const GarmentTemplate& none) {
  const auto garments = in_question(pattern, templates);
  if (garments.empty()) return attempt_as(pattern, none, many_rounds);
  const GarmentTemplate* best = garments.front();
  if (garments.size() > 1) {
    std::size_t edges = 0;
    for (const Piece& piece : pattern.pieces) edges += piece.outline.size() * u(copies(piece));
    const int rounds = edges > many_edges ? few_rounds : many_rounds;
    double most = -1e300;
    for (const GarmentTemplate* garment : garments) {
      const double value = worth(attempt_as(pattern, *garment, rounds), pattern);
      if (value > most + 1e-9) {
        most = value;
        best = garment;
      }
    }
  }
  return attempt_as(pattern, *best, many_rounds);
}

std::string kind_of(const Attempt& attempt, const Evidence& seen) {
  if (seen.layout > 0) return "dart";
  return seen.rule >= 0 ? attempt.garment->seams[u(seen.rule)].name : "seam";
}

}  // namespace

Proposal propose_seams(const Pattern& pattern, const std::vector<GarmentTemplate>& templates) {
  GarmentTemplate none;
  none.openings = {2, 3, 4};
  Attempt best = best_attempt(pattern, templates, none);
  best.problem.all = &best.all;
  const bool named = !best.garment->name.empty();
  Proposal out;
  out.garment = best.garment->name;
  out.pattern = pattern;
  out.pattern.seams.clear();
  out.least_confidence = 1;
  const std::vector<double> margin = margins(best.problem, best.found);
  std::map<std::string, int> counts;
  for (int a = 0; a < static_cast<int>(best.all.edges.size()); ++a) {
    const int b = best.found.mates[u(a)];
    if (b <= a) continue;
    ProposedSeam seam;
    const Evidence seen = evidence(best.all, a, b, best.problem.image[u(a)] == b, best.names, *best.garment);
    const std::string kind = kind_of(best, seen);
    seam.seam.name = kind + " " + std::to_string(++counts[kind]);
    seam.seam.a = span_of(pattern, best.all, a);
    seam.seam.b = reversed(span_of(pattern, best.all, b));
    seam.reasons = reasons(best.all, a, b, seen, *best.garment);
    seam.length_a = best.all.edges[u(a)].length;
    seam.length_b = best.all.edges[u(b)].length;
    seam.confidence = (1 - .6 * std::exp(-margin[u(a)] / 2)) * (named ? 1 : shapes_alone);
    out.least_confidence = std::min(out.least_confidence, seam.confidence);
    out.pattern.seams.push_back(seam.seam);
    out.seams.push_back(std::move(seam));
  }
  const std::vector<int> part = parts(best.all, best.found.mates);
  std::map<int, int> sizes;
  for (const int p : part) ++sizes[p];
  const auto largest =
      std::max_element(sizes.begin(), sizes.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
  std::vector<bool> loose(pattern.pieces.size(), false);
  for (std::size_t p = 0; p < part.size(); ++p)
    if (part[p] != largest->first) loose[u(best.all.panels[p].piece)] = true;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    if (out.pattern.pieces[p].sewn = best.sewn[p]; !best.sewn[p])
      out.extras.push_back(pattern.pieces[p].name);
    else if (loose[p])
      out.apart.push_back(pattern.pieces[p].name);
  out.unplaced = place_on_body(best, out.pattern);
  const auto extra = [&](const std::string& name) { return std::count(out.extras.begin(), out.extras.end(), name) > 0; };
  out.unplaced.erase(std::remove_if(out.unplaced.begin(), out.unplaced.end(), extra), out.unplaced.end());
  return out;
}

}  // namespace toile
