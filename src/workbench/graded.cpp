#include "workbench/graded.h"

#include <algorithm>
#include <stdexcept>

#include "geometry/polyline.h"

namespace toile {
namespace {

void check_alike(const std::vector<Pattern>& sizes) {
  for (const Pattern& size : sizes) {
    if (size.pieces.size() != sizes.front().pieces.size()) throw std::invalid_argument("graded: sizes have other pieces");
    for (std::size_t p = 0; p < size.pieces.size(); ++p) {
      const auto& a = size.pieces[p].outline;
      const auto& b = sizes.front().pieces[p].outline;
      if (!std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Edge& x, const Edge& y) { return x.id == y.id; }))
        throw std::invalid_argument("graded: piece '" + size.pieces[p].name + "' has other edges");
    }
  }
}

std::vector<double> shares(const Edge& edge) {
  const std::vector<Eigen::Vector2d> points = positions(edge);
  std::vector<double> at{0};
  for (std::size_t i = 1; i < points.size(); ++i) at.push_back(at.back() + (points[i] - points[i - 1]).norm());
  for (double& share : at) share /= at.back();
  return at;
}

// `edge` with points at `at`; its ends as they are, what is known of a point as in `like`.
void resample_at(const std::vector<double>& at, const Edge& like, Edge& edge) {
  const std::vector<Eigen::Vector2d> points = positions(edge);
  std::vector<OutlinePoint> made = like.points;
  for (std::size_t i = 0; i < at.size(); ++i)
    made[i].at = i == 0 ? points.front() : i + 1 == at.size() ? points.back() : point_at<2>(points, at[i]);
  edge.points = std::move(made);
}

}  // namespace

std::vector<Pattern> with_same_points(std::vector<Pattern> sizes) {
  if (sizes.empty()) return sizes;
  check_alike(sizes);
  for (std::size_t p = 0; p < sizes.front().pieces.size(); ++p)
    for (std::size_t e = 0; e < sizes.front().pieces[p].outline.size(); ++e) {
      const auto edge_of = [&](Pattern& size) -> Edge& { return size.pieces[p].outline[e]; };
      const auto most = std::max_element(sizes.begin(), sizes.end(), [&](Pattern& a, Pattern& b) {
        return edge_of(a).points.size() < edge_of(b).points.size();
      });
      const Edge like = edge_of(*most);
      const std::vector<double> at = shares(like);
      for (Pattern& size : sizes)
        if (edge_of(size).points.size() != like.points.size()) resample_at(at, like, edge_of(size));
    }
  return sizes;
}

std::vector<PointGrade> turn_point_grades(const std::vector<Pattern>& sizes, std::size_t base) {
  std::vector<PointGrade> grades;
  if (sizes.empty()) return grades;
  check_alike(sizes);
  for (std::size_t p = 0; p < sizes.front().pieces.size(); ++p)
    for (std::size_t e = 0; e < sizes.front().pieces[p].outline.size(); ++e) {
      PointGrade grade{sizes.front().pieces[p].name, sizes.front().pieces[p].outline[e].id, {}};
      for (const Pattern& size : sizes)
        grade.moves.push_back(size.pieces[p].outline[e].points.front().at -
                              sizes.at(base).pieces[p].outline[e].points.front().at);
      grades.push_back(std::move(grade));
    }
  return grades;
}

}  // namespace toile
