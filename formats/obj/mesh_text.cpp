#include "formats/obj/mesh_text.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace toile {
namespace {

std::vector<std::string_view> fields(std::string_view line) {
  std::vector<std::string_view> found;
  constexpr std::string_view blank = " \t\r\v\f";
  for (std::size_t at = line.find_first_not_of(blank); at != std::string_view::npos; at = line.find_first_not_of(blank, at)) {
    const std::size_t end = std::min(line.find_first_of(blank, at), line.size());
    found.push_back(line.substr(at, end - at));
    at = end;
  }
  return found;
}

template <class Number>
std::optional<Number> read_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  Number value{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

// tinyobjloader takes "nan" for 0 and says at the end of the file, if at all, that an index was wrong; so every number is
// looked at before it is asked.
class LineCheck {
 public:
  LineCheck(const std::string& place, Report& report) : place_(place), report_(report) {}

  void check(const std::string& text) {
    std::string_view rest = text;
    while (!rest.empty() && report_.ok()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      ++line_;
      const std::vector<std::string_view> words = fields(rest.substr(0, end));
      if (!words.empty() && words[0] == "v") vertex(words);
      if (!words.empty() && words[0] == "f") face(words);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (!report_.ok()) return;
    if (vertices_ == 0 || faces_ == 0)
      report_.error("obj.no-faces", place_, vertices_ == 0 ? "the file has no vertices" : "the file has no faces",
                    "export the body as OBJ with its faces; is this an OBJ file at all?");
    else if (greatest_ > vertices_)
      report_.error("obj.no-such-vertex", place_ + ":" + std::to_string(greatest_line_),
                    "the face names vertex " + std::to_string(greatest_) + ", there are " + std::to_string(vertices_),
                    "the file may be cut off; export it again");
  }

 private:
  void say(const std::string& code, const std::string& text, const std::string& remedy) {
    report_.error(code, place_ + ":" + std::to_string(line_), text, remedy);
  }

  void vertex(const std::vector<std::string_view>& words) {
    ++vertices_;
    if (words.size() < 4)
      return say("obj.not-a-number", "the vertex has fewer than three numbers", "the file may be cut off; export it again");
    for (std::size_t i = 1; i < 4; ++i) {
      const auto value = read_number<double>(words[i]);
      if (!value) return say("obj.not-a-number", "'" + std::string(words[i]) + "' is not a number", "export the body again");
      if (!std::isfinite(*value))
        return say("body.not-finite", "the vertex is not finite: '" + std::string(words[i]) + "'",
                   "export the body again; a modifier or a simulation may have blown it up");
    }
  }

  void face(const std::vector<std::string_view>& words) {
    ++faces_;
    if (words.size() < 4)
      return say("obj.bad-face", "the face has fewer than three corners", "the file may be cut off; export it again");
    for (std::size_t i = 1; i < words.size(); ++i) {
      const auto index = read_number<long>(words[i].substr(0, words[i].find('/')));
      if (!index || *index == 0)
        return say("obj.bad-face", "'" + std::string(words[i]) + "' names no vertex", "export the body again");
      if (*index < -vertices_)
        return say("obj.no-such-vertex", "the face names vertex " + std::to_string(*index) + " before there are so many",
                   "export the body again");
      if (*index > greatest_) {
        greatest_ = *index;
        greatest_line_ = line_;
      }
    }
  }

  std::string place_;
  Report& report_;
  long line_ = 0, vertices_ = 0, faces_ = 0, greatest_ = 0, greatest_line_ = 0;
};

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
  LineCheck(place, loaded.report).check(text);
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
