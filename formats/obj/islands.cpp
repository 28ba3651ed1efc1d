#include "formats/obj/islands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "formats/obj/island_names.h"

namespace toile {
namespace {

using Side = std::pair<int, int>;

constexpr std::size_t most_corners = 500;  // of a polygon
constexpr double folded_share = .2;        // of the larger of two parts that lie on one another

// The whole file as triangles of its distinct pairs of vertex and texture coordinate.
struct Sheet {
  std::vector<ObjCorner> corners;  // sorted by texture coordinate
  std::vector<Eigen::Vector3i> triangles;
  std::vector<int> face;     // by triangle
  std::vector<double> area;  // by triangle, signed, doubled
  std::vector<int> part;     // by triangle
  int parts = 0;
};

template <int N>
std::vector<int> by_place(const Eigen::Matrix<double, N, Eigen::Dynamic>& points, bool joined) {
  std::vector<int> number(static_cast<std::size_t>(points.cols()));
  std::iota(number.begin(), number.end(), 0);
  if (!joined) return number;
  std::map<std::array<double, N>, int> first;
  for (int i = 0; i < static_cast<int>(number.size()); ++i) {
    std::array<double, N> key;
    for (int k = 0; k < N; ++k) key[static_cast<std::size_t>(k)] = points(k, i);
    number[static_cast<std::size_t>(i)] = first.try_emplace(key, i).first->second;
  }
  return number;
}

// Splits polygons; nothing after an error.
std::optional<Sheet> triangulated(const ObjFaces& faces, bool joined, const std::string& place, Report& report) {
  const std::vector<int> vertex = by_place<3>(faces.positions, joined), texture = by_place<2>(faces.textures, joined);
  const auto same = [&](const ObjCorner& c) {
    return ObjCorner{vertex[static_cast<std::size_t>(c.vertex)], texture[static_cast<std::size_t>(c.texture)]};
  };
  const auto before = [](const ObjCorner& a, const ObjCorner& b) {
    return std::pair(a.texture, a.vertex) < std::pair(b.texture, b.vertex);
  };
  Sheet sheet;
  for (const auto& polygon : faces.polygons)
    for (const ObjCorner& corner : polygon) sheet.corners.push_back(same(corner));
  std::sort(sheet.corners.begin(), sheet.corners.end(), before);
  sheet.corners.erase(std::unique(sheet.corners.begin(), sheet.corners.end()), sheet.corners.end());
  for (std::size_t f = 0; f < faces.polygons.size(); ++f) {
    const auto& polygon = faces.polygons[f];
    std::vector<int> ids;
    std::vector<Eigen::Vector2d> flat;
    for (const ObjCorner& corner : polygon) {
      ids.push_back(static_cast<int>(std::lower_bound(sheet.corners.begin(), sheet.corners.end(), same(corner), before) -
                                     sheet.corners.begin()));
      flat.push_back(faces.textures.col(corner.texture));
    }
    const std::string at = place + ":" + std::to_string(faces.lines.line_of_face[f]);
    if (polygon.size() > most_corners) {
      report.error("obj.bad-face", at, "the face has " + std::to_string(polygon.size()) + " corners",
                   "export it with triangles only");
      return std::nullopt;
    }
    std::vector<Eigen::Vector3i> parts{{0, 1, 2}};
    if (polygon.size() > 3) parts = split_polygon(flat);
    if (parts.size() + 2 != polygon.size()) {
      report.error("obj.folded-island", at, "the face crosses itself or has no area in the texture coordinates",
                   "unfold the texture coordinates (UV) of the piece there");
      return std::nullopt;
    }
    for (const Eigen::Vector3i& t : parts) {
      const auto id = [&](int k) { return ids[static_cast<std::size_t>(t[k])]; };
      if (id(0) == id(1) || id(1) == id(2) || id(2) == id(0)) continue;
      sheet.triangles.emplace_back(id(0), id(1), id(2));
      sheet.face.push_back(static_cast<int>(f));
      const Eigen::Vector2d u = flat[static_cast<std::size_t>(t[1])] - flat[static_cast<std::size_t>(t[0])],
                            w = flat[static_cast<std::size_t>(t[2])] - flat[static_cast<std::size_t>(t[0])];
      sheet.area.push_back(u.x() * w.y() - u.y() * w.x());
    }
  }
  return sheet;
}

std::array<Side, 3> sides(const Eigen::Vector3i& t) { return {Side{t[0], t[1]}, Side{t[1], t[2]}, Side{t[2], t[0]}}; }

int root(std::vector<int>& parent, int t) {
  while (parent[static_cast<std::size_t>(t)] != t) {
    auto& up = parent[static_cast<std::size_t>(t)];
    up = parent[static_cast<std::size_t>(up)];
    t = up;
  }
  return t;
}

struct Folds {
  std::vector<std::pair<int, int>> pairs;  // triangles at one side that lie on one another
};

// Numbers the parts in the order of their first triangles.
Folds part(Sheet& sheet, const ObjFaces& faces, const std::string& place, Report& report) {
  double whole = 0, largest = 0;
  for (const double area : sheet.area) whole += area, largest = std::max(largest, std::abs(area));
  const auto over = [&](int t) {  // nothing can be said of slivers
    const double area = sheet.area[static_cast<std::size_t>(t)];
    return std::abs(area) < 1e-9 * largest ? whole < 0 : area < 0;
  };
  std::vector<int> parent(sheet.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  Folds folds;
  // Of triangles that lie on one another the mirrored ones have a list of their own.
  std::map<Side, int> owners[2];
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t)
    for (const Side& side : sides(sheet.triangles[static_cast<std::size_t>(t)]))
      if (!owners[over(t)].emplace(side, t).second) {
        report.error(
            "obj.not-manifold",
            place + ":" +
                std::to_string(faces.lines.line_of_face[static_cast<std::size_t>(sheet.face[static_cast<std::size_t>(t)])]),
            "the face lies on another, or turns the other way round than its neighbour",
            "merge doubled faces and let all faces show their outside; export the garment with thin cloth");
        return folds;
      }
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t)
    for (const auto& [from, to] : sides(sheet.triangles[static_cast<std::size_t>(t)])) {
      if (const auto beside = owners[over(t)].find({to, from}); beside != owners[over(t)].end())
        parent[static_cast<std::size_t>(root(parent, t))] = root(parent, beside->second);
      if (const auto below = owners[!over(t)].find({to, from}); below != owners[!over(t)].end())
        folds.pairs.emplace_back(t, below->second);
    }
  std::map<int, int> number;
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t)
    sheet.part.push_back(number.try_emplace(root(parent, t), static_cast<int>(number.size())).first->second);
  sheet.parts = static_cast<int>(number.size());
  return folds;
}

