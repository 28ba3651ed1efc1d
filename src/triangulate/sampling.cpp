#include "triangulate/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "garment/report.h"
#include "geometry/polyline.h"
#include "geometry/self_crossing.h"
#include "triangulate/intervals.h"
#include "triangulate/outline.h"
#include "triangulate/seam_places.h"
#include "triangulate/stitching.h"

namespace toile {
namespace {

constexpr double gathered_ratio = 1.35;       // beyond it the longer side of a seam decides
constexpr double chord_loss = 1e-3;           // of the length, and
constexpr double chord_loss_at_least = 2e-4;  // m: what chords may cut off a curve
constexpr double finest = 4;                  // times as many vertices as edge_length asks for, at most, to follow a curve
constexpr int most_rounds = 12;

using Samples = std::vector<std::vector<OutlineSample>>;

const Edge& edge_of(const Pattern& pattern, const Interval& part) {
  return pattern.pieces[static_cast<std::size_t>(part.piece)].outline[static_cast<std::size_t>(part.edge)];
}

// Least number of equal parts whose chords keep the length of the curve.
int parts_to_follow(const Pattern& pattern, const Interval& part, double edge_length) {
  const Edge& edge = edge_of(pattern, part);
  if (is_straight(edge)) return 1;
  const Points<2> curve = part_of<2>(positions(edge), part.begin, part.end);
  const double allowed = std::max(chord_loss * part.length, chord_loss_at_least);
  const int most = std::max(1, static_cast<int>(std::ceil(finest * part.length / edge_length)));
  int n = 1;
  while (n < most && part.length - polyline_length<2>(resample<2>(curve, n)) > allowed) ++n;
  return n;
}

std::vector<int> first_counts(const Pattern& pattern, const std::vector<Interval>& parts, double edge_length) {
  int groups = 0;
  for (const Interval& part : parts) groups = std::max(groups, part.group + 1);
  struct Range {
    double least = 0, most = 0;
    int follow = 1;
  };
  std::vector<Range> ranges(static_cast<std::size_t>(groups));
  for (const Interval& part : parts) {
    Range& range = ranges[static_cast<std::size_t>(part.group)];
    range.least = range.least == 0 ? part.length : std::min(range.least, part.length);
    range.most = std::max(range.most, part.length);
    range.follow = std::max(range.follow, parts_to_follow(pattern, part, edge_length));
  }
  std::vector<int> counts;
  for (const Range& range : ranges) {
    const bool gathered = range.most > gathered_ratio * range.least;
    const double decisive = gathered ? range.most : std::sqrt(range.least * range.most);
    counts.push_back(std::max(range.follow, static_cast<int>(std::lround(decisive / edge_length))));
  }
  return counts;
}

Samples samples_of(const Pattern& pattern, const std::vector<Interval>& parts, const std::vector<int>& counts) {
  Samples samples(pattern.pieces.size());
  for (const Interval& part : parts) {
    const Points<2> curve = positions(edge_of(pattern, part));
    const int n = counts[static_cast<std::size_t>(part.group)];
    for (int i = 0; i < n; ++i) {
      const double at = part.begin + (part.end - part.begin) * i / n;
      samples[static_cast<std::size_t>(part.piece)].push_back({part.edge, at, point_at<2>(curve, at)});
    }
  }
  return samples;
}

int group_at(const std::vector<Interval>& parts, int piece, const OutlineSample& sample) {
  for (auto part = parts.rbegin(); part != parts.rend(); ++part)
    if (part->piece == piece && part->edge == sample.edge && part->begin <= sample.at + 1e-12) return part->group;
  return 0;
}

// Groups whose sides make a sampled outline cross itself: chords that cut a corner off.
std::set<int> crossing_groups(const std::vector<Interval>& parts, const Samples& samples, int& piece) {
  std::set<int> groups;
  for (std::size_t p = 0; p < samples.size(); ++p) {
    std::vector<Eigen::Vector2d> loop;
    double twice_area = 0;
    for (std::size_t i = 0; i < samples[p].size(); ++i) {
      const Eigen::Vector2d& a = samples[p][i].position;
      const Eigen::Vector2d& b = samples[p][(i + 1) % samples[p].size()].position;
      twice_area += a.x() * b.y() - a.y() * b.x();
      loop.push_back(a);
    }
    const auto crossing = loop.size() < 3 ? std::nullopt : first_self_crossing(loop);
    if (loop.size() >= 3 && twice_area > 0 && !crossing) continue;
    piece = static_cast<int>(p);
    for (std::size_t i = 0; i < samples[p].size(); ++i)
      if (!crossing || static_cast<int>(i) == crossing->first || static_cast<int>(i) == crossing->second)
        groups.insert(group_at(parts, piece, samples[p][i]));
  }
  return groups;
}

// Groups of sides that sewing would join by accident: their two ends meet each other, or the ends of a side that they are not
// sewn to (a ring needs three sides, two panels sewn all round more than one side between seams).
std::set<int> accidental_groups(const Pattern& pattern, const std::vector<Interval>& parts, const Samples& samples, int& seam) {
  std::vector<PanelLoop> panels;
  std::vector<int> first;
  int total = 0;
  for (std::size_t p = 0; p < samples.size(); ++p)
    for (int copy = 1; copy <= copies(pattern.pieces[p]); ++copy) {
      PanelLoop panel{static_cast<int>(p), copy, {}};
      first.push_back(total);
      for (const OutlineSample& sample : samples[p])
        panel.vertices.push_back({static_cast<int>(panel.vertices.size()), sample.edge, sample.at});
      total += static_cast<int>(samples[p].size());
      panels.push_back(std::move(panel));
    }
  const std::vector<Mating> mated_runs = matings(pattern, panels);
  const std::vector<int> root = welded_to(mated_runs, first, total);
  const auto side = [](int a, int b) { return std::pair(std::min(a, b), std::max(a, b)); };
  const MatedSides mates = mated_sides(mated_runs, first);
  std::vector<int> seam_at(static_cast<std::size_t>(total), -1);
  for (const Mating& mating : mated_runs) {
    for (const int v : mating.a)
      seam_at[static_cast<std::size_t>(first[static_cast<std::size_t>(mating.panel_a)] + v)] = mating.seam;
    for (const int v : mating.b)
      seam_at[static_cast<std::size_t>(first[static_cast<std::size_t>(mating.panel_b)] + v)] = mating.seam;
  }

  struct Side : WeldedSide {
    int group = 0;
  };
  std::map<std::pair<int, int>, std::vector<Side>> sides;
  for (std::size_t q = 0; q < panels.size(); ++q) {
    const auto& loop = samples[static_cast<std::size_t>(panels[q].piece)];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int from = first[q] + static_cast<int>(i), to = first[q] + static_cast<int>((i + 1) % loop.size());
      sides[side(root[static_cast<std::size_t>(from)], root[static_cast<std::size_t>(to)])].push_back(
          {{from, to, static_cast<int>(q), loop[i].edge}, group_at(parts, panels[q].piece, loop[i])});
    }
  }
  std::set<int> groups;
  for (const auto& [ends, alike] : sides) {
    if (ends.first != ends.second && sewn_together({alike.begin(), alike.end()}, mates)) continue;
    for (const Side& s : alike) {
      groups.insert(s.group);
      seam = std::max(seam, std::max(seam_at[static_cast<std::size_t>(s.from)], seam_at[static_cast<std::size_t>(s.to)]));
    }
  }
  return groups;
}

}  // namespace

