#include "formats/obj/mesh_text.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "formats/obj/line_check.h"

namespace toile {
namespace {

std::size_t open_edges(const Eigen::Matrix3Xi& triangles) {
  std::vector<std::pair<int, int>> sides;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (Eigen::Index c = 0; c < 3; ++c) sides.emplace_back(triangles(c, t), triangles((c + 1) % 3, t));
  std::sort(sides.begin(), sides.end());
  return static_cast<std::size_t>(std::count_if(sides.begin(), sides.end(), [&](const auto& side) {
    return !std::binary_search(sides.begin(), sides.end(), std::pair(side.second, side.first));
  }));
}

// Programs that write one vertex for each texture corner tear the mesh along texture seams; joined again where that closes
// gaps.
void weld(ObjMesh& mesh, const std::string& place, Report& report) {
  const std::size_t gaps = open_edges(mesh.triangles);
  if (gaps == 0) return;
  std::map<std::array<double, 3>, int> first;
  std::vector<int> into(static_cast<std::size_t>(mesh.positions.cols()));
  for (int v = 0; v < static_cast<int>(into.size()); ++v)
    into[static_cast<std::size_t>(v)] =
        first.try_emplace({mesh.positions(0, v), mesh.positions(1, v), mesh.positions(2, v)}, v).first->second;
  Eigen::Matrix3Xi joined = mesh.triangles.unaryExpr([&](int v) { return into[static_cast<std::size_t>(v)]; });
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < joined.cols(); ++t)
    if (joined(0, t) != joined(1, t) && joined(1, t) != joined(2, t) && joined(2, t) != joined(0, t))
      joined.col(kept++) = joined.col(t);
  joined.conservativeResize(3, kept);
  if (open_edges(joined) >= gaps) return;
  const auto spare = static_cast<std::size_t>(mesh.positions.cols()) - first.size();
  mesh.triangles = std::move(joined);
  report.note("obj.welded", place, std::to_string(spare) + " vertices lie exactly on others and were joined with them");
}

// Leaves out vertices of no triangle, keeping the order of the others.
void drop_unused(ObjMesh& mesh) {
  std::vector<int> number(static_cast<std::size_t>(mesh.positions.cols()), -1);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (Eigen::Index c = 0; c < 3; ++c) number[static_cast<std::size_t>(mesh.triangles(c, t))] = 0;
  int next = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] == 0) {
      mesh.positions.col(next) = mesh.positions.col(static_cast<Eigen::Index>(v)).eval();
      number[v] = next++;
    }
  mesh.positions.conservativeResize(3, next);
  mesh.triangles = mesh.triangles.unaryExpr([&](int v) { return number[static_cast<std::size_t>(v)]; }).eval();
}

}  // namespace

Loaded<ObjMesh> read_obj_mesh(const std::string& text, const std::string& place) {
  Loaded<ObjMesh> loaded;
  check_obj_lines(text, place, false, loaded.report);
  if (!loaded.report.ok()) return loaded;

  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream stream(text);
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr, true, false)) {
    loaded.report.error("obj.unreadable", place, error.empty() ? "the file is not a valid OBJ" : error,
                        "export the body again");
    return loaded;
  }
  ObjMesh mesh;
  mesh.positions = Eigen::Map<const Eigen::Matrix<tinyobj::real_t, 3, Eigen::Dynamic>>(
      attributes.vertices.data(), 3, static_cast<Eigen::Index>(attributes.vertices.size() / 3));
  std::vector<int> corners;
  for (const tinyobj::shape_t& shape : shapes)
    for (const tinyobj::index_t& index : shape.mesh.indices) corners.push_back(index.vertex_index);
  mesh.triangles = Eigen::Map<const Eigen::Matrix3Xi>(corners.data(), 3, static_cast<Eigen::Index>(corners.size() / 3));
  if (mesh.triangles.cols() == 0 || mesh.triangles.minCoeff() < 0 || mesh.triangles.maxCoeff() >= mesh.positions.cols()) {
    loaded.report.error("obj.unreadable", place, "no triangles could be made of its faces",
                        "export the body with triangles only");
    return loaded;
  }
  weld(mesh, place, loaded.report);
  drop_unused(mesh);
  loaded.value = std::move(mesh);
  return loaded;
}

}  // namespace toile