std::vector<std::vector<int>> loops_of(const Eigen::Matrix3Xi& triangles, bool& pinched) {
  std::map<Side, bool> open;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (const Side& side : sides(triangles.col(t))) open[side] = true;
  std::map<int, int> next;
  for (const auto& [side, unused] : open)
    if (!open.contains({side.second, side.first}) && !next.emplace(side.first, side.second).second) pinched = true;
  std::vector<std::vector<int>> loops;
  while (!pinched && !next.empty()) {
    loops.emplace_back();
    for (auto at = next.begin(); at != next.end();) {
      loops.back().push_back(at->first);
      const int to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  }
  return loops;
}

double doubled_area(const std::vector<int>& loop, const Eigen::Matrix2Xd& flat) {
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d a = flat.col(loop[i]), b = flat.col(loop[(i + 1) % loop.size()]);
    area += a.x() * b.y() - a.y() * b.x();
  }
  return area;
}

Island island(const Sheet& sheet, const std::vector<int>& members, const ObjFaces& faces) {
  Island made;
  std::vector<int> used;
  double area = 0;
  for (const int t : members) {
    for (int k = 0; k < 3; ++k) used.push_back(sheet.triangles[static_cast<std::size_t>(t)][k]);
    area += sheet.area[static_cast<std::size_t>(t)];
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  made.turned_over = area < 0;
  made.flat.resize(2, static_cast<Eigen::Index>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i) {
    const ObjCorner& corner = sheet.corners[static_cast<std::size_t>(used[i])];
    made.vertex.push_back(corner.vertex);
    made.flat.col(static_cast<Eigen::Index>(i)) = faces.textures.col(corner.texture);
  }
  if (made.turned_over) made.flat.row(0) *= -1;
  made.triangles.resize(3, static_cast<Eigen::Index>(members.size()));
  for (std::size_t m = 0; m < members.size(); ++m)
    for (int k = 0; k < 3; ++k)
      made.triangles(k, static_cast<Eigen::Index>(m)) = static_cast<int>(
          std::lower_bound(used.begin(), used.end(), sheet.triangles[static_cast<std::size_t>(members[m])][k]) - used.begin());
  made.line = faces.lines.line_of_face[static_cast<std::size_t>(sheet.face[static_cast<std::size_t>(members.front())])];
  return made;
}

}  // namespace

