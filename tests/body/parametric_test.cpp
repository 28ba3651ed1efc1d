#include "body/parametric.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <set>

#include "body/girth.h"
#include "garment/report.h"

namespace toile {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

#if defined(__SANITIZE_ADDRESS__)
constexpr int every = 6;  // sizes; each takes ten times as long
#else
constexpr int every = 1;
#endif

SizeChartRow row_of(bool female, double height, double bust, double waist, double hip, const std::string& size = "x") {
  return {female ? "women" : "men", size, female, height, bust, waist, hip, {}};
}

// The sizes of the charts in templates/mannequins: bust, waist, hip by size.
std::vector<SizeChartRow> chart_rows() {
  std::vector<SizeChartRow> rows;
  for (int size = 32; size <= 52; size += 2) {
    const double steps = (size - 32) / 2, beyond = std::max(0., (size - 46) / 2.);
    rows.push_back(row_of(true, 1.68, .76 + .04 * steps + .02 * beyond, .58 + .04 * steps + .02 * beyond,
                          .82 + .04 * steps + .02 * beyond, std::to_string(size)));
  }
  const double heights[] = {1.68, 1.71, 1.74, 1.77, 1.80, 1.82, 1.84};
  for (int i = 0; i < 7; ++i)
    rows.push_back(row_of(false, heights[i], .88 + .04 * i, .78 + .04 * i + (i == 6 ? .02 : 0),
                          .90 + .04 * i + (i == 6 ? .02 : 0), std::to_string(44 + 2 * i)));
  return rows;
}

Mesh mesh_of(const Mannequin& body) {
  Mesh mesh;
  for (Eigen::Index i = 0; i < body.positions.cols(); ++i)
    mesh.add_vertex({body.positions(0, i), body.positions(1, i), body.positions(2, i)});
  for (Eigen::Index t = 0; t < body.triangles.cols(); ++t) {
    const auto vertex = [&](int k) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(body.triangles(k, t))); };
    EXPECT_NE(mesh.add_face(vertex(0), vertex(1), vertex(2)), Mesh::null_face()) << "not a manifold at triangle " << t;
  }
  return mesh;
}

double volume(const Mannequin& body) {
  double sum = 0;
  for (Eigen::Index t = 0; t < body.triangles.cols(); ++t) {
    const auto corner = [&](int k) -> Eigen::Vector3d { return body.positions.col(body.triangles(k, t)); };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return sum;
}

void expect_sound(const Mannequin& body) {
  ASSERT_TRUE(body.positions.allFinite()) << body.name;
  Mesh mesh = mesh_of(body);
  EXPECT_TRUE(CGAL::is_closed(mesh)) << body.name;
  const int euler = static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
                    static_cast<int>(mesh.number_of_faces());
  EXPECT_EQ(euler, 2) << body.name << " is not one sphere";
  const auto part = mesh.add_property_map<Mesh::Face_index, std::size_t>("part", 0).first;
  EXPECT_EQ(CGAL::Polygon_mesh_processing::connected_components(mesh, part), 1u) << body.name;
  EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(mesh)) << body.name;
  EXPECT_GT(volume(body), .025) << body.name << " is not oriented outwards";
  EXPECT_NEAR(body.positions.row(1).minCoeff(), 0, 1e-6) << body.name << " does not stand on the floor";
  EXPECT_NEAR(body.positions.row(1).maxCoeff(), body.height, 4e-3) << body.name;
}

void expect_girths(const Mannequin& body, const SizeChartRow& row) {
  const auto taped = [&](const char* level) { return trunk_girth(body.positions, body.triangles, body.landmarks.at(level)); };
  EXPECT_NEAR(taped("bust"), row.bust, 5e-3) << body.name;
  EXPECT_NEAR(taped("waist"), row.waist, 5e-3) << body.name;
  EXPECT_NEAR(taped("hip"), row.hip, 5e-3) << body.name;
  for (const auto& [name, girth] : row.others)
    if (body.measures.count(name)) {
      EXPECT_NEAR(body.measures.at(name), girth, 5e-3) << body.name << " " << name;
    }
}

