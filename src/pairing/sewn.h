#pragma once
// A choice of seams as a whole: what comes together at every corner, and what kind of surface it makes.

#include <vector>

#include "pairing/panel_edges.h"

namespace toile {

// By edge: the edge it is sewn to, start to end; -1: open.
using Mates = std::vector<int>;

// What cloth cannot do easily, over all corners and the whole surface. Nats, higher is better.
double whole_score(const PanelEdges& all, const Mates& mates, const std::vector<int>& openings);

// Loops of open edges, each in order.
std::vector<std::vector<int>> open_loops(const PanelEdges& all, const Mates& mates);

// The panel part each panel belongs to, numbered from 0 in order.
std::vector<int> parts(const PanelEdges& all, const Mates& mates);

}  // namespace toile
