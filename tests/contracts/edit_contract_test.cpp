// What every edit operation promises. Being in operations() is being tested here.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <ostream>
#include <set>
#include <stdexcept>

#include "edit/operation.h"
#include "style/synthetic_skirt.h"

namespace toile {

void PrintTo(const EditOperation& operation, std::ostream* out) { *out << operation.name; }

namespace {

// The skirt with its piece drawn round its panels, as a pattern is.
testing::SyntheticSkirt drawn(const testing::SkirtShape& shape) {
  testing::SyntheticSkirt skirt = testing::synthetic_skirt(shape);
  const PanelMesh& panel = skirt.garment.panels.front();
  for (Edge& edge : skirt.pattern.pieces.front().outline) edge.points.clear();
  for (std::size_t i = 0; i < panel.boundary.size(); ++i) {
    const BoundaryVertex &from = panel.boundary[i], &to = panel.boundary[(i + 1) % panel.boundary.size()];
    Edge& edge = skirt.pattern.pieces.front().outline[static_cast<std::size_t>(from.edge)];
    if (edge.points.empty()) edge.points.push_back({panel.rest.col(from.vertex), true, {}});
    edge.points.push_back({panel.rest.col(to.vertex), to.edge != from.edge, {}});
  }
  return skirt;
}

struct Scene {
  testing::SyntheticSkirt skirt = drawn({.columns = 48, .rows = 30});
  testing::SyntheticSkirt fuller = drawn({.columns = 48, .rows = 30, .ease = 15e-3, .flare = 0.3});
  Body body = make_body(skirt.form);
  std::shared_ptr<const Body> same = std::make_shared<const Body>(body), wider = std::make_shared<const Body>(wide());
  EditInput input() const {
    return {skirt.pattern,
            skirt.garment,
            skirt.drape,
            body,
            [this](const BodyName& name, const std::string& place) {
              if (name.size == "wider" || name.file == "wider.obj") return wider;
              if (name.size == "same") return same;
              throw BadInput({"edit.no-such-body", Severity::error, place, "there is no such body", "same or wider"});
            },
            [this](const std::string& file, const Body&, const std::string& place) {
              if (file == "same" || file == "other") return worn(file == "same" ? skirt : fuller);
              throw BadInput({"edit.no-such-garment", Severity::error, place, "there is no such garment", "same or other"});
            }};
  }
  static std::shared_ptr<const WornGarment> worn(const testing::SyntheticSkirt& one) {
    return std::make_shared<const WornGarment>(WornGarment{one.pattern, one.garment, one.drape, 25e-3, {}});
  }
  Body wide() const {
    Mannequin form = skirt.form;
    form.positions.row(0) *= 1.08;
    form.positions.row(2) *= 1.08;
    return make_body(form);
  }
};

const Scene& scene() {
  static const Scene one;
  return one;
}

// Its defaults, and something small for what must be given; nothing at all when `still`.
EditArguments plain(const EditOperation& operation, bool still = false) {
  EditArguments arguments;
  for (const Parameter& parameter : operation.parameters)
    if (!parameter.by_default && parameter.instead_of.empty())
      arguments[parameter.name] = parameter.unit == "m"      ? (still ? "0" : "2 cm")
                                  : parameter.unit == "deg"  ? (still ? "0 deg" : "5 deg")
                                  : parameter.unit == "loop" ? "hip"
                                  : parameter.unit == "size" ? (still ? "same" : "wider")
                                  : parameter.unit == "file" ? (still ? "same" : "other")
                                                             : (still ? "0" : "1");
  return arguments;
}

bool has_loop(const EditOperation& operation) {
  return std::any_of(operation.parameters.begin(), operation.parameters.end(),
                     [](const Parameter& parameter) { return parameter.name == "loop"; });
}

const Body& worn_on(const Target& target) { return target.body ? *target.body : scene().body; }

class EditContract : public ::testing::TestWithParam<EditOperation> {};

TEST_P(EditContract, DescribesItselfAndItsParameters) {
  EXPECT_FALSE(GetParam().name.empty());
  EXPECT_FALSE(GetParam().summary.empty());
  for (const Parameter& parameter : GetParam().parameters) {
    EXPECT_FALSE(parameter.name.empty());
    EXPECT_FALSE(parameter.meaning.empty()) << parameter.name;
    EXPECT_TRUE((std::set<std::string>{"m", "deg", "", "loop", "size", "file"}).count(parameter.unit)) << parameter.unit;
    EXPECT_TRUE(parameter.instead_of.empty() || !parameter.by_default) << parameter.name;
    EXPECT_TRUE(!parameter.least || !parameter.most || *parameter.least < *parameter.most) << parameter.name;
  }
}

TEST_P(EditContract, KeepsTheGarmentAndGivesFinitePositions) {
  const Target target = GetParam().apply(scene().input(), plain(GetParam()));
  if (target.pattern) {
    check(target.garment);  // one that the edit made
    EXPECT_EQ(target.source.cols(), target.garment.vertex_count);
  } else {
    EXPECT_EQ(target.garment, scene().skirt.garment);
    EXPECT_EQ(target.source, scene().skirt.drape);
  }
  ASSERT_EQ(target.positions.cols(), target.source.cols());
  EXPECT_TRUE(target.positions.allFinite());
  EXPECT_TRUE(target.report.ok());
  EXPECT_EQ(target.held.empty(), !has_loop(GetParam()));
  for (const int v : target.held) EXPECT_TRUE(v >= 0 && v < target.source.cols());
  for (const int v : target.anchor) EXPECT_EQ(target.positions.col(v), target.source.col(v));
  EXPECT_GE(target.normal_deviation_max, target.normal_deviation_mean);
}

TEST_P(EditContract, ChangesSomethingAndTurnsNoTriangleOver) {
  const Target target = GetParam().apply(scene().input(), plain(GetParam()));
  if (target.pattern)
    EXPECT_NE(*target.pattern, scene().skirt.pattern);
  else
    EXPECT_GT((target.positions - target.source).cwiseAbs().maxCoeff(), 1e-3);
  for (Eigen::Index t = 0; t < target.garment.triangles.cols(); ++t) {
    const auto normal = [&](const Eigen::Matrix3Xd& x) {
      const Eigen::Vector3d a = x.col(target.garment.triangles(0, t));
      return Eigen::Vector3d((x.col(target.garment.triangles(1, t)) - a).cross(x.col(target.garment.triangles(2, t)) - a));
    };
    EXPECT_GT(normal(target.positions).dot(normal(target.source)), 0) << "triangle " << t;
  }
}

TEST_P(EditContract, GoesNoDeeperIntoTheBodyThanTheSource) {
  const Target target = GetParam().apply(scene().input(), plain(GetParam()));
  const auto deepest = [](const Body& body, const Eigen::Matrix3Xd& x) {
    double least = 0;
    for (Eigen::Index v = 0; v < x.cols(); ++v) least = std::min(least, body.distance.distance(x.col(v)));
    return least;
  };
  EXPECT_GE(deepest(worn_on(target), target.positions), deepest(scene().body, target.source) - 1e-4);
}

TEST_P(EditContract, GivesTheSourceBackWhenNothingIsAskedFor) {
  const Target target = GetParam().apply(scene().input(), plain(GetParam(), true));
  EXPECT_LT((target.positions - target.source).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(target.normal_deviation_max, 1e-3);
}

TEST_P(EditContract, SaysWhatItDid) {
  const Target target = GetParam().apply(scene().input(), plain(GetParam()));
  std::set<std::string> codes;
  for (const Finding& finding : target.report.findings) codes.insert(finding.code);
  for (const char* code : {"edit.moved", "edit.normals"}) EXPECT_TRUE(codes.count(code)) << code;
}

TEST_P(EditContract, GivesTheSameBytesTwice) {
  EXPECT_EQ(GetParam().apply(scene().input(), plain(GetParam())).positions,
            GetParam().apply(scene().input(), plain(GetParam())).positions);
}

TEST_P(EditContract, RefusesNonsenseWithPlaceAndRemedy) {
  const auto expect_refused = [&](const EditArguments& arguments, const std::string& what) {
    try {
      GetParam().apply(scene().input(), arguments);
      ADD_FAILURE() << what << " was accepted";
    } catch (const BadInput& bad) {
      EXPECT_EQ(bad.finding().code.rfind("edit.", 0), 0u) << what << ": " << bad.finding().code;
      EXPECT_FALSE(bad.finding().place.empty()) << what;
      EXPECT_FALSE(bad.finding().remedy.empty()) << what;
    }
  };
  EditArguments arguments = plain(GetParam());
  arguments["no such parameter"] = "1";
  expect_refused(arguments, "an unknown parameter");
  for (const Parameter& parameter : GetParam().parameters) {
    for (const char* nonsense : {"", "banana", "10", "nan m", "1e9 m", "no.such, loop:7"}) {
      if (parameter.unit == "" && std::string(nonsense) == "10") continue;
      if (!parameter.instead_of.empty()) continue;  // refused beside what it stands for, whatever it is
      arguments = plain(GetParam());
      arguments[parameter.name] = nonsense;
      expect_refused(arguments, parameter.name + " = '" + nonsense + "'");
    }
    if (!parameter.instead_of.empty()) {
      arguments = plain(GetParam());
      arguments[parameter.name] = "1 cm";
      expect_refused(arguments, parameter.name + " beside " + parameter.instead_of);
      arguments.erase(parameter.instead_of);
      arguments[parameter.name] = "no such thing";
      expect_refused(arguments, parameter.name + " = 'no such thing'");
    }
    if (parameter.by_default || !parameter.instead_of.empty()) continue;
    arguments = plain(GetParam());
    arguments.erase(parameter.name);
    expect_refused(arguments, "no " + parameter.name);
  }
}

TEST_P(EditContract, RefusesADrapeThatIsNotFinite) {
  Eigen::Matrix3Xd broken = scene().skirt.drape;
  broken(1, 7) = std::numeric_limits<double>::quiet_NaN();
  EditInput input = scene().input();
  const EditInput with{input.pattern, input.garment, broken, input.body, input.find_body};
  EXPECT_THROW(GetParam().apply(with, plain(GetParam())), std::invalid_argument);
}

TEST_P(EditContract, RefusesADrapeOfAnotherGarment) {
  const Eigen::Matrix3Xd other = scene().skirt.drape.leftCols(100);
  const EditInput input{scene().skirt.pattern, scene().skirt.garment, other, scene().body};
  EXPECT_THROW(GetParam().apply(input, plain(GetParam())), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(All, EditContract, ::testing::ValuesIn(operations()),
                         [](const auto& operation) { return operation.param.name; });

}  // namespace
}  // namespace toile
