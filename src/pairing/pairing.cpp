#include "pairing/pairing.h"

#include <algorithm>
#include <cmath>

#include "pairing/assignment.h"
#include "pairing/evidence.h"
#include "pairing/names.h"
#include "pairing/symmetry.h"

namespace toile {
namespace {

std::size_t u(int i) { return static_cast<std::size_t>(i); }

constexpr int few_rounds = 3, many_rounds = 8;
constexpr double unused_role = .1;  // nats

struct Attempt {
  const GarmentTemplate* garment = nullptr;
  std::vector<PieceName> names;
  PanelEdges all;
  Problem problem;
  Assignment found;
};

std::vector<PieceName> names_of(const Pattern& pattern, const GarmentTemplate& garment) {
  std::vector<PieceName> names;
  for (const Piece& piece : pattern.pieces) names.push_back(read_name(piece.name, garment));
  return names;
}

void pose(Attempt& attempt) {
  const std::size_t n = attempt.all.edges.size();
  attempt.problem.all = &attempt.all;
  attempt.problem.image = mirror_images(attempt.all, attempt.names);
  attempt.problem.openings = attempt.garment->openings;
  attempt.problem.pair.assign(n, std::vector<double>(n, impossible));
  attempt.problem.once.assign(n, std::vector<int>(n, -1));
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      const bool twins = attempt.problem.image[a] == static_cast<int>(b);
      const Evidence seen =
          evidence(attempt.all, static_cast<int>(a), static_cast<int>(b), twins, attempt.names, *attempt.garment);
      attempt.problem.pair[a][b] = attempt.problem.pair[b][a] = seen.total();
      const bool apart = attempt.all.edges[a].panel != attempt.all.edges[b].panel;
      if (seen.rule >= 0 && apart && attempt.garment->seams[u(seen.rule)].once)
        attempt.problem.once[a][b] = attempt.problem.once[b][a] = seen.rule;
    }
}

Attempt attempt_as(const Pattern& pattern, const GarmentTemplate& garment, int rounds) {
  Attempt out;
  out.garment = &garment;
  out.names = names_of(pattern, garment);
  std::vector<bool> sewn;
  for (const PieceName& name : out.names) sewn.push_back(name.role < 0 || !garment.roles[u(name.role)].extra);
  out.all = panel_edges(pattern, sewn);
  pose(out);
  out.found = assign(out.problem, rounds);
  return out;
}

// Of two garments that explain the pieces as well, the simpler one.
int unused_roles(const std::vector<PieceName>& names, const GarmentTemplate& garment) {
  int unused = 0;
  for (int r = 0; r < static_cast<int>(garment.roles.size()); ++r)
    unused += std::none_of(names.begin(), names.end(), [&](const PieceName& name) { return name.role == r; });
  return unused;
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

}  // namespace

Proposal propose_seams(const Pattern& pattern, const std::vector<GarmentTemplate>& templates) {
  GarmentTemplate none;
  none.openings = {2, 3, 4};
  const auto garments = in_question(pattern, templates);
  Attempt best =
      attempt_as(pattern, garments.empty() ? none : *garments.front(), garments.size() > 1 ? few_rounds : many_rounds);
  best.problem.all = &best.all;
  if (garments.size() > 1) {
    const auto worth = [](const Attempt& a) { return a.found.score - unused_role * unused_roles(a.names, *a.garment); };
    for (std::size_t g = 1; g < garments.size(); ++g) {
      Attempt next = attempt_as(pattern, *garments[g], few_rounds);
      if (worth(next) > worth(best) + 1e-9) best = std::move(next);
      best.problem.all = &best.all;
    }
    best = attempt_as(pattern, *best.garment, many_rounds);
    best.problem.all = &best.all;
  }
  Proposal out;
  out.garment = best.garment->name;
  out.pattern = pattern;
  out.pattern.seams.clear();
  const std::vector<double> margin = margins(best.problem, best.found);
  for (int a = 0; a < static_cast<int>(best.all.edges.size()); ++a) {
    const int b = best.found.mates[u(a)];
    if (b <= a) continue;
    ProposedSeam seam;
    seam.seam.a = span_of(pattern, best.all, a);
    seam.seam.b = reversed(span_of(pattern, best.all, b));
    const Evidence seen = evidence(best.all, a, b, best.problem.image[u(a)] == b, best.names, *best.garment);
    seam.reasons = reasons(best.all, a, b, seen, *best.garment);
    seam.length_a = best.all.edges[u(a)].length;
    seam.length_b = best.all.edges[u(b)].length;
    seam.confidence = 1 - .5 * std::exp(-margin[u(a)] / 2);
    out.seams.push_back(seam);
    out.pattern.seams.push_back(seam.seam);
  }
  return out;
}

}  // namespace toile
