#pragma once
// How well two edges go together, by what can be seen of the two alone.

#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "pairing/names.h"
#include "pairing/panel_edges.h"

namespace toile {

// Each in nats: how much likelier the pair is sewn than chance. Their sum counts.
struct Evidence {
  double lengths = 0, shape = 0, upright = 0, notches = 0, names = 0, layout = 0;
  int rule = -1;  // index into GarmentTemplate::seams, when one speaks for the pair
  double total() const { return lengths + shape + upright + notches + names + layout; }
};

constexpr double impossible = -50;

// Longest gather that is believed: 2.2 times.
constexpr double most_gather = 2.25;

// `twins`: the two are mirror images of each other, so that they agree whether they are sewn or not. `names` by piece;
// `garment` may have no roles.
Evidence evidence(const PanelEdges& all, int a, int b, bool twins, const std::vector<PieceName>& names,
                  const GarmentTemplate& garment);

// "lengths agree within 0.3 mm", "curves mate", "2 notches meet", ...
std::vector<std::string> reasons(const PanelEdges& all, int a, int b, const Evidence& evidence, const GarmentTemplate& garment);

}  // namespace toile
