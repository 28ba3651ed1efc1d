#include "geometry/topology.h"

// Under AddressSanitizer gcc 12 takes the points that OpenMesh makes by default for uninitialised ones.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace toile {
namespace {

using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<>;

// One side of a triangle: from -> to, with the corner it does not touch.
struct Side {
  int low, high;
  bool rising;  // runs from low to high
  int triangle, opposite;
};

std::string between(int a, int b) { return "vertices " + std::to_string(a) + " and " + std::to_string(b); }

// Every side of every triangle, sorted by vertex pair, rising before falling, then by triangle.
std::vector<Side> sorted_sides(const Eigen::Matrix3Xi& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * static_cast<std::size_t>(triangles.cols()));
  for (int t = 0; t < static_cast<int>(triangles.cols()); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      const int from = triangles(corner, t);
      const int to = triangles((corner + 1) % 3, t);
      if (from < 0 || from == to)
        throw std::invalid_argument("topology: triangle " + std::to_string(t) + " has no three vertices");
      sides.push_back({std::min(from, to), std::max(from, to), from < to, t, triangles((corner + 2) % 3, t)});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tuple(a.low, a.high, !a.rising, a.triangle) < std::tuple(b.low, b.high, !b.rising, b.triangle);
  });
  return sides;
}

// Calls visit(first, last) for the sides of each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, const Visit& visit) {
  for (auto first = sides.begin(); first != sides.end();) {
    auto last = first + 1;
    while (last != sides.end() && last->low == first->low && last->high == first->high) ++last;
    visit(first, last);
    first = last;
  }
}

int root_of(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    int& up = parent[static_cast<std::size_t>(i)];
    up = parent[static_cast<std::size_t>(up)];
    i = up;
  }
  return i;
}

void unite(std::vector<int>& parent, int a, int b) {
  a = root_of(parent, a);
  b = root_of(parent, b);
  parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

int corner_of(const Eigen::Matrix3Xi& triangles, int t, int vertex) {
  for (int corner = 0; corner < 3; ++corner)
    if (triangles(corner, t) == vertex) return 3 * t + corner;
  throw std::logic_error("topology: corner not found");
}

// For each triangle corner the fan it belongs to: corners of one vertex that are joined through shared edges. A vertex where
// two parts of the surface merely touch has two fans, and half-edges are sound only fan by fan. `joins(first, last, join)`
// calls join(a, b) for the sides of an edge that are joined.
template <class Joins>
std::vector<int> fans_of_corners(const Eigen::Matrix3Xi& triangles, const std::vector<Side>& sides, const Joins& joins) {
  std::vector<int> parent(3 * static_cast<std::size_t>(triangles.cols()));
  std::iota(parent.begin(), parent.end(), 0);
  for_each_edge(sides, [&](auto first, auto last) {
    joins(first, last, [&](const Side& a, const Side& b) {
      for (const int vertex : {a.low, a.high})
        unite(parent, corner_of(triangles, a.triangle, vertex), corner_of(triangles, b.triangle, vertex));
    });
  });
  std::vector<int> fan(parent.size());
  for (std::size_t c = 0; c < parent.size(); ++c) fan[c] = root_of(parent, static_cast<int>(c));
  return fan;
}

// Face t is triangle t.
struct Sheets {
  HalfEdgeMesh mesh;
  std::vector<int> fan;  // by vertex of the mesh
};

// Throws std::invalid_argument.
Sheets sheets_of(const Eigen::Matrix3Xi& triangles, const std::vector<int>& fan) {
  Sheets sheets;
  std::vector<HalfEdgeMesh::VertexHandle> handle(fan.size());
  for (int t = 0; t < static_cast<int>(triangles.cols()); ++t) {
    std::array<HalfEdgeMesh::VertexHandle, 3> corners;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      HalfEdgeMesh::VertexHandle& vertex = handle[static_cast<std::size_t>(fan[3 * static_cast<std::size_t>(t) + corner])];
      if (!vertex.is_valid()) {
        vertex = sheets.mesh.add_vertex({0, 0, 0});
        sheets.fan.push_back(fan[3 * static_cast<std::size_t>(t) + corner]);
      }
      corners[corner] = vertex;
    }
    if (!sheets.mesh.add_face(corners[0], corners[1], corners[2]).is_valid())
      throw std::invalid_argument("boundary_loops: triangle " + std::to_string(t) + " does not fit an oriented surface");
  }
  return sheets;
}

