#include "drafting.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "cut/cut.h"
#include "formats/formats.h"

namespace toile::drafting {

using Eigen::Vector2d;

Measures measures_of(const SizeChartRow& row) {
  const auto other = [&](const char* name) {
    const auto found = row.others.find(name);
    if (found == row.others.end())
      throw BadInput({"draft.no-measure", Severity::error, row.chart + " " + row.size,
                      "the row has no '" + std::string(name) + "'",
                      "The samples are drafted from height, bust, waist, hip, upper_arm, wrist and thigh"});
    return found->second;
  };
  return {row.height, row.bust, row.waist, row.hip, other("upper_arm"), other("wrist"), other("thigh")};
}

Line curve(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d, int steps) {
  Line points;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const double s = 1 - t;
    points.push_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
  }
  return points;
}

Line through(const Line& points, int steps) {
  Line line{points.front()};
  const auto slope = [&](std::size_t k) -> Vector2d {
    if (k == 0) return (points[1] - points[0]) / (points[1] - points[0]).norm();
    if (k + 1 == points.size()) return (points[k] - points[k - 1]) / (points[k] - points[k - 1]).norm();
    const double before = (points[k] - points[k - 1]).norm();
    const double after = (points[k + 1] - points[k]).norm();
    return (points[k] - points[k - 1]) / before * (after / (before + after)) +
           (points[k + 1] - points[k]) / after * (before / (before + after));
  };
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double third = (points[k + 1] - points[k]).norm() / 3;
    line = joined(line,
                  curve(points[k], points[k] + third * slope(k), points[k + 1] - third * slope(k + 1), points[k + 1], steps));
  }
  return line;
}

Line reversed(Line line) {
  std::reverse(line.begin(), line.end());
  return line;
}

Line mirrored(Line line) {
  for (Vector2d& p : line) p.x() = -p.x();
  return line;
}

Line shifted(Line line, const Vector2d& by) {
  for (Vector2d& p : line) p += by;
  return line;
}

Line joined(Line first, const Line& second) {
  first.insert(first.end(), second.begin() + 1, second.end());
  return first;
}

double length(const Line& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.size(); ++k) sum += (line[k] - line[k - 1]).norm();
  return sum;
}

double share_at(const Line& line, double distance) { return distance / length(line); }

double solve(double low, double high, const std::function<double(double)>& f) {
  const bool rises = f(low) < 0;
  if (rises == (f(high) < 0)) throw std::invalid_argument("solve: no value in this range does it");
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    ((f(middle) < 0) == rises ? low : high) = middle;
  }
  return (low + high) / 2;
}

Piece piece(const std::string& name, const std::vector<Draft>& outline) {
  Piece out;
  out.name = name;
  out.material = "SHELL";
  for (const Draft& draft : outline) {
    Edge edge{draft.id, {}, draft.allowance, draft.hem};
    for (std::size_t k = 0; k < draft.line.size(); ++k)
      edge.points.push_back({draft.line[k], k == 0 || k + 1 == draft.line.size(), {}});
    out.outline.push_back(edge);
    for (const double at : draft.notches) out.notches.push_back({draft.id, at, NotchKind::slit, 4e-3, 0});
  }
  return out;
}

std::vector<Draft> whole(const std::vector<Draft>& half, const std::string& right, const std::string& left) {
  const auto image = [](Draft draft) {
    draft.line = mirrored(reversed(draft.line));
    for (double& at : draft.notches) at = 1 - at;
    return draft;
  };
  const auto both = [&](const Draft& first, const Draft& second) {
    Draft out = first;
    const double share = length(first.line) / (length(first.line) + length(second.line));
    out.line = joined(first.line, second.line);
    out.notches.clear();
    for (const double at : first.notches) out.notches.push_back(at * share);
    for (const double at : second.notches) out.notches.push_back(share + at * (1 - share));
    return out;
  };
  std::vector<Draft> out{both(image(half.front()), half.front())};
  for (std::size_t k = 1; k + 1 < half.size(); ++k) {
    out.push_back(half[k]);
    out.back().id += right;
  }
  out.push_back(both(half.back(), image(half.back())));
  for (std::size_t k = half.size() - 2; k > 0; --k) {
    out.push_back(image(half[k]));
    out.back().id += left;
  }
  return out;
}

int draft_program(int count, char** arguments, const std::string& name, const std::string& style,
                  const std::function<std::vector<Piece>(const Measures&)>& pieces) {
  if (count < 2 || count > 3) {
    std::fprintf(stderr, "usage: draft_%s FOLDER [SIZE]\n", name.c_str());
    return 64;
  }
  try {
    Pattern pattern;
    pattern.name = name;
    pattern.style = style;
    pattern.sample_size = count == 3 ? arguments[2] : "38";
    pattern.pieces = pieces(measures_of(value_or_throw(read_size_chart_row(TOILE_WOMEN_CHART, pattern.sample_size))));
    write_dxf_aama(std::filesystem::path(arguments[1]) / (name + ".dxf"), lay_out(pattern));
  } catch (const std::exception& trouble) {
    std::fprintf(stderr, "%s\n", trouble.what());
    return 1;
  }
  return 0;
}

}  // namespace toile::drafting
