#include "formats/obj/skeleton.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace toile {
namespace {

// The first error, "CODE @ PLACE".
std::string error_of(const Report& report) {
  for (const Finding& finding : report.findings)
    if (finding.severity == Severity::error) return finding.code + " @ " + finding.place;
  return "none";
}

std::string skeleton_error(const std::string& text) {
  const auto loaded = read_skeleton_text(text, "a.skeleton.json");
  EXPECT_EQ(loaded.value.has_value(), loaded.report.ok());
  return error_of(loaded.report);
}

TEST(Skeleton, MapsLandmarksAndMeasuresToOurNames) {
  const auto loaded =
      read_skeleton_text(R"({"name": "x", "units": "cm", "landmarks_m": {"height": 1.7, "waist_y": 1.05, "highhip_y": 0.93,
    "waist": 0.7, "upperarm": 0.28, "elbow_y": 1.1}, "bones": [{"name": "pelvis", "parent": null, "head": [0, 85, 0], "tail": [0, 85, 2]},
    {"name": "thigh.L", "parent": "pelvis", "head": [9, 83, 1], "tail": [12, 45, 4]}], "vertex_weights": [[1]]})",
                         "x.skeleton.json");
  ASSERT_TRUE(loaded.value) << error_of(loaded.report);
  EXPECT_EQ(loaded.value->landmarks, (std::map<std::string, double>{{"elbow", 1.1}, {"high_hip", .93}, {"waist", 1.05}}));
  EXPECT_EQ(loaded.value->measures, (std::map<std::string, double>{{"upper_arm", .28}, {"waist", .7}}));
  ASSERT_EQ(loaded.value->bones.size(), 2u);
  EXPECT_EQ(loaded.value->bones[1].parent, "pelvis");
  EXPECT_LT((loaded.value->bones[1].to - Eigen::Vector3d(.12, .45, .04)).norm(), 1e-12);
}

TEST(Skeleton, NamesTheFieldOfWhatIsWrong) {
  EXPECT_EQ(skeleton_error("{\"name\": \"x\",\n \"bones\": [}"), "skeleton.malformed @ a.skeleton.json:2");
  EXPECT_EQ(skeleton_error("[1]"), "skeleton.malformed @ a.skeleton.json");
  EXPECT_EQ(skeleton_error("{\"bones\": [{\"name\": \"a\", \"head\": [0, 1], \"tail\": [0, 1, 2]}]}"),
            "skeleton.malformed @ a.skeleton.json, bones[0].head");
  EXPECT_EQ(skeleton_error("{\"bones\": [{\"name\": 3}]}"), "skeleton.malformed @ a.skeleton.json, bones[0].name");
  EXPECT_EQ(skeleton_error("{\"landmarks_m\": {\"waist_y\": \"high\"}}"),
            "skeleton.malformed @ a.skeleton.json, landmarks_m.waist_y");
  EXPECT_EQ(skeleton_error("{\"units\": \"ell\"}"), "skeleton.unknown-unit @ a.skeleton.json, units");
  EXPECT_EQ(skeleton_error("{\"bones\": [{\"name\": \"a\", \"parent\": \"b\", \"head\": [0, 1, 2], \"tail\": [0, 1, 2]}]}"),
            "skeleton.no-such-parent @ a.skeleton.json");
}

}  // namespace
}  // namespace toile
