#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "formats/formats.h"
#include "formats/glb/glb_container.h"

namespace toile {
namespace {

using Json = nlohmann::ordered_json;
using Colours16 = Eigen::Matrix<std::uint16_t, 4, Eigen::Dynamic>;

// What glTF calls things (Khronos glTF 2.0, sections 3.6 and 5.1).
constexpr int type_float = 5126, type_uint32 = 5125, type_uint16 = 5123, for_vertices = 34962, for_indices = 34963;

struct Part {
  std::string name;
  Eigen::Matrix3Xd positions, normals;
  Eigen::Matrix3Xi triangles;
  Eigen::Matrix3Xd colours;  // sRGB by vertex; none: the material's
  Eigen::VectorXd values;    // by vertex; none: no attribute
};

// Weighted by area; where triangles cancel each other or have none, upwards: glTF asks for unit normals.
Eigen::Matrix3Xd vertex_normals(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, positions.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Vector3i c = triangles.col(t);
    const Eigen::Vector3d ab = positions.col(c(1)) - positions.col(c(0)), ac = positions.col(c(2)) - positions.col(c(0));
    for (int k = 0; k < 3; ++k) normals.col(c(k)) += ab.cross(ac);
  }
  for (Eigen::Index v = 0; v < normals.cols(); ++v) {
    const double length = normals.col(v).norm();
    normals.col(v) = length > 1e-30 ? Eigen::Vector3d(normals.col(v) / length) : Eigen::Vector3d::UnitY();
  }
  return normals;
}

// Vertex colours are linear light in glTF; sixteen bits keep dark colours apart.
Colours16 linear_colours(const Eigen::Matrix3Xd& srgb) {
  Colours16 linear = Colours16::Constant(4, srgb.cols(), 65535);
  for (Eigen::Index i = 0; i < srgb.cols(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double v = std::clamp(srgb(k, i), 0.0, 1.0);
      const double light = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
      linear(k, i) = static_cast<std::uint16_t>(std::lround(65535 * light));
    }
  return linear;
}

class Document {
 public:
  Document() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "toile"}};
    json_["scene"] = 0;
    json_["scenes"] = {{{"nodes", Json::array()}}};
    for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews"}) json_[list] = Json::array();
  }

  int add_material(const std::string& name, const std::array<double, 3>& linear, bool both_sides) {
    Json surface = {
        {"baseColorFactor", {linear[0], linear[1], linear[2], 1.0}}, {"metallicFactor", 0}, {"roughnessFactor", 0.9}};
    json_["materials"].push_back({{"name", name}, {"pbrMetallicRoughness", std::move(surface)}, {"doubleSided", both_sides}});
    return last("materials");
  }

  int add_node(Json node) {
    json_["nodes"].push_back(std::move(node));
    return last("nodes");
  }

  int add_part(const Part& part, int material) {
    const Eigen::Matrix3Xf positions = part.positions.cast<float>();
    Json attributes;
    attributes["POSITION"] = add_accessor(buffer_.add(positions), type_float, "VEC3", positions.cols(), for_vertices);
    const Eigen::Vector3f low = positions.rowwise().minCoeff(), high = positions.rowwise().maxCoeff();
    json_["accessors"].back()["min"] = {low.x(), low.y(), low.z()};
    json_["accessors"].back()["max"] = {high.x(), high.y(), high.z()};
    const Eigen::Matrix3Xf normals = part.normals.cast<float>();
    attributes["NORMAL"] = add_accessor(buffer_.add(normals), type_float, "VEC3", normals.cols(), for_vertices);
    if (part.colours.cols() > 0) {
      const Colours16 colours = linear_colours(part.colours);
      attributes["COLOR_0"] = add_accessor(buffer_.add(colours), type_uint16, "VEC4", colours.cols(), for_vertices);
      json_["accessors"].back()["normalized"] = true;
    }
    if (part.values.size() > 0) {
      const Eigen::VectorXf values = part.values.cast<float>();
      attributes["_VALUE"] = add_accessor(buffer_.add(values), type_float, "SCALAR", values.size(), for_vertices);
    }
    const Eigen::Matrix<std::uint32_t, 3, Eigen::Dynamic> corners = part.triangles.cast<std::uint32_t>();
    const int indices = add_accessor(buffer_.add(corners), type_uint32, "SCALAR", corners.size(), for_indices);
    const Json primitive = {{"attributes", attributes}, {"indices", indices}, {"material", material}};
    json_["meshes"].push_back({{"name", part.name}, {"primitives", {primitive}}});
    return add_node({{"name", part.name}, {"mesh", last("meshes")}});
  }

  std::string bytes(const std::vector<int>& roots) {
    json_["scenes"][0]["nodes"] = roots;
    json_["buffers"] = {{{"byteLength", buffer_.bytes().size()}}};
    return glb_bytes(json_.dump(-1, ' ', false, Json::error_handler_t::replace), buffer_);
  }

 private:
  int last(const char* list) const { return static_cast<int>(json_.at(list).size()) - 1; }

  int add_accessor(const GlbBuffer::View& view, int component, const char* type, Eigen::Index count, int target) {
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", view.offset}, {"byteLength", view.length}, {"target", target}});
    json_["accessors"].push_back(
        {{"bufferView", last("bufferViews")}, {"componentType", component}, {"count", count}, {"type", type}});
    return last("accessors");
  }

  Json json_;
  GlbBuffer buffer_;
};

