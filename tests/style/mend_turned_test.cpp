#include "style/mend_turned.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "style/normal_deviation.h"
#include "style/synthetic_skirt.h"

namespace toile {
namespace {

constexpr int columns = 48, rows = 40, row = 25, pulled = row * columns + 10;

struct Torn {
  testing::SyntheticSkirt skirt = testing::synthetic_skirt({.columns = columns, .rows = rows});
  std::vector<SourceTriangle> triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  Eigen::Matrix3Xd x = skirt.drape;
  // One vertex pulled past its neighbours turns the triangles on its other side over.
  Torn() { x.col(pulled) = skirt.drape.col(pulled + 3); }
  std::size_t turned(const Eigen::Matrix3Xd& positions) const {
    return normal_deviation(triangles, skirt.drape, positions).flipped.size();
  }
};

TEST(MendTurned, LaysTheClothRoundTurnedTrianglesAnew) {
  const Torn torn;
  ASSERT_GT(torn.turned(torn.x), 0u);
  const Eigen::Matrix3Xd mended = mend_turned(torn.triangles, torn.skirt.drape, torn.x, {});
  EXPECT_EQ(torn.turned(mended), 0u);
  EXPECT_LT((mended.col(pulled) - torn.skirt.drape.col(pulled)).norm(), 2e-3);
  for (Eigen::Index v = 0; v < mended.cols(); ++v)
    if (std::abs(v / columns - row) > 9) {
      EXPECT_EQ(mended.col(v), torn.x.col(v)) << v;
    }
}

TEST(MendTurned, LeavesWhatIsHeldAndWhatIsWhole) {
  const Torn torn;
  HardConstraints hard;
  hard.hold(pulled, torn.x.col(pulled));
  EXPECT_EQ(mend_turned(torn.triangles, torn.skirt.drape, torn.x, hard).col(pulled), torn.x.col(pulled));
  EXPECT_EQ(mend_turned(torn.triangles, torn.skirt.drape, torn.skirt.drape, {}), torn.skirt.drape);
}

TEST(MendTurned, LeavesAGarmentAloneThatIsTurnedOverAllOver) {
  const Torn torn;
  Eigen::Matrix3Xd inside_out = torn.skirt.drape;
  inside_out.row(0) *= -1;
  EXPECT_EQ(mend_turned(torn.triangles, torn.skirt.drape, inside_out, {}), inside_out);
}

}  // namespace
}  // namespace toile
