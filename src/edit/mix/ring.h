#pragma once
// What is open where a part was cut off, as a closed line that is sewn to another.

#include <vector>

#include "body/relative.h"
#include "edit/mix/take_part.h"

namespace toile {

// Edges end to end round a limb, in the sense of growing angle.
struct Ring {
  std::vector<EdgeSpan> spans;
  std::vector<double> starts;  // m along the ring at which each span starts, and its whole length at the end
  std::vector<double> along;   // m, of samples
  std::vector<double> angle;   // of the same, growing, a full turn from first to last

  double length() const { return starts.back(); }
  double angle_at(double at) const;
  double at_angle(double value) const;
};

// Throws BadInput edit.open-loop when the edges hang apart.
Ring make_ring(const EditInput& input, const Part& part, std::size_t loop, int limb, const std::string& place);

// Stretches of two rings that meet: begin and end of each, m.
struct RingMatch {
  double a_begin, a_end, b_begin, b_end;
};

// `meet`: m, seams this near to each other meet.
std::vector<RingMatch> match(const Ring& a, const Ring& b, double meet);

// The stretch as part of the span that it lies in.
EdgeSpan span_of(const Ring& ring, double begin, double end);

}  // namespace toile
