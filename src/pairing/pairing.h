#pragma once
// Seams for a pattern that does not say how it is sewn.

#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

struct ProposedSeam {
  Seam seam;
  double confidence = 0;              // 0..1
  std::vector<std::string> reasons;   // "lengths agree within 0.3 mm", "curves mate"
  double length_a = 0, length_b = 0;  // m
};

struct Proposal {
  std::string garment;  // the template that fits best, or nothing
  double fit = 0;       // its score over that of no template, nats
  std::vector<ProposedSeam> seams;
  Pattern pattern;                    // the given one with these seams, hems marked and places on the body
  std::vector<std::string> unplaced;  // pieces of which nothing says where they sit
  std::vector<std::string> apart;     // pieces that should be sewn and are not sewn to the others
  std::vector<std::string> extras;    // pieces that lie on others or bind their edges: pockets, facings, bindings
  double least_confidence = 0;        // of all seams; 1 when there is none to sew
};

// Pairs the edges of all copies in one assignment: by length (equal, eased, gathered up to 2.2), sums of edges against a longer
// one, shape, notches, the way pieces hang, names, symmetry, and how the whole comes together at every corner. The pattern's
// own seams are ignored. Deterministic. Without a template that fits, the shapes alone decide.
Proposal propose_seams(const Pattern& pattern, const std::vector<GarmentTemplate>& templates);

}  // namespace toile