// With a map of triangles every triangle gets corners of its own, so that its colour is its own.
Part panel_part(const GarmentMesh& garment, std::size_t number, int first, const Eigen::Matrix3Xd& positions,
                const Eigen::Matrix3Xd& normals, const ColouredMap* map) {
  const PanelMesh& panel = garment.panels[number];
  const Eigen::VectorXi& welded = garment.welded[number];
  Part part;
  part.name = panel.name;
  std::vector<int> vertex;          // garment vertex by vertex of the part
  std::vector<Eigen::Index> place;  // of its value
  part.triangles = panel.triangles;
  if (map && map->map.of == MapOf::triangle) {
    for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t)
      for (int k = 0; k < 3; ++k) {
        part.triangles(k, t) = static_cast<int>(vertex.size());
        vertex.push_back(welded(panel.triangles(k, t)));
        place.push_back(first + t);
      }
  } else {
    for (const int v : welded) vertex.push_back(v), place.push_back(v);
  }
  part.positions = positions(Eigen::all, vertex);
  part.normals = normals(Eigen::all, vertex);
  if (map) {
    part.colours = map->colours(Eigen::all, place);
    part.values = map->map.values(place) / map->map.unit_size;
  }
  return part;
}

void check_map(const GarmentMesh& garment, const ColouredMap& map) {
  const Eigen::Index count = map.map.of == MapOf::triangle ? garment.triangles.cols() : garment.vertex_count;
  if (map.map.values.size() != count || map.colours.cols() != count)
    throw std::invalid_argument("write_glb: map '" + map.map.name + "' is of another garment");
}

}  // namespace

void write_glb(const std::filesystem::path& file, const Mannequin& body, const GarmentMesh& garment,
               const Eigen::Matrix3Xd& positions, const ColouredMap* map) {
  check(garment);
  if (positions.cols() != garment.vertex_count)
    throw std::invalid_argument("write_glb: one position for each garment vertex is needed");
  if (!positions.allFinite() || !body.positions.allFinite()) throw std::invalid_argument("write_glb: positions are not finite");
  if (map) check_map(garment, *map);

  Document document;
  const int skin = document.add_material("skin", {.65, .60, .55}, false);
  const int cloth = document.add_material("cloth", map ? std::array{1., 1., 1.} : std::array{.15, .34, .60}, true);
  std::vector<int> roots;
  if (body.triangles.cols() > 0)
    roots.push_back(document.add_part(
        {"body", body.positions, vertex_normals(body.positions, body.triangles), body.triangles, {}, {}}, skin));

  const Eigen::Matrix3Xd normals = vertex_normals(positions, garment.triangles);
  const std::vector<int> first = triangle_offsets(garment);
  std::vector<int> panels;
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    if (garment.panels[p].triangles.cols() > 0)
      panels.push_back(document.add_part(panel_part(garment, p, first[p], positions, normals, map), cloth));
  if (!panels.empty()) {
    Json node = {{"name", "garment"}, {"children", panels}};
    if (map) {
      const double unit = map->map.unit_size;
      node["extras"] = {{"map", map->map.name},
                        {"title", map->map.title},
                        {"unit", map->map.unit},
                        {"low", map->scale.low / unit},
                        {"high", map->scale.high / unit}};
    }
    roots.push_back(document.add_node(std::move(node)));
  }
  write_whole_file(file, document.bytes(roots));
}

}  // namespace toile
