#include "picture/stuck.h"

#include <gtest/gtest.h>

#include "picture/worn.h"

namespace toile {
namespace {

// Two squares of 40 cm sewn along x = 0, in front of a tube of a body.
struct Sewn {
  Mannequin body;
  GarmentMesh garment;
  std::vector<Eigen::Matrix3Xd> panels;
};

Sewn sewn(double gap) {
  Sewn made;
  test::tube(.15, 0, 1.6, 24, 8, made.body.positions, made.body.triangles);
  for (const int side : {-1, 1}) {
    PanelMesh panel;
    panel.name = side < 0 ? "right" : "left";
    panel.rest.resize(2, 4);
    panel.rest << 0, .4, .4, 0, 0, 0, .4, .4;
    panel.triangles.resize(3, 2);
    panel.triangles << 0, 0, 1, 2, 2, 3;
    for (int i = 0; i < 4; ++i) panel.boundary.push_back({i, i, 0});
    Eigen::Matrix3Xd at = Eigen::Matrix3Xd::Constant(3, 4, .3);
    at.row(0) = panel.rest.row(0).array() + (side < 0 ? -.4 - gap / 2 : gap / 2);
    at.row(1) = panel.rest.row(1).array() + .6;
    made.garment.panels.push_back(panel);
    made.panels.push_back(at);
  }
  made.garment.welded = {Eigen::Vector4i(0, 1, 2, 3), Eigen::Vector4i(1, 4, 5, 2)};
  made.garment.triangles.resize(3, 4);
  made.garment.triangles << 0, 0, 1, 1, 1, 2, 4, 5, 2, 3, 5, 2;
  made.garment.vertex_count = 6;
  check(made.garment);
  return made;
}

int red_pixels(const Image& image, int from_x, int to_x, int from_y, int to_y) {
  int count = 0;
  for (int y = from_y; y < to_y; ++y)
    for (int x = from_x; x < to_x; ++x) {
      const Colour colour = pixel(image, x, y);
      count += colour.red > .5 && colour.green < .35 && colour.blue < .35;
    }
  return count;
}

TEST(LooseGarment, GivesEveryPanelItsOwnVertices) {
  const Sewn made = sewn(.1);
  const LooseGarment loose = loose_garment(made.garment, made.panels);
  check(loose.mesh);
  EXPECT_EQ(loose.mesh.vertex_count, 8);
  EXPECT_EQ(Eigen::Matrix3Xi(loose.mesh.triangles.rightCols(2)),
            Eigen::Matrix3Xi(made.garment.panels[1].triangles.array() + 4));
  EXPECT_EQ(loose.positions.leftCols(4), made.panels[0]);
  EXPECT_EQ(loose.positions.rightCols(4), made.panels[1]);
}

TEST(StuckPicture, MarksWhatIsOpenAndLooksCloser) {
  const Sewn open = sewn(.1), closed = sewn(0);
  const Image marked = stuck_picture(open.body, open.garment, open.panels, {1}, "open", 1);
  const Image plain = stuck_picture(open.body, open.garment, open.panels, {}, "nothing to see", 1);
  EXPECT_EQ(red_pixels(plain, 0, 1200, 0, plain.height), 0);
  EXPECT_GT(marked.height, plain.height + 300);
  EXPECT_GT(red_pixels(marked, 0, 400, 0, plain.height), 10);
  EXPECT_GT(red_pixels(marked, 0, 400, plain.height, marked.height), 1000);
  // The line across the gap, as long as the gap: there is no cloth between.
  const Image shut = stuck_picture(closed.body, closed.garment, closed.panels, {1}, "closed", 1);
  EXPECT_GT(red_pixels(marked, 190, 210, 0, plain.height), 10);
  EXPECT_GT(red_pixels(shut, 0, 400, 0, plain.height), 10);
}

TEST(StuckPicture, LooksNoCloserAtWhatIsEverywhere) {
  const Sewn made = sewn(0);
  const Image all = stuck_picture(made.body, made.garment, made.panels, {0, 1, 2, 3, 4, 5}, "all round", 1);
  const Image none = stuck_picture(made.body, made.garment, made.panels, {}, "none", 1);
  EXPECT_EQ(all.height, none.height);
}

TEST(StuckPicture, RefusesPanelsOfAnotherGarment) {
  const Sewn made = sewn(0);
  EXPECT_THROW(stuck_picture(made.body, made.garment, {made.panels[0]}, {}, ""), std::invalid_argument);
  EXPECT_THROW(loose_garment(made.garment, {made.panels[0], made.panels[1].leftCols(3)}), std::invalid_argument);
}

}  // namespace
}  // namespace toile
