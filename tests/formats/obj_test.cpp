#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "body/body.h"
#include "formats/folder.h"
#include "formats/formats.h"
#include "formats/obj/mesh_text.h"

namespace toile {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::Folder;

// The first error, "CODE @ PLACE".
std::string error_of(const Report& report) {
  for (const Finding& finding : report.findings)
    if (finding.severity == Severity::error) return finding.code + " @ " + finding.place;
  return "none";
}

std::string mesh_error(const std::string& text) {
  const auto loaded = read_obj_mesh(text, "a.obj");
  EXPECT_EQ(loaded.value.has_value(), loaded.report.ok());
  for (const Finding& finding : loaded.report.findings) {
    EXPECT_FALSE(finding.text.empty());
    EXPECT_TRUE(finding.severity != Severity::error || !finding.remedy.empty());
  }
  return error_of(loaded.report);
}

constexpr const char* cube = R"(# a cube of quads, metres
o cube
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
g sides
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
g more
f 3 4 8 7
f -8//1 -4//1 -1//1 -5//1
)";

double volume(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  double sum = 0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    Eigen::Matrix3d corners;
    for (int c = 0; c < 3; ++c) corners.col(c) = positions.col(triangles(c, t));
    sum += corners.col(0).dot(corners.col(1).cross(corners.col(2))) / 6;
  }
  return sum;
}

TEST(ObjMesh, SplitsPolygonsAndKeepsTheirSense) {
  const auto loaded = read_obj_mesh(cube, "cube.obj");
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->positions.cols(), 8);
  EXPECT_EQ(loaded.value->triangles.cols(), 12);
  EXPECT_NEAR(volume(loaded.value->positions, loaded.value->triangles), 1, 1e-12);
}

TEST(ObjMesh, ReadsWindowsLineEndsTabsAndExponents) {
  std::string text = "v\t0 0 0\r\nv 1e0 0 0\r\nv 0 +1.0E+00 0 \r\nf 1 2 3 \r\n";
  const auto loaded = read_obj_mesh(text, "a.obj");
  ASSERT_TRUE(loaded.value) << error_of(loaded.report);
  EXPECT_EQ(loaded.value->positions.col(1), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(loaded.value->positions.col(2), Eigen::Vector3d(0, 1, 0));
}

TEST(ObjMesh, JoinsVerticesThatTextureSeamsTore) {
  std::string text;
  for (const char* corner : {"0 0 0", "1 0 0", "0 1 0", "0 0 1"}) text += std::string("v ") + corner + "\n";
  for (const char* corner : {"0 0 0", "1 0 0", "0 1 0", "0 0 1"}) text += std::string("v ") + corner + "\n";
  text += "f 1 3 2\nf 5 6 8\nf 2 3 4\nf 1 8 7\n";
  const auto loaded = read_obj_mesh(text, "a.obj");
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->positions.cols(), 4);
  ASSERT_EQ(loaded.report.findings.size(), 1u);
  EXPECT_EQ(loaded.report.findings[0].code, "obj.welded");
  EXPECT_NEAR(volume(loaded.value->positions, loaded.value->triangles), 1. / 6, 1e-12);
}

TEST(ObjMesh, NamesTheLineOfWhatIsWrong) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(mesh_error(three + "v 0 nan 0\nf 1 2 3\n"), "body.not-finite @ a.obj:4");
  EXPECT_EQ(mesh_error(three + "v 0 0 -inf\nf 1 2 3\n"), "body.not-finite @ a.obj:4");
  EXPECT_EQ(mesh_error(three + "v 0 1,5 0\nf 1 2 3\n"), "obj.not-a-number @ a.obj:4");
  EXPECT_EQ(mesh_error(three + "f 1 2 3\nv 0 1"), "obj.not-a-number @ a.obj:5");
  EXPECT_EQ(mesh_error(three + "f 1 2\n"), "obj.bad-face @ a.obj:4");
  EXPECT_EQ(mesh_error(three + "f 1 2 0\n"), "obj.bad-face @ a.obj:4");
  EXPECT_EQ(mesh_error(three + "f 1 2 x/3\n"), "obj.bad-face @ a.obj:4");
  EXPECT_EQ(mesh_error(three + "f 1 2 3\nf 1 3 4\n"), "obj.no-such-vertex @ a.obj:5");
  EXPECT_EQ(mesh_error(three + "f 1 2 -4\n"), "obj.no-such-vertex @ a.obj:4");
  EXPECT_EQ(mesh_error(three), "obj.no-faces @ a.obj");
  EXPECT_EQ(mesh_error(""), "obj.no-faces @ a.obj");
  EXPECT_EQ(mesh_error(std::string("PK\x03\x04\0\0v\0f\n\xff\xfe", 12)), "obj.no-faces @ a.obj");
}

