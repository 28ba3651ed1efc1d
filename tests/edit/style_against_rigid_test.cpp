// Edits that keep the style against deformations that keep the surface rigid, both with the same vertices held (paper Fig. 3).

#include <gtest/gtest.h>

#include "edit/against_rigid.h"
#include "edit/operation.h"
#include "edit/worn_skirt.h"

namespace toile {
namespace {

// The edit, and the same loop and everything that did not move held while the rest is as rigid as possible.
testing::AgainstRigid compared(const std::string& operation, const EditArguments& arguments) {
  static const testing::WornSkirt scene({.columns = 64, .rows = 40, .jitter = .2});
  const Target target = scene.apply(operation, arguments);
  return testing::against_rigid(target.source, target.garment.triangles, target.positions, target.held);
}

TEST(StyleAgainstRigid, ShorterTurnsNormalsAndCurvesLess) {
  const testing::AgainstRigid c = compared("length", {{"loop", "hem"}, {"by", "-10 cm"}});
  EXPECT_LT(c.style.turned, c.rigid.turned / 2);
  EXPECT_LT(c.style.curved, c.rigid.curved / 2);
  EXPECT_LT(c.style.added, c.rigid.added / 2);
}

// With the hem where the cloth goes on straight, both add hardly any curvature: no one has the better of it there.
TEST(StyleAgainstRigid, LongerTurnsNormalsLess) {
  const testing::AgainstRigid c = compared("length", {{"loop", "hem"}, {"by", "10 cm"}});
  EXPECT_LT(c.style.turned, .8 * c.rigid.turned);
  EXPECT_LT(c.style.curved, c.rigid.curved);
  EXPECT_LT(c.style.added, 1.05 * c.rigid.added);
}

TEST(StyleAgainstRigid, AWiderHemTurnsNormalsAndCurvesLess) {
  const testing::AgainstRigid c = compared("fit", {{"loop", "hem"}, {"by", "2 cm"}});
  EXPECT_LT(c.style.turned, .8 * c.rigid.turned);
  EXPECT_LT(c.style.curved, c.rigid.curved);
  EXPECT_LT(c.style.added, c.rigid.added);
}

}  // namespace
}  // namespace toile
