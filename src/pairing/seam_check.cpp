#include "pairing/seam_check.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double same_notch = 12e-3;  // m, farther apart two notches are not meant for each other

// Places of the notches on a span, in metres from its beginning as it runs.
std::vector<double> notches_on(const Pattern& pattern, const EdgeSpan& span) {
  const Piece& piece = *find_piece(pattern, span.piece);
  const double length = span_length(pattern, span);
  std::vector<double> places;
  for (const Notch& notch : piece.notches) {
    if (notch.edge != span.edge || span.begin == span.end) continue;
    const double at = (notch.at - span.begin) / (span.end - span.begin) * length;
    if (at > 1e-3 && at < length - 1e-3) places.push_back(at);
  }
  std::sort(places.begin(), places.end());
  return places;
}

void check_notches(const Pattern& pattern, SeamCheck& check) {
  const std::vector<double> a = notches_on(pattern, check.a), b = notches_on(pattern, check.b);
  if (a.empty() || b.empty()) {
    check.lonely_notches = static_cast<int>(a.size() + b.size());
    return;
  }
  std::vector<bool> taken(b.size(), false);
  const double spread = std::abs(check.length_a - check.length_b);
  for (const double on_a : a) {
    std::size_t best = b.size();
    for (std::size_t k = 0; k < b.size(); ++k)
      if (!taken[k] && (best == b.size() || std::abs(b[k] - on_a) < std::abs(b[best] - on_a))) best = k;
    if (best == b.size() || std::abs(b[best] - on_a) > same_notch + spread) {
      ++check.lonely_notches;
      continue;
    }
    taken[best] = true;
    check.notches.push_back({on_a, b[best]});
    check.notch_mismatch = std::max(check.notch_mismatch, std::abs(b[best] - on_a) - check.ease);
  }
  check.lonely_notches += static_cast<int>(std::count(taken.begin(), taken.end(), false));
}

}  // namespace

std::vector<SeamCheck> check_seams(const Pattern& pattern, const std::map<std::string, double>& ease) {
  std::vector<SeamCheck> checks;
  for (const Seam& seam : pattern.seams) {
    SeamCheck check;
    check.seam = seam.name;
    check.a = seam.a;
    check.b = seam.b;
    check.length_a = span_length(pattern, seam.a);
    check.length_b = span_length(pattern, seam.b);
    if (const auto meant = ease.find(seam.name); meant != ease.end()) check.ease = meant->second;
    check.mismatch = std::max(0.0, std::abs(check.length_a - check.length_b) - check.ease);
    check_notches(pattern, check);
    checks.push_back(std::move(check));
  }
  return checks;
}

}  // namespace toile