TEST(ReadBody, FindsTheSkeletonOfTheBodyAndOfItsWrap) {
  const Folder folder;
  folder.write("tom.skeleton.json", R"({"name": "Tom", "landmarks_m": {"hip_y": 0.5, "height": 0.995}})");
  folder.write("tom_wrap.obj", cube);
  folder.write("tom.obj", cube);
  folder.write("other.obj", cube);
  for (const char* name : {"tom.obj", "tom_wrap.obj"}) {
    const auto loaded = read_body(folder / name);
    ASSERT_TRUE(loaded.value) << name;
    EXPECT_EQ(loaded.value->name, "Tom");
    EXPECT_EQ(loaded.value->landmarks.at("hip"), .5);
    EXPECT_EQ(loaded.value->height, .995);  // as stated, 5 mm below the mesh
  }
  const auto other = read_body(folder / "other.obj");
  ASSERT_TRUE(other.value);
  EXPECT_EQ(other.value->name, "other");
  EXPECT_EQ(other.value->height, 1);
  EXPECT_TRUE(other.value->landmarks.empty());
  EXPECT_EQ(read_body(folder / "other.obj", folder / "tom.skeleton.json").value->name, "Tom");
}

TEST(ReadBody, ReportsWhatIsMissing) {
  const Folder folder;
  const auto no_body = read_body(folder / "nobody.obj");
  EXPECT_FALSE(no_body.value);
  EXPECT_EQ(error_of(no_body.report), "file.missing @ " + (folder / "nobody.obj").string());
  EXPECT_EQ(no_body.report.findings[0].fault, Fault::missing);
  folder.write("a.obj", cube);
  EXPECT_EQ(error_of(read_body(folder / "a.obj", folder / "b.json").report), "file.missing @ " + (folder / "b.json").string());
  EXPECT_EQ(error_of(read_body(folder.path()).report), "file.unreadable @ " + folder.path().string());
}

GarmentMesh two_panels() {
  GarmentMesh garment;
  PanelMesh left;
  left.name = "front left";
  left.rest.resize(2, 4);
  left.rest << 0, .1, .1, 0, 0, 0, .2, .2;
  left.triangles.resize(3, 2);
  left.triangles << 0, 0, 1, 2, 2, 3;
  left.boundary = {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}};
  PanelMesh right = left;
  right.name = "front:2";
  right.rest.row(0).array() += 1. / 3;
  garment.panels = {left, right};
  garment.welded = {Eigen::Vector4i(0, 1, 2, 3), Eigen::Vector4i(1, 4, 5, 2)};
  garment.triangles.resize(3, 4);
  garment.triangles << 0, 0, 1, 1, 1, 2, 4, 5, 2, 3, 5, 2;
  garment.vertex_count = 6;
  return garment;
}

TEST(WriteObj, GivesOnePositionPerWeldedVertexAndOneRestPositionPerPanelVertex) {
  const Folder folder;
  const GarmentMesh garment = two_panels();
  Eigen::Matrix3Xd positions = Eigen::Matrix3Xd::Random(3, 6);
  positions(0, 0) = -1e-12;
  write_obj(folder / "drape.obj", garment, positions);
  std::istringstream text(contents(folder / "drape.obj"));
  std::vector<Eigen::Vector3d> v;
  std::vector<Eigen::Vector2d> vt;
  std::vector<std::string> groups;
  std::vector<std::array<int, 6>> faces;
  for (std::string line, word; std::getline(text, line);) {
    std::istringstream fields(line);
    fields >> word;
    if (word == "v") fields >> v.emplace_back()[0] >> v.back()[1] >> v.back()[2];
    if (word == "vt") fields >> vt.emplace_back()[0] >> vt.back()[1];
    if (word == "g") groups.push_back(line.substr(2));
    char slash;
    if (word == "f") {
      auto& f = faces.emplace_back();
      for (std::size_t c = 0; c < 6; c += 2) fields >> f[c] >> slash >> f[c + 1];
    }
  }
  ASSERT_EQ(v.size(), 6u);
  ASSERT_EQ(vt.size(), 8u);
  ASSERT_EQ(faces.size(), 4u);
  EXPECT_EQ(groups, (std::vector<std::string>{"front_left", "front:2"}));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_LT((v[i] - positions.col(static_cast<Eigen::Index>(i))).norm(), 1e-9);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_LT((vt[i] - garment.panels[i / 4].rest.col(static_cast<Eigen::Index>(i % 4))).norm(), 1e-9);
  EXPECT_EQ(faces[2], (std::array<int, 6>{2, 5, 5, 6, 6, 7}));
  EXPECT_EQ(contents(folder / "drape.obj").find("-0.000000000"), std::string::npos);
  EXPECT_EQ(folder.entries(), 1u);

  write_obj(folder / "again.obj", garment, positions);
  EXPECT_EQ(contents(folder / "drape.obj"), contents(folder / "again.obj"));
}

