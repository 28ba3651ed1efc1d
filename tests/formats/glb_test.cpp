#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "formats/formats.h"

namespace toile {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Glb : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("toile_glb_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    // A tetrahedron for a body; two triangles sewn along one edge, each a panel, folded by a right angle.
    body_.name = "body";
    body_.positions.resize(3, 4);
    body_.positions << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
    body_.triangles.resize(3, 4);
    body_.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
    PanelMesh panel;
    panel.name = "front";
    panel.rest.resize(2, 3);
    panel.rest << 0, .1, 0, 0, 0, .1;
    panel.triangles = Eigen::Vector3i(0, 1, 2);
    for (int i = 0; i < 3; ++i) panel.boundary.push_back({i, i, 0});
    garment_.panels = {panel, panel};
    garment_.panels[1].name = "gore:2 \"Ärmel\"";
    garment_.welded = {Eigen::Vector3i(0, 1, 2), Eigen::Vector3i(0, 2, 3)};
    garment_.triangles.resize(3, 2);
    garment_.triangles << 0, 0, 1, 2, 2, 3;
    garment_.vertex_count = 4;
    worn_.resize(3, 4);
    worn_ << 0, .1, 0, 0, 1.2, 1.2, 1.3, 1.2, .5, .5, .5, .4;
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Checks the container (glTF 2.0, 4.4) and every view and accessor, and keeps JSON and buffer.
  void read(const ColouredMap* map = nullptr) {
    const fs::path file = folder_ / "drape.glb";
    write_glb(file, body_, garment_, worn_, map);
    bytes_ = read_whole_file(file).value.value();
    ASSERT_EQ(bytes_.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2u);
    EXPECT_EQ(word(8), bytes_.size());
    const std::size_t text = word(12);
    EXPECT_EQ(text % 4, 0u);
    EXPECT_EQ(bytes_.substr(16, 4), "JSON");
    json_ = Json::parse(bytes_.substr(20, text));
    const std::size_t length = word(20 + text);
    EXPECT_EQ(bytes_.substr(24 + text, 4), std::string("BIN\0", 4));
    ASSERT_EQ(28 + text + length, bytes_.size());
    buffer_ = bytes_.substr(28 + text);
    const std::size_t named = json_.at("buffers")[0].at("byteLength");
    EXPECT_LE(named, length);
    EXPECT_LE(length - named, 3u);
    for (const Json& view : json_.at("bufferViews"))
      EXPECT_LE(view.at("byteOffset").get<std::size_t>() + view.at("byteLength").get<std::size_t>(), named);
    for (const Json& accessor : json_.at("accessors")) {
      const Json& view = json_["bufferViews"][accessor.at("bufferView").get<std::size_t>()];
      EXPECT_EQ(view.at("byteOffset").get<int>() % 4, 0);
      EXPECT_EQ(size(accessor) * components(accessor) * accessor.at("count").get<std::size_t>(), view.at("byteLength"));
    }
  }

  std::uint32_t word(std::size_t at) const {
    std::uint32_t value;
    std::memcpy(&value, bytes_.data() + at, 4);
    return value;
  }
  static std::size_t size(const Json& accessor) { return accessor.at("componentType") == 5123 ? 2 : 4; }
  static std::size_t components(const Json& accessor) {
    return accessor.at("type") == "SCALAR" ? 1 : accessor.at("type") == "VEC3" ? 3 : 4;
  }
  template <class Number>
  std::vector<Number> numbers(std::size_t accessor_number) const {
    const Json& accessor = json_.at("accessors")[accessor_number];
    const Json& view = json_.at("bufferViews")[accessor.at("bufferView").get<std::size_t>()];
    std::vector<Number> values(accessor.at("count").get<std::size_t>() * components(accessor));
    std::memcpy(values.data(), buffer_.data() + view.at("byteOffset").get<std::size_t>(), values.size() * sizeof(Number));
    return values;
  }
  const Json& node(const std::string& name) const {
    for (const Json& node : json_.at("nodes"))
      if (node.at("name") == name) return node;
    throw std::out_of_range(name);
  }
  const Json& primitive(const std::string& name) const {
    return json_.at("meshes")[node(name).at("mesh").get<std::size_t>()].at("primitives")[0];
  }
  std::size_t attribute(const std::string& name, const char* which) const {
    return primitive(name).at("attributes").at(which).get<std::size_t>();
  }

  fs::path folder_;
  Mannequin body_;
  GarmentMesh garment_;
  Eigen::Matrix3Xd worn_;
  std::string bytes_, buffer_;
  Json json_;
};

TEST_F(Glb, HasBodyAndPanelsByNameInMetres) {
  read();
  EXPECT_EQ(json_["asset"]["version"], "2.0");
  const Json& roots = json_["scenes"][0]["nodes"];
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_EQ(json_["nodes"][roots[0].get<std::size_t>()]["name"], "body");
  const Json& garment = json_["nodes"][roots[1].get<std::size_t>()];
  EXPECT_EQ(garment["name"], "garment");
  std::vector<std::string> names;
  for (const Json& child : garment["children"]) names.push_back(json_["nodes"][child.get<std::size_t>()]["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"front", "gore:2 \"Ärmel\""}));
  const auto positions = numbers<float>(attribute(names[1], "POSITION"));
  const auto corners = numbers<std::uint32_t>(primitive(names[1])["indices"].get<std::size_t>());
  ASSERT_EQ(corners.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_FLOAT_EQ(
          positions[3 * corners[k] + i],
          static_cast<float>(worn_(static_cast<Eigen::Index>(i), garment_.triangles(static_cast<Eigen::Index>(k), 1))));
  const Json& accessor = json_["accessors"][attribute("front", "POSITION")];
  EXPECT_FLOAT_EQ(accessor["min"][1], 1.2F);
  EXPECT_FLOAT_EQ(accessor["max"][1], 1.3F);
  EXPECT_TRUE(json_["materials"][primitive("front")["material"].get<std::size_t>()]["doubleSided"].get<bool>());
  EXPECT_FALSE(primitive("front")["attributes"].contains("COLOR_0"));
}

TEST_F(Glb, NormalsAreUnitAndOneAcrossASeam) {
  read();
  for (const Json& mesh : json_["meshes"]) {
    const auto normals = numbers<float>(mesh["primitives"][0]["attributes"]["NORMAL"].get<std::size_t>());
    for (std::size_t v = 0; v < normals.size(); v += 3)
      EXPECT_NEAR(std::hypot(normals[v], normals[v + 1], normals[v + 2]), 1, 1e-6);
  }
  const auto front = numbers<float>(attribute("front", "NORMAL"));
  const auto back = numbers<float>(attribute("gore:2 \"Ärmel\"", "NORMAL"));
  // Panel vertices 0 and 2 of the front are 0 and 1 of the other; between triangles facing +Z and -X.
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(front[i], back[i]);
    EXPECT_EQ(front[6 + i], back[3 + i]);
  }
  EXPECT_NEAR(front[0], -std::sqrt(.5), 1e-6);
  EXPECT_NEAR(front[2], std::sqrt(.5), 1e-6);
}