Samples sample_outlines(const Pattern& pattern, double edge_length) {
  const std::vector<Interval> parts = intervals(pattern, seam_places(pattern));
  std::vector<int> counts = first_counts(pattern, parts, edge_length);
  for (int round = 0;; ++round) {
    Samples samples = samples_of(pattern, parts, counts);
    int piece = -1, seam = -1;
    const std::set<int> crossing = crossing_groups(parts, samples, piece);
    for (const int group : crossing) counts[static_cast<std::size_t>(group)] += counts[static_cast<std::size_t>(group)] / 2 + 1;
    const std::set<int> accidental = crossing.empty() ? accidental_groups(pattern, parts, samples, seam) : std::set<int>{};
    for (const int group : accidental) ++counts[static_cast<std::size_t>(group)];
    if (crossing.empty() && accidental.empty()) return samples;
    if (round < most_rounds) continue;
    if (piece >= 0)
      throw BadInput({"pattern.too-fine", Severity::error,
                      "piece '" + pattern.pieces[static_cast<std::size_t>(piece)].name + "'",
                      "parts of the outline lie too near to each other to be meshed", "Move them apart", Fault::bad_input});
    refuse_seam("seam.not-manifold", pattern.seams[static_cast<std::size_t>(std::max(seam, 0))],
                "with the other seams it would join edges along one line that are not sewn to each other",
                "Sew each edge only to those that it meets there");
  }
}

}  // namespace toile