// The vertices of a closed walk along half-edges that have nothing beyond them. What of it runs along seams is left out when
// the rest is closed by itself: everything of a closed layer's upper edge, or that of one whose free edges meet at the seam.
std::vector<int> without_seams(const std::vector<int>& around, const std::vector<bool>& seam,
                               const Eigen::Matrix3Xi& triangles) {
  const auto is_seam = [&](int h) { return bool{seam[static_cast<std::size_t>(h)]}; };
  const auto from = [&](int h) { return triangles(h % 3, h / 3); };
  const std::size_t count = around.size();
  std::vector<int> loop;
  std::size_t begin = 0;  // of the only free run
  int runs = 0;
  for (std::size_t i = 0; i < count; ++i) {
    loop.push_back(from(around[i]));
    if (is_seam(around[i]) || !is_seam(around[(i + count - 1) % count])) continue;
    ++runs;
    begin = i;
  }
  if (std::all_of(around.begin(), around.end(), is_seam)) return {};
  if (runs != 1) return loop;
  std::vector<int> run;
  std::size_t i = begin;
  for (; !is_seam(around[i % count]); ++i) run.push_back(loop[i % count]);
  return run.size() >= 3 && loop[i % count] == run.front() ? run : loop;
}

}  // namespace

std::vector<MeshEdge> mesh_edges(const Eigen::Matrix3Xi& triangles) {
  std::vector<MeshEdge> edges;
  edges.reserve(static_cast<std::size_t>(triangles.cols()) * 3 / 2 + 1);
  for_each_edge(sorted_sides(triangles), [&](auto first, auto last) {
    const auto add = [&](const Side& one, const Side& other, int further) {
      edges.push_back({{one.low, one.high}, {one.triangle, other.triangle}, {one.opposite, other.opposite}, further});
    };
    if (last - first == 1) {
      edges.push_back({{first->low, first->high}, {first->triangle, -1}, {first->opposite, -1}});
      return;
    }
    const auto falling = std::find_if(first, last, [](const Side& side) { return !side.rising; });
    if (falling == first || falling == last) {  // all face the same way
      add(*first, *(first + 1), -1);
      for (auto side = first + 2; side != last; ++side) add(*first, *side, 1);
      return;
    }
    auto rising = first, down = falling;
    for (; rising != falling && down != last; ++rising, ++down) add(*rising, *down, rising == first ? -1 : 2);
    for (; rising != falling; ++rising) add(*rising, *falling, 0);
    for (; down != last; ++down) add(*first, *down, 1);
  });
  return edges;
}

