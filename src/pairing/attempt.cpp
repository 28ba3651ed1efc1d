#include "pairing/attempt.h"

#include <algorithm>

#include "pairing/chains.h"
#include "pairing/evidence.h"
#include "pairing/symmetry.h"

namespace toile {
namespace {

std::size_t u(int i) { return static_cast<std::size_t>(i); }

bool goes_round(const PieceRole& role) {
  return std::any_of(role.places.begin(), role.places.end(), [](const RolePlace& place) { return place.at.grain_round; });
}

}  // namespace

std::vector<PieceName> names_of(const Pattern& pattern, const GarmentTemplate& garment) {
  std::vector<PieceName> names;
  for (const Piece& piece : pattern.pieces) names.push_back(read_name(piece.name, garment));
  return names;
}

void pose(Attempt& attempt) {
  const std::size_t n = attempt.all.edges.size();
  Problem& problem = attempt.problem;
  problem.all = &attempt.all;
  problem.image = mirror_images(attempt.all, attempt.names);
  problem.openings = attempt.garment->openings;
  problem.pair.assign(n, std::vector<double>(n, impossible));
  problem.once.assign(n, std::vector<int>(n, -1));
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      const bool twins = problem.image[a] == static_cast<int>(b);
      const Evidence seen =
          evidence(attempt.all, static_cast<int>(a), static_cast<int>(b), twins, attempt.names, *attempt.garment);
      problem.pair[a][b] = problem.pair[b][a] = seen.total();
      const bool two_panels = attempt.all.edges[a].panel != attempt.all.edges[b].panel;
      if (seen.rule >= 0 && two_panels && attempt.garment->seams[u(seen.rule)].once)
        problem.once[a][b] = problem.once[b][a] = seen.rule;
    }
}

Attempt attempt_as(const Pattern& pattern, const GarmentTemplate& garment, int rounds) {
  Attempt out;
  out.garment = &garment;
  out.names = names_of(pattern, garment);
  for (const PieceName& name : out.names) out.sewn.push_back(name.role < 0 || !garment.roles[u(name.role)].extra);
  std::vector<bool> bands;
  for (const PieceName& name : out.names) bands.push_back(name.role >= 0 && goes_round(garment.roles[u(name.role)]));
  out.all = panel_edges(pattern, out.sewn, bands);
  pose(out);
  out.found = assign(out.problem, rounds);
  if (share_out(pattern, out)) out.found = assign(out.problem, 2, out.found.mates);
  return out;
}

}  // namespace toile