Loaded<std::vector<Island>> islands_of(const ObjFaces& faces, const std::string& place) {
  Loaded<std::vector<Island>> loaded;
  Report& report = loaded.report;
  auto sheet = triangulated(faces, false, place, report);
  if (!sheet) return loaded;
  Folds folds = part(*sheet, faces, place, report);
  // Nearly every triangle by itself: a program that writes every corner anew.
  if (report.ok() && sheet->parts > 1 && 2 * static_cast<std::size_t>(sheet->parts) > sheet->triangles.size()) {
    sheet = triangulated(faces, true, place, report);
    folds = part(*sheet, faces, place, report);
  }
  if (!report.ok()) return loaded;
  if (sheet->triangles.empty()) {
    report.error("obj.no-faces", place, "none of its faces has three different corners", "export it again");
    return loaded;
  }
  if (sheet->triangles.size() > faces.polygons.size())
    report.note("obj.polygons-split", place, "polygons were split into triangles");

  std::vector<std::vector<int>> members(static_cast<std::size_t>(sheet->parts));
  std::vector<double> area(members.size(), 0);
  for (std::size_t t = 0; t < sheet->part.size(); ++t) {
    members[static_cast<std::size_t>(sheet->part[t])].push_back(static_cast<int>(t));
    area[static_cast<std::size_t>(sheet->part[t])] += std::abs(sheet->area[t]);
  }
  const std::vector<std::string> names = island_names(members, sheet->face, faces.lines);
  std::vector<Island> islands;
  for (std::size_t i = 0; i < members.size(); ++i) {
    islands.push_back(island(*sheet, members[i], faces));
    islands.back().name = names[i];
  }
  const auto where = [&](std::size_t i) {
    return place + ":" + std::to_string(islands[i].line) + ", piece '" + islands[i].name + "'";
  };
  for (const auto& [t, below] : folds.pairs) {
    const auto p = static_cast<std::size_t>(sheet->part[static_cast<std::size_t>(t)]),
               q = static_cast<std::size_t>(sheet->part[static_cast<std::size_t>(below)]);
    if (area[p] > folded_share * area[q] && area[q] > folded_share * area[p]) continue;  // halves stacked on purpose
    report.error("obj.folded-island", where(std::max(p, q)),
                 "part of the piece lies folded over in the texture coordinates (UV)",
                 "unfold it there, so that the piece lies flat");
    return loaded;
  }
  for (std::size_t i = 0; i < islands.size(); ++i) {
    Island& made = islands[i];
    const Eigen::Vector2d size = made.flat.rowwise().maxCoeff() - made.flat.rowwise().minCoeff();
    bool pinched = false;
    made.loops = loops_of(made.triangles, pinched);
    if (!(area[i] > 1e-12 * size.squaredNorm()) || !(size.minCoeff() > 0))
      report.error("obj.degenerate-island", where(i), "the piece has no area in the texture coordinates (UV)",
                   "lay it flat; one island for each pattern piece");
    else if (pinched)
      report.error("obj.not-manifold", where(i), "two corners of its outline touch in one point",
                   "take the two vertices apart, or the two parts");
    else if (made.loops.empty())
      report.error("obj.closed-island", where(i), "the piece is a closed surface without an outline",
                   "cut it open along its seams in the texture coordinates (UV)");
    if (!report.ok()) return loaded;
    const auto outer = std::max_element(made.loops.begin(), made.loops.end(), [&](const auto& a, const auto& b) {
      return doubled_area(a, made.flat) < doubled_area(b, made.flat);
    });
    std::rotate(made.loops.begin(), outer, outer + 1);
  }
  loaded.value = std::move(islands);
  return loaded;
}

}  // namespace toile