TEST(ParametricMannequin, HoldsTheGirthsOfEverySizeAndIsOneClosedBodyWithoutSelfIntersection) {
  const std::vector<SizeChartRow> rows = chart_rows();
  for (std::size_t i = 0; i < rows.size(); i += every) {
    const Mannequin body = build_mannequin(rows[i]);
    expect_sound(body);
    expect_girths(body, rows[i]);
  }
}

TEST(ParametricMannequin, FitsBodiesThatAreInNoChart) {
  const std::vector<SizeChartRow> rows = {row_of(true, 1.55, .90, .73, .97),     row_of(true, 1.55, 1.28, 1.14, 1.36),
                                          row_of(true, 1.90, .86, .68, .95),     row_of(true, 1.75, 1.34, 1.20, 1.42),
                                          row_of(false, 1.62, 1.20, 1.22, 1.18), row_of(false, 1.98, .98, .86, 1.03)};
  for (std::size_t i = 0; i < rows.size(); i += (every + 1) / 2) {
    const Mannequin body = build_mannequin(rows[i], {.edge_length = 18e-3});
    expect_sound(body);
    expect_girths(body, rows[i]);
  }
}

TEST(ParametricMannequin, TakesTheOtherMeasuresOfTheRow) {
  SizeChartRow row = row_of(true, 1.68, .88, .70, .94);
  row.others = {{"upper_arm", .31}, {"thigh", .60},    {"neck", .36}, {"wrist", .155},
                {"underbust", .76}, {"high_hip", .83}, {"calf", .37}};
  const Mannequin body = build_mannequin(row, {.edge_length = 18e-3});
  expect_girths(body, row);
  row.others = {{"inside_leg", .80}};
  const Mannequin leggy = build_mannequin(row, {.edge_length = 18e-3});
  EXPECT_NEAR(leggy.landmarks.at("crotch"), .80, 1e-9);
  expect_girths(leggy, row);
  // The surface between the legs is where the landmark says.
  EXPECT_GT(trunk_girth(leggy.positions, leggy.triangles, .806), 0);
  EXPECT_EQ(trunk_girth(leggy.positions, leggy.triangles, .792), 0);
}

TEST(ParametricMannequin, IsTheSameEveryTime) {
  const SizeChartRow row = row_of(true, 1.71, .95, .76, 1.01);
  EXPECT_EQ(build_mannequin(row, {.edge_length = 18e-3}), build_mannequin(row, {.edge_length = 18e-3}));
}

TEST(ParametricMannequin, IsSymmetric) {
  const Mannequin body = build_mannequin(row_of(true, 1.68, .88, .70, .94), {.edge_length = 18e-3});
  std::set<std::array<double, 3>> points;
  for (Eigen::Index i = 0; i < body.positions.cols(); ++i)
    points.insert({body.positions(0, i), body.positions(1, i), body.positions(2, i)});
  for (const auto& [x, y, z] : points) EXPECT_TRUE(points.count({x == 0 ? 0 : -x, y, z})) << x << " " << y << " " << z;
}

TEST(ParametricMannequin, HasTheSameTrianglesInEverySize) {
  const Mannequin small = build_mannequin(row_of(true, 1.60, .80, .62, .86), {.edge_length = 18e-3});
  const Mannequin large = build_mannequin(row_of(false, 1.84, 1.12, 1.04, 1.16), {.edge_length = 18e-3});
  EXPECT_EQ(small.triangles, large.triangles);
  // And a triangle lies at the same part of the body: knees at knees, hands at hands.
  for (Eigen::Index i = 0; i < small.positions.cols(); ++i)
    EXPECT_NEAR(small.positions(1, i) / small.height, large.positions(1, i) / large.height, .06);
}

TEST(ParametricMannequin, TrianglesKeepTheirSizeAndShape) {
  const Mannequin body = build_mannequin(row_of(true, 1.68, .88, .70, .94));
  EXPECT_GT(body.triangles.cols(), 9000);
  EXPECT_LT(body.triangles.cols(), 20000);
  double longest = 0;
  int thin = 0;
  for (Eigen::Index t = 0; t < body.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = body.positions.col(body.triangles(k, t)),
                            b = body.positions.col(body.triangles((k + 1) % 3, t)),
                            c = body.positions.col(body.triangles((k + 2) % 3, t));
      longest = std::max(longest, (b - a).norm());
      thin += std::acos((b - a).normalized().dot((c - a).normalized())) < .35;
    }
  EXPECT_LT(longest, 3 * 14e-3);
  EXPECT_LT(thin, body.triangles.cols() / 100) << "angles below 20 degrees";
}