TEST(WriteObj, RefusesWhatIsNoDrape) {
  const Folder folder;
  EXPECT_THROW(write_obj(folder / "a.obj", two_panels(), Eigen::Matrix3Xd::Zero(3, 5)), std::invalid_argument);
  Eigen::Matrix3Xd broken = Eigen::Matrix3Xd::Zero(3, 6);
  broken(1, 1) = std::nan("");
  EXPECT_THROW(write_obj(folder / "a.obj", two_panels(), broken), std::invalid_argument);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(WriteObj, BodyAndSkeletonComeBackAsTheyWere) {
  const Folder folder;
  Mannequin body;
  const auto mesh = read_obj_mesh(cube, "cube.obj");
  body.name = "form 38";
  body.positions = mesh.value->positions.array() + 1. / 7;
  body.triangles = mesh.value->triangles;
  body.bones = {{"pelvis", "", {0, .5, 0}, {0, .6, 0}}, {"thigh.L", "pelvis", {.1, .5, 0}, {.1, .25, 1. / 3}}};
  body.landmarks = {{"high_hip", .6}, {"waist", .65}, {"elbow", .5}};
  body.measures = {{"high_hip", .8}, {"waist", .7}, {"upper_arm", .28}, {"thigh", .5}};
  body.height = 1;
  write_obj(folder / "form.obj", body);
  write_skeleton(folder / "form.skeleton.json", body);
  const auto back = read_body(folder / "form.obj");
  ASSERT_TRUE(back.value) << error_of(back.report);
  EXPECT_LT((back.value->positions - body.positions).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(back.value->triangles, body.triangles);
  EXPECT_EQ(back.value->name, "form 38");
  EXPECT_EQ(back.value->height, 1);
  EXPECT_EQ(back.value->landmarks, body.landmarks);
  EXPECT_EQ(back.value->measures, body.measures);
  ASSERT_EQ(back.value->bones.size(), 2u);
  EXPECT_EQ(back.value->bones[1].parent, "pelvis");
  EXPECT_LT((back.value->bones[1].to - body.bones[1].to).norm(), 1e-7);
}

// Realistic bodies, not part of the project.
class Corpus : public testing::TestWithParam<const char*> {};

TEST_P(Corpus, BodyIsReadCheckedAndMadeReady) {
  const char* corpus = std::getenv("TOILE_CORPUS");
  if (!corpus) GTEST_SKIP() << "TOILE_CORPUS is not set";
  const fs::path file = fs::path(corpus) / "bodies" / (std::string(GetParam()) + "_A45_wrap.obj");
  const auto loaded = read_body(file);
  ASSERT_TRUE(loaded.value) << error_of(loaded.report);
  EXPECT_TRUE(loaded.report.findings.empty());
  EXPECT_TRUE(check_body(*loaded.value, file.string()).findings.empty());
  EXPECT_EQ(loaded.value->bones.size(), 20u);
  const bool small = std::string(GetParam()) == "f34_160";
  EXPECT_NEAR(loaded.value->height, small ? 1.603 : 1.680, 1e-3);
  EXPECT_NEAR(level_height(*loaded.value, "waist"), small ? 1.002 : 1.050, 1e-3);

  const Body body = make_body(*loaded.value);
  double sum = 0;
  Eigen::Index smooth = 0, trunk = 0;
  for (Eigen::Index v = 0; v < body.form.positions.cols(); ++v) {
    const Eigen::Vector3d at = body.form.positions.col(v);
    const double off = std::abs(body.distance.distance(at));
    sum += off;
    EXPECT_LT(off, 3e-3) << at.transpose();  // between fingers and toes the grid cannot do better
    if (at[1] < .2 || at[1] > 1.35 || std::abs(at[0]) > .3) continue;
    ++trunk;
    smooth += off < .3e-3;
  }
  EXPECT_LT(sum / static_cast<double>(body.form.positions.cols()), .15e-3);
  EXPECT_GT(static_cast<double>(smooth), .95 * static_cast<double>(trunk));
}

INSTANTIATE_TEST_SUITE_P(Bodies, Corpus, testing::Values("f38_168", "f34_160"));

}  // namespace
}  // namespace toile
