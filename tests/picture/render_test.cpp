#include "picture/render.h"

#include <gtest/gtest.h>

#include <numbers>

#include "picture/colour_space.h"

namespace toile {
namespace {

constexpr Colour red{.9, .1, .1}, green{.1, .8, .1}, white{1, 1, 1};

// Upright triangle about the origin at depth z, facing +z.
ShownMesh triangle(const Colour& colour, double z, double size = 1) {
  ShownMesh mesh;
  mesh.positions.resize(3, 3);
  mesh.positions << -size, size, 0, -size, -size, size, z, z, z;
  mesh.triangles.resize(3, 1);
  mesh.triangles << 0, 1, 2;
  mesh.colours = {colour};
  return mesh;
}

ShownMesh sphere(int rings, const Colour& colour) {
  ShownMesh mesh;
  const int around = 2 * rings;
  mesh.positions.resize(3, (rings + 1) * around);
  mesh.triangles.resize(3, 2 * rings * around);
  Eigen::Index t = 0;
  for (int j = 0; j <= rings; ++j)
    for (int i = 0; i < around; ++i) {
      const double polar = std::numbers::pi * j / rings, turn = 2 * std::numbers::pi * i / around;
      mesh.positions.col(j * around + i) << std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn);
      if (j == rings) continue;
      const int a = j * around + i, b = j * around + (i + 1) % around;
      mesh.triangles.col(t++) << a, a + around, b + around;
      mesh.triangles.col(t++) << a, b + around, b;
    }
  mesh.colours = {colour};
  return mesh;
}

View small_view() {
  View view;
  view.width = 60;
  view.height = 50;
  return view;
}

bool redder(const Colour& a) { return a.red > 2 * a.green && a.red > 2 * a.blue; }
bool greener(const Colour& a) { return a.green > 2 * a.red && a.green > 2 * a.blue; }

TEST(Render, ATriangleCoversTheMiddleAndLeavesTheCornersFree) {
  const Image image = render({.meshes = {triangle(red, 0)}, .lines = {}}, small_view());
  ASSERT_EQ(image.pixels.size(), 3u * 60 * 50);
  EXPECT_TRUE(redder(pixel(image, 30, 30)));
  EXPECT_EQ(pixel(image, 2, 2), white);
  EXPECT_EQ(pixel(image, 57, 2), white);
}

TEST(Render, NearerWinsWhateverTheOrder) {
  for (const double angle : {0.0, 0.35}) {
    View view = small_view();
    view.angle = angle;
    const ShownMesh near = triangle(red, .5, .6), far = triangle(green, -.5);
    const Image one = render({.meshes = {near, far}, .lines = {}}, view);
    EXPECT_TRUE(redder(pixel(one, 30, 28)));
    EXPECT_EQ(one, render({.meshes = {far, near}, .lines = {}}, view));
    view.towards_viewer = -Eigen::Vector3d::UnitZ();
    EXPECT_TRUE(greener(pixel(render({.meshes = {near, far}, .lines = {}}, view), 30, 28)));
  }
}

TEST(Render, TriangleSeesItsBackDarker) {
  View view = small_view();
  const Colour front = pixel(render({.meshes = {triangle(red, 0)}, .lines = {}}, view), 30, 30);
  view.towards_viewer = -Eigen::Vector3d::UnitZ();
  const Colour back = pixel(render({.meshes = {triangle(red, 0)}, .lines = {}}, view), 30, 30);
  EXPECT_NEAR(to_linear(back.red), 0.55 * to_linear(front.red), .01);
}

TEST(Render, AShapeThatFillsItsFrameTouchesTheMargins) {
  for (const double angle : {0.0, 0.35, 0.8})
    for (const Eigen::Vector3d& from : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, .7, 1)}) {
      View view;
      view.width = view.height = 200;
      view.margin = .1;
      view.angle = angle;
      view.towards_viewer = from;
      const Image image = render({.meshes = {sphere(40, red)}, .lines = {}}, view);
      int left = 200, right = -1, top = 200, bottom = -1;
      for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x)
          if (pixel(image, x, y) != white) {
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
          }
      EXPECT_GE(std::min(left, top), 19);
      EXPECT_LE(std::max(right, bottom), 180);
      EXPECT_GE(right - left, 157);  // a ball is as large from every side
      EXPECT_GE(bottom - top, 157);
    }
}

