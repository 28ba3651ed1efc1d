#include "body/parametric_net.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "garment/units.h"

namespace toile {
namespace {

using Rows = std::vector<int>;  // indices of one row of points
const Eigen::Vector3d up = Eigen::Vector3d::UnitY(), front = Eigen::Vector3d::UnitZ();
constexpr int fine = 72;  // rays before a row is spaced evenly

Chain mixed(const Chain& a, const Chain& b, double share) {
  Chain result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] + share * (b[i] - a[i]));
  return result;
}

class Layout {
 public:
  Layout(const BodyForm& form, const Figure& figure, double edge, const Net* reference)
      : form_(form), figure_(figure), edge_(edge), reference_(reference) {}

  Net build() {
    find_armpit();
    lay_trunk();
    lay_shoulder();
    lay_head();
    lay_arm();
    lay_leg();
    return std::move(net_);
  }

 private:
  // Steps of one edge over `length`; on another body than the reference: as many as there.
  int steps(double length, int least = 1) { return decide(std::max(least, static_cast<int>(std::lround(length / edge_)))); }
  int decide(int own) {
    const int count = reference_ ? reference_->counts.at(net_.counts.size()) : own;
    net_.counts.push_back(count);
    return count;
  }

  Rows add(const Chain& chain) {
    Rows row(chain.size());
    std::iota(row.begin(), row.end(), static_cast<int>(net_.points.size()));
    net_.points.insert(net_.points.end(), chain.begin(), chain.end());
    return row;
  }
  const Eigen::Vector3d& point(int i) const { return net_.points[static_cast<std::size_t>(i)]; }
  Chain chain_of(const Rows& row) const {
    Chain chain;
    for (const int i : row) chain.push_back(point(i));
    return chain;
  }
  Rows add_half_ring(const Chain& chain) { return add(resampled(chain, steps(length(chain), 3) + 1)); }
  Rows add_ring(const Chain& chain) {
    return add(resampled_ring(chain, steps(length(chain) + (chain.front() - chain.back()).norm(), 6)));
  }

  // Triangles between two rows that run alike; `upper` lies further along the direction rows turn about.
  void bridge(const Rows& lower, const Rows& upper) {
    if (reference_) return;
    const auto shares = [&](const Rows& row) {
      std::vector<double> share = {0};
      for (std::size_t i = 1; i < row.size(); ++i) share.push_back(share.back() + (point(row[i]) - point(row[i - 1])).norm());
      for (double& s : share) s /= share.back();
      return share;
    };
    const std::vector<double> low = shares(lower), high = shares(upper);
    const auto add_triangle = [&](int a, int b, int c) {
      if (a != b && b != c && c != a) net_.triangles.push_back({a, b, c});
    };
    for (std::size_t i = 0, j = 0; i + 1 < lower.size() || j + 1 < upper.size();) {
      const bool step_low =
          j + 1 == upper.size() || (i + 1 < lower.size() && low[i] + low[i + 1] <= high[j] + high[j + 1] + 1e-9);
      if (step_low)
        add_triangle(lower[i], lower[i + 1], upper[j]), ++i;
      else
        add_triangle(lower[i], upper[j + 1], upper[j]), ++j;
    }
  }
  void bridge_rings(Rows lower, Rows upper) {
    lower.push_back(lower.front()), upper.push_back(upper.front());
    bridge(lower, upper);
  }
  // Sews a narrow ring shut, its two flanks together; `along` is where its outside looks.
  void fold(const Rows& ring, const Eigen::Vector3d& long_axis, bool downwards) {
    if (reference_) return;
    const auto reach = [&](int a, int b) { return long_axis.dot(point(a)) < long_axis.dot(point(b)); };
    const auto [least, most] = std::minmax_element(ring.begin(), ring.end(), reach);
    Rows there, back;
    for (auto i = most; i != least; i = i + 1 == ring.end() ? ring.begin() : i + 1) there.push_back(*i);
    for (auto i = most; i != least; i = i == ring.begin() ? ring.end() - 1 : i - 1) back.push_back(*i);
    there.push_back(*least), back.push_back(*least);
    downwards ? bridge(back, there) : bridge(there, back);
  }