TEST(ParametricMannequin, SkeletonHangsTogetherInsideTheBody) {
  for (const bool female : {true, false}) {
    const Mannequin body = build_mannequin(row_of(female, 1.75, 1.0, .84, 1.04), {.edge_length = 18e-3});
    for (const char* name : {"pelvis",     "spine_low", "spine_mid", "chest",   "neck",   "head",   "clavicle.L",
                             "upperarm.L", "forearm.L", "hand.L",    "thigh.L", "shin.L", "foot.L", "clavicle.R",
                             "upperarm.R", "forearm.R", "hand.R",    "thigh.R", "shin.R", "foot.R"})
      ASSERT_NE(find_bone(body, name), nullptr) << name;
    for (const Bone& bone : body.bones) {
      if (bone.parent.empty()) continue;
      ASSERT_NE(find_bone(body, bone.parent), nullptr) << bone.name;
      // Solid angle of the surface seen from the middle of the bone: 4 pi inside, 0 outside (van Oosterom and Strackee).
      const Eigen::Vector3d middle = (bone.from + bone.to) / 2;
      double angle = 0;
      for (Eigen::Index t = 0; t < body.triangles.cols(); ++t) {
        const Eigen::Vector3d a = body.positions.col(body.triangles(0, t)) - middle,
                              b = body.positions.col(body.triangles(1, t)) - middle,
                              c = body.positions.col(body.triangles(2, t)) - middle;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
      }
      EXPECT_NEAR(angle, 4 * 3.14159265, 1e-3) << bone.name;
    }
  }
}

TEST(ParametricMannequin, LandmarksClimbAsOnABody) {
  const Mannequin body = build_mannequin(row_of(true, 1.68, .88, .70, .94), {.edge_length = 18e-3});
  double below = -1;
  for (const char* name : {"floor", "ankle", "calf", "knee", "crotch", "hip", "seat", "high_hip", "waist", "underbust", "bust",
                           "armpit", "shoulder", "nape", "height"}) {
    ASSERT_TRUE(body.landmarks.count(name)) << name;
    EXPECT_GT(body.landmarks.at(name), below) << name;
    below = body.landmarks.at(name);
  }
}

TEST(ParametricMannequin, ArmsHang45DegreesDown) {
  const Mannequin body = build_mannequin(row_of(true, 1.68, .88, .70, .94), {.edge_length = 18e-3});
  const Bone& arm = *find_bone(body, "upperarm.L");
  EXPECT_GT(arm.to.x(), arm.from.x()) << "the wearer's left is +X";
  EXPECT_NEAR(std::atan2(arm.from.y() - arm.to.y(), arm.to.x() - arm.from.x()), .785398, .02);
  EXPECT_GT(find_bone(body, "foot.L")->to.z(), find_bone(body, "foot.L")->from.z()) << "it faces +Z";
}

std::string refusal(const SizeChartRow& row) {
  try {
    build_mannequin(row, {.edge_length = 18e-3});
  } catch (const BadInput& bad) {
    return bad.finding().code + ": " + bad.finding().text;
  }
  return "";
}

TEST(ParametricMannequin, RefusesRowsThatAreNoBody) {
  EXPECT_NE(refusal(row_of(true, 168, 88, 70, 94)).find("chart.implausible"), std::string::npos)
      << "centimetres taken for metres";
  EXPECT_NE(refusal(row_of(true, 1.68, .88, .20, .94)).find("waist"), std::string::npos);
  EXPECT_NE(refusal(row_of(true, 1.68, -.88, .70, .94)).find("chart.implausible"), std::string::npos);
  SizeChartRow row = row_of(true, 1.68, .88, .70, .94);
  row.others = {{"upper_arm", .90}};
  EXPECT_NE(refusal(row).find("upper_arm"), std::string::npos);
  row.others = {{"underbust", .90}};
  EXPECT_NE(refusal(row).find("underbust"), std::string::npos);
  EXPECT_THROW(build_mannequin(row_of(true, 1.68, .88, .70, .94), {.edge_length = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace toile