std::vector<std::vector<int>> boundary_loops(const Eigen::Matrix3Xi& triangles) {
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  const std::vector<Side> sides = sorted_sides(triangles);
  std::vector<bool> seam(3 * index(static_cast<int>(triangles.cols())), false);  // by side 3 t + c, from corner c of triangle t
  for_each_edge(sides, [&](auto first, auto last) {
    if (last - first == 2 && first->rising == (first + 1)->rising)
      throw std::invalid_argument("boundary_loops: not an oriented surface between " + between(first->low, first->high));
    for (auto side = first; last - first > 2 && side != last; ++side)
      seam[index(corner_of(triangles, side->triangle, side->rising ? side->low : side->high))] = true;
  });
  // Where more than two meet, each of those that face one way goes on as one that faces the other, and what is over ends there.
  const std::vector<int> fan = fans_of_corners(triangles, sides, [](auto first, auto last, const auto& join) {
    auto falling = std::find_if(first, last, [](const Side& side) { return !side.rising; });
    for (auto rising = first; rising->rising && falling != last; ++rising, ++falling) join(*rising, *falling);
  });
  const Sheets sheets = sheets_of(triangles, fan);
  const HalfEdgeMesh& mesh = sheets.mesh;

  std::vector<std::vector<int>> loops;
  std::vector<bool> seen(mesh.n_halfedges(), false);
  for (const auto start : mesh.halfedges()) {
    if (!start.is_boundary() || seen[index(start.idx())]) continue;
    std::vector<int> around;
    HalfEdgeMesh::HalfedgeHandle at = start;
    do {  // a boundary half-edge has the surface on its right, so they are followed backwards
      seen[index(at.idx())] = true;
      const HalfEdgeMesh::HalfedgeHandle inner = mesh.opposite_halfedge_handle(at);
      int corner = 3 * mesh.face_handle(inner).idx();
      while (fan[index(corner)] != sheets.fan[index(mesh.from_vertex_handle(inner).idx())]) ++corner;
      around.push_back(corner);
      at = mesh.prev_halfedge_handle(at);
    } while (at != HalfEdgeMesh::HalfedgeHandle(start));
    std::vector<int> loop = without_seams(around, seam, triangles);
    if (loop.empty()) continue;
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    loops.push_back(std::move(loop));
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

std::vector<int> components(const Eigen::Matrix3Xi& triangles, int vertex_count) {
  std::vector<int> parent(static_cast<std::size_t>(vertex_count));
  std::iota(parent.begin(), parent.end(), 0);
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      if (triangles(corner, t) < 0 || triangles(corner, t) >= vertex_count)
        throw std::invalid_argument("components: triangle " + std::to_string(t) + " names a vertex that does not exist");
      if (corner > 0) unite(parent, triangles(0, t), triangles(corner, t));
    }
  std::vector<int> number(parent.size());
  int next = 0;
  for (std::size_t v = 0; v < parent.size(); ++v) {
    const int root = root_of(parent, static_cast<int>(v));  // the smallest vertex of the component, so already numbered
    number[v] = root == static_cast<int>(v) ? next++ : number[static_cast<std::size_t>(root)];
  }
  return number;
}

std::vector<std::string> defects_of_closed_surface(const Eigen::Matrix3Xi& triangles) {
  if (triangles.cols() == 0) return {"it has no triangles"};
  for (int t = 0; t < static_cast<int>(triangles.cols()); ++t)
    if (triangles(0, t) == triangles(1, t) || triangles(1, t) == triangles(2, t) || triangles(2, t) == triangles(0, t))
      return {"triangle " + std::to_string(t) + " has the same vertex twice"};

  const std::vector<Side> sides = sorted_sides(triangles);
  struct Count {
    int number = 0;
    std::string first;
    void add(const std::string& where) {
      if (number++ == 0) first = where;
    }
  };
  Count open, crowded, turned, pinched;
  for_each_edge(sides, [&](auto first, auto last) {
    const std::string where = between(first->low, first->high);
    if (last - first == 1) open.add(where);
    if (last - first > 2) crowded.add(where);
    if (last - first == 2 && first->rising == (first + 1)->rising) turned.add(where);
  });
  std::map<int, int> fan_at;
  const std::vector<int> fan = fans_of_corners(triangles, sides, [](auto first, auto last, const auto& join) {
    for (auto side = first + 1; side != last; ++side) join(*first, *side);
  });
  std::map<int, bool> pinched_at;
  for (int c = 0; c < static_cast<int>(fan.size()); ++c) {
    const int vertex = triangles(c % 3, c / 3);
    const auto [entry, fresh] = fan_at.try_emplace(vertex, fan[static_cast<std::size_t>(c)]);
    if (!fresh && entry->second != fan[static_cast<std::size_t>(c)]) pinched_at[vertex] = true;
  }
  for (const auto& [vertex, unused] : pinched_at) pinched.add("vertex " + std::to_string(vertex));

  std::vector<std::string> defects;
  const auto say = [&](const Count& count, const std::string& what, const std::string& place) {
    if (count.number > 0)
      defects.push_back(what + ": " + std::to_string(count.number) + ", the first " + place + " " + count.first);
  };
  say(open, "open edges (the border of a hole)", "between");
  say(crowded, "edges with more than two triangles", "between");
  say(turned, "edges whose two triangles face opposite ways", "between");
  say(pinched, "vertices where separate parts of the surface touch", "at");
  return defects;
}

}  // namespace toile