  Eigen::Vector3d trunk_centre(double y) const {
    const Section s = form_.trunk().section(y);
    return {0, y, s.centre_v + (s.front - s.back) / 2};
  }
  Chain trunk_half_ring(double y) const { return half_ring(form_, trunk_centre(y), front, up, fine); }

  void find_armpit() {
    const double z = figure_.shoulder.z();
    double free = figure_.levels.at("bust"), grown = figure_.levels.at("shoulder");
    for (int i = 0; i < 16; ++i) {
      const double y = (free + grown) / 2, x = way_out(form_, {0, y, z}, Eigen::Vector3d::UnitX()).x();
      (x < form_.trunk().section(y).half_width + .02 ? free : grown) = y;
    }
    armpit_ = free;
  }

  struct Corners {
    double fore = 0, aft = 0;
  };
  // Front and back corner of the armhole's lower edge, as shares of the half ring's length.
  Corners armhole_corners(const Chain& half) const {
    const auto widest = std::max_element(half.begin(), half.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
    const double whole = length(half), at = length(Chain(half.begin(), widest + 1)), reach = .021 * figure_.height;
    return {(at - reach) / whole, (at + reach) / whole};
  }
  // Moves shares of a row so that `from` comes to `to`.
  static double gathered(double share, const Corners& from, const Corners& to) {
    if (share < from.fore) return share / from.fore * to.fore;
    if (share > from.aft) return 1 - (1 - share) / (1 - from.aft) * (1 - to.aft);
    return to.fore + (share - from.fore) / (from.aft - from.fore) * (to.aft - to.fore);
  }

  void lay_trunk() {
    const auto& y = figure_.levels;
    const double split = armpit_ - .004;
    const double levels[] = {y.at("crotch") + .012,
                             y.at("hip"),
                             y.at("high_hip"),
                             y.at("waist"),
                             y.at("underbust"),
                             std::min(y.at("bust"), split - .02),
                             split};
    Rows below;
    const Corners corners = armhole_corners(trunk_half_ring(split));
    // Where the corners are on the reference body, by share of the row.
    Corners own{decide(static_cast<int>(std::lround(1000 * corners.fore))) / 1000.0, 0};
    own.aft = decide(static_cast<int>(std::lround(1000 * corners.aft))) / 1000.0;
    for (std::size_t k = 0; k + 1 < std::size(levels); ++k) {
      const int rows = steps(levels[k + 1] - levels[k]);
      const bool last = k + 2 == std::size(levels);
      for (int i = k == 0 ? 0 : 1; i <= rows; ++i) {
        const double share = static_cast<double>(i) / rows;
        const Chain chain = trunk_half_ring(levels[k] + share * (levels[k + 1] - levels[k]));
        const int count = steps(length(chain), 8);
        if (last && i == rows) {  // the armhole's corners are points of their own
          fore_ = decide(std::max(2, static_cast<int>(std::lround(own.fore * count))));
          aft_ = decide(std::min(count - 2, static_cast<int>(std::lround(own.aft * count))));
          own = {static_cast<double>(fore_) / count, static_cast<double>(aft_) / count};
        }
        std::vector<double> shares;
        for (int p = 0; p <= count; ++p) {
          const double even = static_cast<double>(p) / count;
          shares.push_back(last ? (1 - share) * even + share * gathered(even, own, corners) : even);
        }
        Chain points = at_shares(chain, shares);
        points.front() = chain.front(), points.back() = chain.back();
        const Rows row = add(points);
        if (below.empty())
          seat_ = row;
        else
          bridge(below, row);
        below = row;
      }
    }
    lay_armhole(below, split);
  }

  // A row of the front (side 1) or back (side -1) from the midplane to the armhole at height y.
  Chain flank(double y, double x_end, double side) const {
    Chain chain;
    constexpr int casts = 24;
    for (int i = 0; i <= casts; ++i) {
      const double share = static_cast<double>(i) / casts, x = share * x_end;
      const double z = trunk_centre(y).z() + share * (figure_.shoulder.z() - trunk_centre(y).z());
      chain.push_back(way_out(form_, {x, y, z}, side * front));
    }
    return chain;
  }

  void lay_armhole(const Rows& split_row, double split) {
    Rows fore_row(split_row.begin(), split_row.begin() + fore_ + 1), aft_row(split_row.begin() + aft_, split_row.end());
    const Rows bottom(split_row.begin() + fore_, split_row.begin() + aft_ + 1);
    const double outer = figure_.shoulder.x() + .010 * figure_.height;
    const double ridge = way_out(form_, {outer, figure_.shoulder.y(), figure_.shoulder.z()}, up).y();
    const double top = ridge - .015 * figure_.height;
    const int rows = steps(top - split, 2);
    Rows fore_edge, aft_edge;
    for (int i = 1; i <= rows; ++i) {
      const double share = static_cast<double>(i) / rows, y = split + share * (top - split);
      const double x_fore = point(bottom.front()).x() + share * (outer - point(bottom.front()).x());
      const double x_aft = point(bottom.back()).x() + share * (outer - point(bottom.back()).x());
      const Rows fore_next = add_half_ring(flank(y, x_fore, 1));
      Chain back = flank(y, x_aft, -1);
      std::reverse(back.begin(), back.end());
      const Rows aft_next = add_half_ring(back);
      bridge(fore_row, fore_next), bridge(aft_row, aft_next);
      fore_edge.push_back(fore_next.back()), aft_edge.push_back(aft_next.front());
      fore_row = fore_next, aft_row = aft_next;
    }
    // Over the shoulder, from the front edge to the back edge.
    const Chain arc = half_turn(fore_row.back(), aft_row.front());
    Chain inner = resampled(arc, steps(length(arc), 2) + 1);
    const Rows over = add(Chain(inner.begin() + 1, inner.end() - 1));
    shoulder_ = fore_row;
    shoulder_.insert(shoulder_.end(), over.begin(), over.end());
    shoulder_.insert(shoulder_.end(), aft_row.begin(), aft_row.end());
    armhole_ = bottom;
    armhole_.insert(armhole_.end(), aft_edge.begin(), aft_edge.end());
    armhole_.insert(armhole_.end(), over.rbegin(), over.rend());
    armhole_.insert(armhole_.end(), fore_edge.rbegin(), fore_edge.rend());
  }
  Chain half_turn(int from, int to) const {
    const Eigen::Vector3d a = point(from), b = point(to), centre = (a + b) / 2;
    const Eigen::Vector3d start = (a - centre).normalized();
    const Eigen::Vector3d rise = (up - up.dot(start) * start).normalized();
    Chain arc = half_ring_about(centre, start, rise);
    arc.front() = a, arc.back() = b;
    return arc;
  }
  Chain half_ring_about(const Eigen::Vector3d& centre, const Eigen::Vector3d& start, const Eigen::Vector3d& rise) const {
    Chain arc;
    for (int i = 0; i <= fine; ++i) {
      const double angle = 180 * degree * i / fine;
      arc.push_back(way_out(form_, centre, std::cos(angle) * start + std::sin(angle) * rise));
    }
    return arc;
  }

  void lay_shoulder() {
    const double tilt = 16 * degree;
    const Eigen::Vector3d along(0, std::cos(tilt), std::sin(tilt));
    const Chain neck = half_ring(form_, trunk_centre(.862 * figure_.height), front, along, fine);
    Rows below = shoulder_;
    const Chain from = resampled(chain_of(shoulder_), fine), to = resampled(neck, fine);
    double apart = 0;
    for (std::size_t i = 0; i < from.size(); ++i) apart += (to[i] - from[i]).norm() / fine;
    const int rows = steps(apart, 2);
    for (int i = 1; i <= rows; ++i) {
      Chain row = mixed(from, to, static_cast<double>(i) / rows);
      if (i < rows)
        for (Eigen::Vector3d& p : row) p = form_.projected(p, 8);
      const Rows next = add_half_ring(row);
      bridge(below, next);
      below = next;
    }
    neck_ = below;
  }

  void lay_head() {
    const double tall = figure_.height;
    const double from = .862 * tall, to = .975 * tall;
    const int rows = steps(1.25 * (to - from), 4);
    Rows below = neck_;
    Eigen::Vector3d centre;
    Chain row;
    for (int i = 1; i <= rows; ++i) {
      const double share = static_cast<double>(i) / rows;
      const double tilt = 16 * degree * (1 - share);
      const double settle = std::min(1.0, share / .45);
      const double z = (1 - settle) * trunk_centre(from).z() + settle * figure_.head_joint.z();
      centre = {0, from + share * (to - from), z};
      row = half_ring(form_, centre, front, {0, std::cos(tilt), std::sin(tilt)}, fine);
      const Rows next = add_half_ring(row);
      bridge(below, next);
      below = next;
    }
    // The crown: rows shrinking to a pole.
    const Eigen::Vector3d pole = way_out(form_, centre, up);
    const int rings = steps(1.15 * length(row) / 3.14, 2);
    for (int i = 1; i < rings; ++i) {
      Chain inner;
      for (const Eigen::Vector3d& p : row) {
        const double share = static_cast<double>(i) / rings;
        const Eigen::Vector3d aim = p + share * (pole - p) - centre;
        inner.push_back(way_out(form_, centre, aim.normalized()));
      }
      inner.front().x() = 0, inner.back().x() = 0;
      const Rows next = add_half_ring(inner);
      bridge(below, next);
      below = next;
    }
    bridge(below, add({pole}));
  }

  void lay_tube(Rows& below, const Chain& next_chain, bool downwards) {
    const Rows next = add_ring(next_chain);
    downwards ? bridge_rings(next, below) : bridge_rings(below, next);
    below = next;
  }
  // Rows between a ring that is there and the surface ring `to`, projected, `to` itself included.
  void lay_between(Rows& below, const Chain& to, bool downwards) {
    const Chain a = resampled_ring(chain_of(below), fine), b = resampled_ring(to, fine);
    double apart = 0;
    for (std::size_t i = 0; i < a.size(); ++i) apart += (b[i] - a[i]).norm() / fine;
    const int rows = steps(apart);
    for (int i = 1; i <= rows; ++i) {
      Chain row = mixed(a, b, static_cast<double>(i) / rows);
      if (i < rows)
        for (Eigen::Vector3d& p : row) p = form_.projected(p, 8);
      lay_tube(below, row, downwards);
    }
  }

  void lay_arm() {
    const Loft& arm = form_.arm();
    const Eigen::Vector3d along = arm.frame().along;
    const Eigen::Vector3d start = point(armhole_.front()) - figure_.shoulder;
    // The first ring round the arm alone: where its plane leaves the armpit by a hand's breadth of triangles.
    const Eigen::Vector3d pit = way_out(form_, {0, armpit_, figure_.shoulder.z()}, Eigen::Vector3d::UnitX());
    const double first = std::max(along.dot(pit - arm.frame().origin), .02) + .022;
    const double length_to_tip = arm.end() - first, last = arm.end() - .026 * figure_.height;
    Rows below = armhole_;
    lay_between(below, ring(form_, arm.centre(first), start, along, fine), false);
    const int rows = steps(length_to_tip, 4);
    for (int i = 1; i <= rows; ++i)
      lay_tube(below, ring(form_, arm.centre(first + (last - first) * i / rows), start, along, fine), false);
    // Finger tips: rays that lean more and more along the arm, then the rest sewn shut.
    const Chain rim = chain_of(below);
    const Eigen::Vector3d centre = arm.centre(last);
    const int rings = steps(.026 * figure_.height, 2);
    for (int i = 1; i <= rings; ++i) {
      const double lean = 74 * degree * i / rings;
      Chain inner;
      for (const Eigen::Vector3d& p : rim)
        inner.push_back(way_out(form_, centre, std::cos(lean) * (p - centre).normalized() + std::sin(lean) * along));
      lay_tube(below, inner, false);
    }
    const int tip = add({way_out(form_, centre, along)}).front();
    for (std::size_t i = 0; i < below.size() && !reference_; ++i)
      net_.triangles.push_back({below[i], below[(i + 1) % below.size()], tip});
  }

  void lay_leg() {
    const auto& y = figure_.levels;
    // Through the crotch, from centre back to centre front.
    const Eigen::Vector3d fore = point(seat_.front()), aft = point(seat_.back());
    Chain under;
    constexpr int casts = 32;
    for (int i = 0; i <= casts; ++i) {
      const double share = static_cast<double>(i) / casts;
      const Eigen::Vector3d from = aft + share * (fore - aft);
      under.push_back(i == 0 || i == casts ? from : way_out(form_, from, -up));
    }
    const Chain line = resampled(under, steps(length(under), 3) + 1);
    Rows below = seat_;
    const Rows crotch = add(Chain(line.begin() + 1, line.end() - 1));
    below.insert(below.end(), crotch.begin(), crotch.end());
    const Loft& leg = form_.leg();
    const double levels[] = {y.at("crotch") - .022, y.at("mid_thigh"), y.at("knee"), y.at("calf"), y.at("ankle")};
    const Eigen::Vector3d start = fore - leg.centre(levels[0]);
    const auto round_leg = [&](double height) { return ring(form_, leg.centre(height), start, up, fine); };
    lay_between(below, round_leg(levels[0]), true);
    for (std::size_t k = 0; k + 1 < std::size(levels); ++k) {
      const int rows = steps(levels[k] - levels[k + 1]);
      for (int i = 1; i <= rows; ++i) lay_tube(below, round_leg(levels[k] + (levels[k + 1] - levels[k]) * i / rows), true);
    }
    lay_foot(below, start);
  }

  // The leg's tube bends forward into the foot: planes swing about a line above the instep until they stand upright, then walk
  // to the toes.
  void lay_foot(Rows below, const Eigen::Vector3d& start) {
    const Loft& foot = form_.foot();
    const Eigen::Vector3d forward = foot.frame().along, aside = foot.frame().u;
    const double tall = figure_.height, ankle = figure_.levels.at("ankle");
    const Eigen::Vector3d ankle_centre = form_.leg().centre(ankle);
    const double reach = .045 * tall;
    const Eigen::Vector3d pivot = ankle_centre + reach * forward;
    const Chain heel = half_fan(pivot, forward);
    const int swings = steps(.75 * length(heel), 5);
    const double deep = pivot.y() - .022 * tall;
    for (int i = 1; i <= swings; ++i) {
      const double share = static_cast<double>(i) / swings;
      const Eigen::AngleAxisd swing(-90 * degree * share, aside);
      const Eigen::Vector3d centre = pivot + swing * (-(reach + share * (deep - reach)) * forward);
      lay_tube(below, ring(form_, centre, swing * start, swing * up, 2 * fine), true);
    }
    const Eigen::AngleAxisd upright(-90 * degree, aside);
    const double from = forward.dot(pivot - foot.frame().origin), to = foot.end() - .008 * tall;
    const auto centre_at = [&](double at) {
      Eigen::Vector3d centre = foot.frame().origin + at * forward;
      centre.y() = .4 * way_out(form_, {centre.x(), .004, centre.z()}, up).y();
      return centre;
    };
    const int rows = steps(to - from, 2);
    for (int i = 1; i <= rows; ++i)
      lay_tube(below, ring(form_, centre_at(from + (to - from) * i / rows), upright * start, upright * up, fine), true);
    const Eigen::Vector3d centre = centre_at(to);
    Chain inner;
    for (const Eigen::Vector3d& p : chain_of(below))
      inner.push_back(form_.projected(centre + .55 * (p - centre) + .006 * forward, 8));
    lay_tube(below, inner, true);
    fold(below, aside, true);
  }
  // Round the heel in the plane of the foot.
  Chain half_fan(const Eigen::Vector3d& pivot, const Eigen::Vector3d& forward) const {
    Chain fan;
    for (int i = 0; i <= fine; ++i) {
      const double angle = 90 * degree * i / fine;
      fan.push_back(pivot - .09 * figure_.height * (std::cos(angle) * forward + std::sin(angle) * up));
    }
    return fan;
  }

  const BodyForm& form_;
  const Figure& figure_;
  double edge_;
  const Net* reference_;
  Net net_;
  double armpit_ = 0;
  int fore_ = 0, aft_ = 0;  // points of the split row at the armhole's corners
  Rows seat_, shoulder_, armhole_, neck_;
};

}  // namespace

Net lay_out_net(const BodyForm& form, const Figure& figure, double edge_length) {
  return Layout(form, figure, edge_length, nullptr).build();
}

Chain laid_out_like(const Net& reference, const BodyForm& form, const Figure& figure) {
  return Layout(form, figure, 1, &reference).build().points;
}

}  // namespace toile
