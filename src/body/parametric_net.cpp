#include "body/parametric_net.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "body/parametric_rows.h"
#include "garment/units.h"

namespace toile {
namespace {

const Eigen::Vector3d up = Eigen::Vector3d::UnitY(), front = Eigen::Vector3d::UnitZ();

// Front and back corner of the armhole's lower edge, as shares of a half ring's length.
struct Corners {
  double fore = 0, aft = 0;
};

Corners armhole_corners(const Chain& half, double height) {
  const auto widest = std::max_element(half.begin(), half.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  const double whole = length(half), at = length(Chain(half.begin(), widest + 1)), reach = .021 * height;
  return {(at - reach) / whole, (at + reach) / whole};
}

// Moves shares of a row so that `from` comes to `to`.
double gathered(double share, const Corners& from, const Corners& to) {
  if (share < from.fore) return share / from.fore * to.fore;
  if (share > from.aft) return 1 - (1 - share) / (1 - from.aft) * (1 - to.aft);
  return to.fore + (share - from.fore) / (from.aft - from.fore) * (to.aft - to.fore);
}

Chain trunk_half_ring(const BodyForm& form, double y) { return half_ring(form, trunk_centre(form, y), front, up, fine_rays); }

double armpit_height(const BodyForm& form, const Figure& figure) {
  const double z = figure.shoulder.z();
  double free = figure.levels.at("bust"), grown = figure.levels.at("shoulder");
  for (int i = 0; i < 16; ++i) {
    const double y = (free + grown) / 2, x = way_out(form, {0, y, z}, Eigen::Vector3d::UnitX()).x();
    (x < form.trunk().section(y).half_width + .02 ? free : grown) = y;
  }
  return free;
}

// The trunk's uppermost whole row, and which of its points are the armhole's corners.
struct SplitRow {
  Row row;
  double height = 0;
  int fore = 0, aft = 0;
};

// Half rings from the crotch to just below the armpits; towards the armholes the points gather so that two of them come to
// lie on their corners.
SplitRow lay_whole_rows(RowNet& net, const BodyForm& form, const Figure& figure, TrunkRows& trunk) {
  const auto& y = figure.levels;
  SplitRow split;
  split.height = trunk.armpit - .004;
  const double bust = std::min(y.at("bust"), split.height - .02);
  const double levels[] = {y.at("crotch") + .012, y.at("hip"), y.at("high_hip"), y.at("waist"),
                           y.at("underbust"),     bust,        split.height};
  const Corners corners = armhole_corners(trunk_half_ring(form, split.height), figure.height);
  // Where the corners are on the reference body, by share of the row.
  Corners own{net.decide(static_cast<int>(std::lround(1000 * corners.fore))) / 1000.0, 0};
  own.aft = net.decide(static_cast<int>(std::lround(1000 * corners.aft))) / 1000.0;
  for (std::size_t k = 0; k + 1 < std::size(levels); ++k) {
    const int rows = net.steps(levels[k + 1] - levels[k]);
    const bool last = k + 2 == std::size(levels);
    for (int i = k == 0 ? 0 : 1; i <= rows; ++i) {
      const double share = static_cast<double>(i) / rows;
      const Chain chain = trunk_half_ring(form, levels[k] + share * (levels[k + 1] - levels[k]));
      const int count = net.steps(length(chain), 8);
      if (last && i == rows) {
        split.fore = net.decide(std::max(2, static_cast<int>(std::lround(own.fore * count))));
        split.aft = net.decide(std::min(count - 2, static_cast<int>(std::lround(own.aft * count))));
        own = {static_cast<double>(split.fore) / count, static_cast<double>(split.aft) / count};
      }
      std::vector<double> shares;
      for (int p = 0; p <= count; ++p) {
        const double even = static_cast<double>(p) / count;
        shares.push_back(last ? (1 - share) * even + share * gathered(even, own, corners) : even);
      }
      Chain points = at_shares(chain, shares);
      points.front() = chain.front(), points.back() = chain.back();
      const Row row = net.add(points);
      if (split.row.empty())
        trunk.seat = row;
      else
        net.bridge(split.row, row);
      split.row = row;
    }
  }
  return split;
}

// A row of the front (side 1) or back (side -1) at height y, from the midplane to x_end.
Chain flank(const BodyForm& form, const Figure& figure, double y, double x_end, double side) {
  constexpr int casts = 24;
  const double middle = trunk_centre(form, y).z();
  Chain chain;
  for (int i = 0; i <= casts; ++i) {
    const double share = static_cast<double>(i) / casts;
    chain.push_back(way_out(form, {share * x_end, y, middle + share * (figure.shoulder.z() - middle)}, side * front));
  }
  return chain;
}

// Over the shoulder from `from` to `to`.
Chain half_turn(const BodyForm& form, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d centre = (from + to) / 2, start = (from - centre).normalized();
  const Eigen::Vector3d rise = (up - up.dot(start) * start).normalized();
  Chain arc;
  for (int i = 0; i <= fine_rays; ++i) {
    const double angle = 180 * degree * i / fine_rays;
    arc.push_back(way_out(form, centre, std::cos(angle) * start + std::sin(angle) * rise));
  }
  arc.front() = from, arc.back() = to;
  return arc;
}

// Front and back rows beside the armholes up to the shoulder point; returns the row that goes over it.
Row lay_armhole(RowNet& net, const BodyForm& form, const Figure& figure, const SplitRow& split, TrunkRows& trunk) {
  Row fore(split.row.begin(), split.row.begin() + split.fore + 1), aft(split.row.begin() + split.aft, split.row.end());
  const Row bottom(split.row.begin() + split.fore, split.row.begin() + split.aft + 1);
  const double outer = figure.shoulder.x() + .010 * figure.height;
  const double ridge = way_out(form, {outer, figure.shoulder.y(), figure.shoulder.z()}, up).y();
  const double top = ridge - .015 * figure.height;
  const double x_fore = net.point(bottom.front()).x(), x_aft = net.point(bottom.back()).x();
  const int rows = net.steps(top - split.height, 2);
  Row fore_edge, aft_edge;
  for (int i = 1; i <= rows; ++i) {
    const double share = static_cast<double>(i) / rows, y = split.height + share * (top - split.height);
    const Row fore_next = net.add_half_ring(flank(form, figure, y, x_fore + share * (outer - x_fore), 1));
    Chain back = flank(form, figure, y, x_aft + share * (outer - x_aft), -1);
    std::reverse(back.begin(), back.end());
    const Row aft_next = net.add_half_ring(back);
    net.bridge(fore, fore_next), net.bridge(aft, aft_next);
    fore_edge.push_back(fore_next.back()), aft_edge.push_back(aft_next.front());
    fore = fore_next, aft = aft_next;
  }
  const Chain arc = half_turn(form, net.point(fore.back()), net.point(aft.front()));
  const Chain even = resampled(arc, net.steps(length(arc), 2) + 1);
  const Row over = net.add(Chain(even.begin() + 1, even.end() - 1));
  trunk.armhole = bottom;
  trunk.armhole.insert(trunk.armhole.end(), aft_edge.begin(), aft_edge.end());
  trunk.armhole.insert(trunk.armhole.end(), over.rbegin(), over.rend());
  trunk.armhole.insert(trunk.armhole.end(), fore_edge.rbegin(), fore_edge.rend());
  Row shoulder = fore;
  shoulder.insert(shoulder.end(), over.begin(), over.end());
  shoulder.insert(shoulder.end(), aft.begin(), aft.end());
  return shoulder;
}

// From the row over the shoulders to the foot of the neck.
Row lay_shoulder(RowNet& net, const BodyForm& form, const Figure& figure, Row below) {
  const double tilt = 16 * degree;
  const Eigen::Vector3d along(0, std::cos(tilt), std::sin(tilt));
  const Chain neck = half_ring(form, trunk_centre(form, .862 * figure.height), front, along, fine_rays);
  const Chain from = resampled(net.chain(below), fine_rays), to = resampled(neck, fine_rays);
  const int rows = net.steps(apart(from, to), 2);
  for (int i = 1; i <= rows; ++i) {
    Chain row = mixed(from, to, static_cast<double>(i) / rows);
    if (i < rows)
      for (Eigen::Vector3d& p : row) p = form.projected(p, 8);
    const Row next = net.add_half_ring(row);
    net.bridge(below, next);
    below = next;
  }
  return below;
}

Net laid_out(RowNet net, const BodyForm& form, const Figure& figure) {
  const TrunkRows trunk = lay_trunk(net, form, figure);
  lay_head(net, form, figure, trunk.neck);
  lay_arm(net, form, figure, trunk);
  lay_leg(net, form, figure, trunk.seat);
  return net.take();
}

}  // namespace

TrunkRows lay_trunk(RowNet& net, const BodyForm& form, const Figure& figure) {
  TrunkRows trunk;
  trunk.armpit = armpit_height(form, figure);
  const SplitRow split = lay_whole_rows(net, form, figure, trunk);
  trunk.neck = lay_shoulder(net, form, figure, lay_armhole(net, form, figure, split, trunk));
  return trunk;
}

Net lay_out_net(const BodyForm& form, const Figure& figure, double edge_length) {
  return laid_out(RowNet(edge_length), form, figure);
}

Chain laid_out_like(const Net& reference, const BodyForm& form, const Figure& figure) {
  return laid_out(RowNet(0, &reference), form, figure).points;
}

}  // namespace toile
