#include "formats/obj/faces.h"

#include <tiny_obj_loader.h>

#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <sstream>

namespace toile {
namespace {

using Eigen::Vector2d;

struct Collected {
  std::vector<double> positions, textures;
  std::vector<std::vector<ObjCorner>> polygons;
};

// 1-based or, negative, counted back from the last so far.
int zero_based(int index, std::size_t so_far) { return index > 0 ? index - 1 : static_cast<int>(so_far) + index; }

double doubled_area(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

}  // namespace

Loaded<ObjFaces> read_obj_faces(const std::string& text, const std::string& place) {
  Loaded<ObjFaces> loaded;
  ObjFaces faces;
  faces.lines = check_obj_lines(text, place, true, loaded.report);
  if (!loaded.report.ok()) return loaded;

  // The callbacks, because the loader's own lists count the corners of a face in one byte.
  Collected collected;
  tinyobj::callback_t callback;
  callback.vertex_cb = [](void* user, double x, double y, double z, double) {
    auto& all = static_cast<Collected*>(user)->positions;
    all.insert(all.end(), {x, y, z});
  };
  callback.texcoord_cb = [](void* user, double x, double y, double) {
    auto& all = static_cast<Collected*>(user)->textures;
    all.insert(all.end(), {x, y});
  };
  callback.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
    auto& all = *static_cast<Collected*>(user);
    std::vector<ObjCorner> polygon;
    for (int i = 0; i < count; ++i)
      polygon.push_back({zero_based(indices[i].vertex_index, all.positions.size() / 3),
                         zero_based(indices[i].texcoord_index, all.textures.size() / 2)});
    all.polygons.push_back(std::move(polygon));
  };
  std::istringstream stream(text);
  std::string warning, error;
  const bool read = tinyobj::LoadObjWithCallback(stream, callback, &collected, nullptr, &warning, &error);
  const bool in_range = std::all_of(collected.polygons.begin(), collected.polygons.end(), [&](const auto& polygon) {
    return std::all_of(polygon.begin(), polygon.end(), [&](const ObjCorner& corner) {
      return corner.vertex >= 0 && 3 * static_cast<std::size_t>(corner.vertex) < collected.positions.size() &&
             corner.texture >= 0 && 2 * static_cast<std::size_t>(corner.texture) < collected.textures.size();
    });
  });
  if (!read || !in_range || collected.polygons.size() != faces.lines.line_of_face.size()) {
    loaded.report.error("obj.unreadable", place, error.empty() ? "the file is not a valid OBJ" : error, "export it again");
    return loaded;
  }
  faces.positions = Eigen::Map<const Eigen::Matrix3Xd>(collected.positions.data(), 3,
                                                       static_cast<Eigen::Index>(collected.positions.size() / 3));
  faces.textures = Eigen::Map<const Eigen::Matrix2Xd>(collected.textures.data(), 2,
                                                      static_cast<Eigen::Index>(collected.textures.size() / 2));
  faces.polygons = std::move(collected.polygons);
  loaded.value = std::move(faces);
  return loaded;
}

std::vector<Eigen::Vector3i> split_polygon(const std::vector<Vector2d>& polygon) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += a.x() * b.y() - a.y() * b.x();
  }
  const double sense = area < 0 ? -1 : 1;
  std::vector<int> left(polygon.size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<Eigen::Vector3i> triangles;
  const auto at = [&](int i) -> const Vector2d& { return polygon[static_cast<std::size_t>(i)]; };
  while (left.size() >= 3) {
    std::size_t best = left.size();
    double best_shape = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const int a = left[(i + left.size() - 1) % left.size()], b = left[i], c = left[(i + 1) % left.size()];
      const double twice = sense * doubled_area(at(a), at(b), at(c));
      if (twice <= 0) continue;
      const bool ear = std::none_of(left.begin(), left.end(), [&](int k) {
        return k != a && k != b && k != c && sense * doubled_area(at(a), at(b), at(k)) >= 0 &&
               sense * doubled_area(at(b), at(c), at(k)) >= 0 && sense * doubled_area(at(c), at(a), at(k)) >= 0;
      });
      const double shape =
          twice / ((at(b) - at(a)).squaredNorm() + (at(c) - at(b)).squaredNorm() + (at(a) - at(c)).squaredNorm());
      if (ear && shape > best_shape) best = i, best_shape = shape;
    }
    if (best == left.size()) break;
    triangles.emplace_back(left[(best + left.size() - 1) % left.size()], left[best], left[(best + 1) % left.size()]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return triangles;
}

}  // namespace toile