TEST(Render, LightComesFromAboveAndTheLeft) {
  View view;
  view.width = view.height = 200;
  const Image image = render({.meshes = {sphere(40, {.6, .6, .6})}, .lines = {}}, view);
  const double upper_left = pixel(image, 70, 60).red, middle = pixel(image, 100, 100).red,
               lower_right = pixel(image, 150, 160).red;
  EXPECT_GT(upper_left, middle);
  EXPECT_GT(middle, lower_right);
  EXPECT_GT(lower_right, .2);  // the fill light reaches it
}

TEST(Render, ColoursGoByVertexOrByTriangle) {
  ShownMesh mesh = triangle(red, 0);
  mesh.colours = {red, green, red};
  View view = small_view();
  const Image by_vertex = render({.meshes = {mesh}, .lines = {}}, view);
  EXPECT_TRUE(redder(pixel(by_vertex, 10, 46)));
  EXPECT_TRUE(greener(pixel(by_vertex, 50, 46)));

  ShownMesh square;
  square.positions.resize(3, 4);
  square.positions << -1, 1, 1, -1, -1, -1, 1, 1, 0, 0, 0, 0;
  square.triangles.resize(3, 2);
  square.triangles << 0, 0, 1, 2, 2, 3;
  square.colours = {red, green};
  const Image by_triangle = render({.meshes = {square}, .lines = {}}, view);
  EXPECT_TRUE(redder(pixel(by_triangle, 42, 40)));
  EXPECT_TRUE(greener(pixel(by_triangle, 18, 12)));
}

TEST(Render, LinesShowOnTheirSurfaceAndHideBehindIt) {
  const ShownMesh mesh = triangle(red, 0);
  const ShownLine line{{{-.5, -.4, 0}, {.5, -.4, 0}}, {0, 0, 0}, 3};
  View view = small_view();
  const auto darkest = [&](const Image& image) {
    double least = 1;
    for (int y = 0; y < view.height; ++y) least = std::min(least, pixel(image, 30, y).red);
    return least;
  };
  EXPECT_LT(darkest(render({.meshes = {mesh}, .lines = {line}}, view)), .05);
  view.towards_viewer = -Eigen::Vector3d::UnitZ();
  const ShownLine behind{{{-.5, -.4, .3}, {.5, -.4, .3}}, {0, 0, 0}, 3};
  EXPECT_GT(darkest(render({.meshes = {mesh}, .lines = {behind}}, view)), .3);
}

TEST(Render, EdgesAreSmooth) {
  const Image image = render({.meshes = {triangle(red, 0)}, .lines = {}}, small_view());
  int between = 0;
  const double full = pixel(image, 30, 30).green;
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 60; ++x) {
      const double g = pixel(image, x, y).green;
      between += g > full + .05 && g < .95;
    }
  EXPECT_GT(between, 40);
}

TEST(Render, TheSameSceneTheSameBytes) {
  const Scene3D scene{.meshes = {sphere(20, green)}, .lines = {}};
  EXPECT_EQ(png_bytes(render(scene, small_view())), png_bytes(render(scene, small_view())));
}

TEST(Render, RefusesBrokenScenes) {
  ShownMesh mesh = triangle(red, 0);
  mesh.positions(0, 0) = NAN;
  EXPECT_THROW(render({.meshes = {mesh}, .lines = {}}, small_view()), std::invalid_argument);
  mesh = triangle(red, 0);
  mesh.triangles(0, 0) = 3;
  EXPECT_THROW(render({.meshes = {mesh}, .lines = {}}, small_view()), std::invalid_argument);
  mesh = triangle(red, 0);
  mesh.colours = {red, green};
  EXPECT_THROW(render({.meshes = {mesh}, .lines = {}}, small_view()), std::invalid_argument);
  View down = small_view();
  down.towards_viewer = Eigen::Vector3d::UnitY();
  EXPECT_THROW(render({.meshes = {triangle(red, 0)}, .lines = {}}, down), std::invalid_argument);
  EXPECT_THROW(render({}, small_view()), std::invalid_argument);
}

}  // namespace
}  // namespace toile