TEST_F(Glb, MapOfVerticesIsLinearLightWithItsValues) {
  ColouredMap map;
  map.map = {.name = "ease", .title = "ease", .unit = "mm", .unit_size = 1e-3, .values = Eigen::Vector4d(0, .01, .02, .03)};
  map.scale = {0, .02};
  map.colours.resize(3, 4);
  map.colours << 0, 1, .5, .2, 0, 1, .5, .4, 0, 1, .5, .6;
  read(&map);
  const auto values = numbers<float>(attribute("gore:2 \"Ärmel\"", "_VALUE"));
  EXPECT_EQ(values, (std::vector<float>{0, 20, 30}));
  const auto colours = numbers<std::uint16_t>(attribute("front", "COLOR_0"));
  ASSERT_EQ(colours.size(), 12u);
  EXPECT_EQ(colours[0], 0);
  EXPECT_EQ(colours[4], 65535);
  EXPECT_NEAR(colours[8] / 65535.0, 0.21404, 1e-4);  // IEC 61966-2-1
  EXPECT_EQ(colours[11], 65535);
  const Json& extras = node("garment")["extras"];
  EXPECT_EQ(extras["unit"], "mm");
  EXPECT_NEAR(extras["high"].get<double>(), 20, 1e-9);
}

TEST_F(Glb, MapOfTrianglesKeepsTheColourOfEachTriangle) {
  // One panel of two triangles that share an edge.
  garment_.panels.resize(1);
  garment_.panels[0].rest.resize(2, 4);
  garment_.panels[0].rest << 0, .1, .1, 0, 0, 0, .1, .1;
  garment_.panels[0].triangles = garment_.triangles;
  garment_.panels[0].boundary = {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}};
  garment_.welded = {Eigen::Vector4i(0, 1, 2, 3)};
  ColouredMap map;
  map.map = {.name = "s", .unit = "%", .unit_size = .01, .of = MapOf::triangle, .values = Eigen::Vector2d(.01, -.02)};
  map.colours.resize(3, 2);
  map.colours << 1, 0, 0, 0, 0, 1;
  read(&map);
  const auto values = numbers<float>(attribute("front", "_VALUE"));
  EXPECT_EQ(values, (std::vector<float>{1, 1, 1, -2, -2, -2}));
  const auto colours = numbers<std::uint16_t>(attribute("front", "COLOR_0"));
  for (std::size_t v = 0; v < 6; ++v) EXPECT_EQ(colours[4 * v] > 0, v < 3) << v;
  const auto corners = numbers<std::uint32_t>(primitive("front")["indices"].get<std::size_t>());
  EXPECT_EQ(corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
}

TEST_F(Glb, SameInputSameBytesAndWrongInputIsRefused) {
  read();
  const std::string before = bytes_;
  read();
  EXPECT_EQ(bytes_, before);
  ColouredMap map;
  map.map.values = Eigen::Vector2d(1, 2);
  const fs::path file = folder_ / "none.glb";
  EXPECT_THROW(write_glb(file, body_, garment_, worn_, &map), std::invalid_argument);
  EXPECT_THROW(write_glb(file, body_, garment_, worn_.leftCols(2)), std::invalid_argument);
  worn_(1, 1) = NAN;
  EXPECT_THROW(write_glb(file, body_, garment_, worn_), std::invalid_argument);
  EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace toile
