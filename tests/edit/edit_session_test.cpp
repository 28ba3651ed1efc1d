#include "edit/edit_session.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <set>

#include "edit/worn_skirt.h"

namespace toile {
namespace {

using testing::WornSkirt;

const WornSkirt& worn() {
  static const WornSkirt skirt({.columns = 48, .rows = 30});
  return skirt;
}

double greatest(const Eigen::Matrix3Xd& difference) { return difference.colwise().norm().maxCoeff(); }
double mean(const Eigen::Matrix3Xd& difference) { return difference.colwise().norm().mean(); }

void expect_same(const Target& a, const Target& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.held, b.held);
  EXPECT_EQ(a.anchor, b.anchor);
  EXPECT_EQ(a.after, b.after);
  ASSERT_EQ(a.report.findings.size(), b.report.findings.size());
  for (std::size_t i = 0; i < a.report.findings.size(); ++i) EXPECT_EQ(a.report.findings[i].text, b.report.findings[i].text);
}

struct Dragged {
  const char* name;
  const char* operation;
  EditArguments arguments;
  const char* amount;  // parameter
  const char *near, *far;
  double mean_off, most_off;  // m, of a target that follows, from the one sought from the source
};

class EditSessions : public ::testing::TestWithParam<Dragged> {};

TEST_P(EditSessions, GiveFirstWhatTheOperationGives) {
  EditSession session(worn().input(), GetParam().operation, GetParam().arguments);
  expect_same(session.first(), worn().apply(GetParam().operation, GetParam().arguments));
}

TEST_P(EditSessions, DoNotDependOnWhatWasAskedForBetween) {
  const Dragged& p = GetParam();
  EditSession session(worn().input(), p.operation, p.arguments), other(worn().input(), p.operation, p.arguments);
  const Target first = session.first();
  const Target near = session.target({{p.amount, p.near}});
  EXPECT_GT(greatest(near.positions - first.positions), 1e-3);
  expect_same(session.target({}), first);
  other.target({{p.amount, p.far}});
  expect_same(other.target({{p.amount, p.near}}), near);
}

TEST_P(EditSessions, ComeNearWhatTheOperationGives) {
  const Dragged& p = GetParam();
  EditSession session(worn().input(), p.operation, p.arguments);
  for (const char* amount : {p.near, p.far}) {
    EditArguments arguments = p.arguments;
    arguments[p.amount] = amount;
    const Target sought = worn().apply(p.operation, arguments), followed = session.target({{p.amount, amount}});
    EXPECT_EQ(followed.held, sought.held);
    EXPECT_EQ(followed.anchor, sought.anchor);
    for (const int v : followed.anchor) EXPECT_EQ(followed.positions.col(v), followed.source.col(v));
    EXPECT_LE(mean(followed.positions - sought.positions), p.mean_off) << amount;
    EXPECT_LE(greatest(followed.positions - sought.positions), p.most_off) << amount;
    EXPECT_LT(followed.normal_deviation_mean, 1.1 * sought.normal_deviation_mean + 1e-4) << amount;
    if (p.most_off == 0) expect_same(followed, sought);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, EditSessions,
    ::testing::Values(Dragged{"hem_shorter", "length", {{"loop", "hem"}, {"by", "-10 cm"}}, "by", "-9 cm", "-3 cm", 0, 0},
                      Dragged{"hem_longer", "length", {{"loop", "hem"}, {"by", "5 cm"}}, "by", "6 cm", "-2 cm", 0, 0},
                      Dragged{"hip_wider", "fit", {{"loop", "hip"}, {"by", "1 cm"}}, "by", "12 mm", "25 mm", 0.5e-3, 3e-3},
                      Dragged{"hem_wider", "fit", {{"loop", "hem"}, {"by", "2 cm"}}, "by", "18 mm", "35 mm", 0.5e-3, 3e-3},
                      Dragged{"all_wider", "fit", {{"loop", "all"}, {"girth", "4 cm"}}, "girth", "5 cm", "8 cm", 0.5e-3, 3e-3}),
    [](const auto& dragged) { return std::string(dragged.param.name); });

TEST(EditSession, RefusesWhatTheOperationRefuses) {
  EditSession session(worn().input(), "length", {{"by", "-5 cm"}});
  EXPECT_THROW(session.target({{"by", "-80 cm"}}), BadInput);
  EXPECT_THROW(session.target({{"banana", "1"}}), BadInput);
  EXPECT_EQ(session.target({{"by", "-4 cm"}}).positions, worn().apply("length", {{"by", "-4 cm"}}).positions);
  EXPECT_THROW(EditSession(worn().input(), "no such edit", {}), BadInput);
}

// Other loops and limits are other edits, also within one session.
TEST(EditSession, FollowsOnlyTheSameEdit) {
  EditSession session(worn().input(), "fit", {{"loop", "hip"}, {"by", "1 cm"}});
  session.first();
  for (const EditArguments& other : {EditArguments{{"loop", "hem"}, {"by", "1 cm"}}, EditArguments{{"release", "25 cm"}}}) {
    EditArguments arguments{{"loop", "hip"}, {"by", "1 cm"}};
    for (const auto& [name, value] : other) arguments[name] = value;
    expect_same(session.target(other), worn().apply("fit", arguments));
  }
}

}  // namespace
}  // namespace toile
