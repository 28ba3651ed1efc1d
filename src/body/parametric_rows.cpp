#include "body/parametric_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toile {

Chain mixed(const Chain& a, const Chain& b, double share) {
  Chain result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] + share * (b[i] - a[i]));
  return result;
}

double apart(const Chain& a, const Chain& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (b[i] - a[i]).norm();
  return sum / static_cast<double>(a.size());
}

Eigen::Vector3d trunk_centre(const BodyForm& form, double y) {
  const Section s = form.trunk().section(y);
  return {0, y, s.centre_v + (s.front - s.back) / 2};
}

int RowNet::decide(int own) {
  const int count = reference_ ? reference_->counts.at(net_.counts.size()) : own;
  net_.counts.push_back(count);
  return count;
}

int RowNet::steps(double length, int least) { return decide(std::max(least, static_cast<int>(std::lround(length / edge_)))); }

Row RowNet::add(const Chain& chain) {
  Row row(chain.size());
  std::iota(row.begin(), row.end(), static_cast<int>(net_.points.size()));
  net_.points.insert(net_.points.end(), chain.begin(), chain.end());
  return row;
}

Row RowNet::add_half_ring(const Chain& chain) { return add(resampled(chain, steps(length(chain), 3) + 1)); }

Row RowNet::add_ring(const Chain& chain) {
  return add(resampled_ring(chain, steps(length(chain) + (chain.front() - chain.back()).norm(), 6)));
}

Chain RowNet::chain(const Row& row) const {
  Chain points;
  for (const int i : row) points.push_back(point(i));
  return points;
}

void RowNet::bridge(const Row& lower, const Row& upper) {
  if (reference_) return;
  const auto shares = [&](const Row& row) {
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

void RowNet::bridge_rings(Row lower, Row upper) {
  lower.push_back(lower.front()), upper.push_back(upper.front());
  bridge(lower, upper);
}

void RowNet::gather(Row row, int tip, bool ring) {
  if (reference_) return;
  if (ring) row.push_back(row.front());
  for (std::size_t i = 0; i + 1 < row.size(); ++i) net_.triangles.push_back({row[i], row[i + 1], tip});
}

void RowNet::fold(const Row& ring, const Eigen::Vector3d& long_axis, bool downwards) {
  if (reference_) return;
  const auto reach = [&](int a, int b) { return long_axis.dot(point(a)) < long_axis.dot(point(b)); };
  const auto [least, most] = std::minmax_element(ring.begin(), ring.end(), reach);
  Row there, back;
  for (auto i = most; i != least; i = i + 1 == ring.end() ? ring.begin() : i + 1) there.push_back(*i);
  for (auto i = most; i != least; i = i == ring.begin() ? ring.end() - 1 : i - 1) back.push_back(*i);
  there.push_back(*least), back.push_back(*least);
  downwards ? bridge(back, there) : bridge(there, back);
}

void RowNet::lay_tube(Row& last, const Chain& next_chain, bool downwards) {
  const Row next = add_ring(next_chain);
  downwards ? bridge_rings(next, last) : bridge_rings(last, next);
  last = next;
}

void RowNet::lay_between(const BodyForm& form, Row& last, const Chain& to, bool downwards) {
  const Chain a = resampled_ring(chain(last), fine_rays), b = resampled_ring(to, fine_rays);
  const int rows = steps(apart(a, b));
  for (int i = 1; i <= rows; ++i) {
    Chain row = mixed(a, b, static_cast<double>(i) / rows);
    if (i < rows)
      for (Eigen::Vector3d& p : row) p = form.projected(p, 8);
    lay_tube(last, row, downwards);
  }
}

}  // namespace toile
