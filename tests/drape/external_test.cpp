// The protocol of templates/simulators, spoken by tests/stand_in_simulator: what it carries, and what is said when it fails.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "contracts/simulator_scenes.h"
#include "drape/external/child.h"
#include "drape/external/exchange.h"
#include "drape/external/program.h"
#include "drape/simulator.h"
#include "garment/report.h"

namespace toile::test {
namespace {

namespace fs = std::filesystem;

const Fabric cloth{.name = "cloth",
                   .area_density = .2,
                   .stretch_warp = 600,
                   .stretch_weft = 500,
                   .stretch_cross = 150,
                   .shear = 200,
                   .bend_warp = 2e-5,
                   .bend_weft = 1e-5,
                   .friction = .5};

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A template in a folder of its own, with the stand-in as its program.
class Given {
 public:
  explicit Given(const std::string& lines) {
    external::write_file(file_(), "name = 'given'\nsummary = 's'\nprogram = '" STAND_IN_PROGRAM "'\n" + lines);
  }
  std::string path() const { return file_(); }
  fs::path folder() const { return folder_.path(); }

 private:
  std::string file_() const { return (folder_.path() / "given.toml").string(); }
  external::ExchangeFolder folder_;
};

std::string stand_in(const std::string& arguments) {
  return "command = ['{program}', '{folder}', " + arguments + "]\ntime_limit = 60\nat_rest = 'program'\n";
}

class External : public testing::Test {
 protected:
  const Body body_ = body_of(sphere({0, 1, 0}, .2, 3), "ball");
  const GarmentMesh sheet_ = crossed_sheet(.2, .2, 4);
  const Eigen::Matrix3Xd start_ = laid_on(sheet_, 0, .2005);
  const DrapeRequest request_{.garment = sheet_, .start = start_, .body = body_, .fabric = cloth, .tolerance = 1e-3};

  Finding refusal(const std::string& lines) const {
    const Given given(lines);
    try {
      find_simulator(given.path()).drape(request_);
    } catch (const BadInput& bad) {
      const std::string& place = bad.finding().place;
      if (const auto at = place.find("files in "); at != std::string::npos) {
        EXPECT_TRUE(fs::exists(place.substr(at + 9))) << "kept for looking at";
        fs::remove_all(place.substr(at + 9));
      }
      EXPECT_FALSE(bad.finding().remedy.empty());
      return bad.finding();
    }
    ADD_FAILURE() << "not refused: " << lines;
    return {};
  }
};

// `sheet` as two panels sewn where x = 0, each with a grain of its own, one triangle of double cloth.
GarmentMesh in_halves(const GarmentMesh& sheet) {
  GarmentMesh halves = sheet;
  halves.panels.clear();
  halves.welded.clear();
  Eigen::Index next = 0;
  const PanelMesh& whole = sheet.panels[0];
  for (const double side : {-1., 1.}) {
    PanelMesh panel;
    std::vector<int> garment_vertex;
    std::vector<Eigen::Vector3i> triangles;
    for (Eigen::Index t = 0; t < whole.triangles.cols(); ++t) {
      if (side * (whole.rest(0, whole.triangles(0, t)) + whole.rest(0, whole.triangles(1, t)) +
                  whole.rest(0, whole.triangles(2, t))) <
          0)
        continue;
      halves.triangles.col(next++) = whole.triangles.col(t);
      Eigen::Vector3i own;
      for (int i = 0; i < 3; ++i) {
        const int v = whole.triangles(i, t);
        const auto found = std::find(garment_vertex.begin(), garment_vertex.end(), v);
        own(i) = static_cast<int>(found - garment_vertex.begin());
        if (found == garment_vertex.end()) garment_vertex.push_back(v);
      }
      triangles.push_back(own);
    }
    panel.name = side < 0 ? "left half" : "right half";
    panel.warp = Eigen::Vector2d(.3 * side, 1).normalized();
    panel.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t) panel.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
    panel.layers = Eigen::VectorXd::Ones(panel.triangles.cols());
    panel.layers(0) = side < 0 ? 2 : 1;
    const Eigen::VectorXi welded =
        Eigen::Map<Eigen::VectorXi>(garment_vertex.data(), static_cast<Eigen::Index>(garment_vertex.size()));
    panel.rest.resize(2, welded.size());
    for (Eigen::Index v = 0; v < welded.size(); ++v) panel.rest.col(v) = whole.rest.col(welded(v)) + Eigen::Vector2d(side, 3);
    halves.panels.push_back(panel);
    halves.welded.push_back(welded);
  }
  return halves;
}

// Whatever the files did not carry would make a difference.
TEST_F(External, TheFilesCarryTheWholeRequest) {
  const GarmentMesh garment = in_halves(sheet_);
  const DrapeRequest request{.garment = garment, .start = start_, .body = body_, .fabric = cloth, .tolerance = 1e-5};
  const Given given(stand_in("'fem'"));
  const Drape theirs = find_simulator(given.path()).drape(request), ours = find_simulator("fem").drape(request);
  EXPECT_TRUE(theirs.settled);
  EXPECT_EQ(theirs.steps, ours.steps);
  EXPECT_LT((theirs.positions - ours.positions).colwise().norm().maxCoeff(), 1e-6);
  EXPECT_GT((ours.positions - find_simulator("fem").drape(request_).positions).colwise().norm().maxCoeff(), 1e-4);
}

TEST_F(External, PositionsAreWrittenInTheProgramsUnitAndAxes) {
  external::ExchangeFolder folder;
  const Given given(stand_in("'fem'") + "units = 'cm'\nup = 'z'\n");
  external::Program program = external::read_program(given.path());
  external::write_request(request_, start_, program, folder.path());
  EXPECT_LT((external::read_vertices(folder.path() / "garment.obj", program) - start_).norm(), 1e-12);
  program.unit = 1;
  program.z_up = false;
  const Eigen::Matrix3Xd raw = external::read_vertices(folder.path() / "garment.obj", program);
  EXPECT_LT((raw.row(2) - 100 * start_.row(1)).norm(), 1e-9);
  EXPECT_LT((raw.row(1) + 100 * start_.row(2)).norm(), 1e-9);
}

TEST_F(External, LoosePanelsAreWelded) {
  const Drape welded =
      find_simulator(Given(stand_in("'fem', 'loose-panels'") + "result_vertices = 'panels'\n").path()).drape(request_);
  EXPECT_EQ(welded.positions, find_simulator(Given(stand_in("'fem'")).path()).drape(request_).positions);
}

TEST(ExternalWeld, CopiesMeetInTheirMean) {
  GarmentMesh garment;
  garment.vertex_count = 2;
  garment.welded = {Eigen::Vector2i(0, 1), Eigen::Vector2i(1, 0)};
  Eigen::Matrix3Xd x(3, 4);
  x << 0, 1, 3, 0.5, 0, 0, 0, 0, 0, 0, 0, 0;
  double widest = 0;
  const Eigen::Matrix3Xd welded = external::welded(garment, x, widest);
  EXPECT_DOUBLE_EQ(welded(0, 0), .25);
  EXPECT_DOUBLE_EQ(welded(0, 1), 2);
  EXPECT_DOUBLE_EQ(widest, 1);
}

TEST_F(External, WhatGoesWrongIsNamedWithTheProgramsLastWords) {
  const Finding failed = refusal(stand_in("'fem', 'fail'"));
  EXPECT_EQ(failed.code, "simulator.external-failed");
  EXPECT_NE(failed.text.find("exit code 3"), std::string::npos) << failed.text;
  EXPECT_NE(failed.text.find("cannot open display"), std::string::npos) << failed.text;
  EXPECT_NE(failed.place.find("given"), std::string::npos);
  const Finding crashed = refusal(stand_in("'fem', 'crash'"));
  EXPECT_EQ(crashed.code, "simulator.external-failed");
  EXPECT_NE(crashed.text.find("signal 6"), std::string::npos) << crashed.text;
  EXPECT_EQ(refusal(stand_in("'fem', 'write-nothing'")).code, "simulator.external-no-file");
  EXPECT_EQ(refusal(stand_in("'fem', 'lose-a-vertex'")).code, "simulator.external-counts");
  EXPECT_EQ(refusal(stand_in("'fem', 'explode'")).code, "simulator.external-not-finite");
  EXPECT_EQ(refusal(stand_in("'fem', 'use-centimetres'")).code, "simulator.external-size");
  EXPECT_EQ(refusal(stand_in("'fem', 'fall'")).code, "simulator.external-size");
  EXPECT_EQ(refusal("command = ['{program}', '{folder}', 'fem', 'hang']\ntime_limit = 0.3\n").code,
            "simulator.external-too-long");
  const Finding missing = refusal("command = ['no-such-program-anywhere']\ntime_limit = 1\ninstall = 'Build it'\n");
  EXPECT_EQ(missing.code, "simulator.external-missing");
  EXPECT_EQ(missing.fault, Fault::missing);
  EXPECT_NE(missing.remedy.find("Build it"), std::string::npos);
}

TEST_F(External, WhenTheCallersTimeIsUpTheLastWholeStateComesBackUnsettled) {
  DrapeRequest request{.garment = sheet_, .start = start_, .body = body_, .fabric = cloth, .tolerance = 1e-3, .time_limit = .2};
  const Drape nothing = find_simulator(Given(stand_in("'fem', 'hang'")).path()).drape(request);
  EXPECT_FALSE(nothing.settled);
  EXPECT_EQ(nothing.positions, start_);
  bool asked = false;
  DrapeRequest stopped{.garment = sheet_, .start = start_, .body = body_, .fabric = cloth, .tolerance = 1e-3};
  stopped.stop = [&] { return std::exchange(asked, true); };
  EXPECT_FALSE(find_simulator(Given(stand_in("'fem', 'hang'")).path()).drape(stopped).settled);
}

TEST(ExternalTemplate, MistakesAreRefusedWithTheirLine) {
  const auto code_of = [](const std::string& lines, const std::string& in_text) {
    const Given given(lines);
    try {
      find_simulator(given.path());
      ADD_FAILURE() << "accepted: " << lines;
    } catch (const BadInput& bad) {
      EXPECT_EQ(bad.finding().code, "simulator.external-template");
      EXPECT_NE(std::string(bad.what()).find(in_text), std::string::npos) << bad.what();
    }
  };
  const std::string plain = "command = ['x']\ntime_limit = 5\n";
  code_of(plain + "comand = 1\n", ":6");
  code_of(plain + "units = 'ell'\n", "m, cm, mm");
  code_of(plain + "clearance = 5\n", "clearance");
  code_of(plain + "at_rest = 'movement'\n", "before");
  code_of(plain + "result = '../../etc/x'\n", "folder");
  code_of("time_limit = 5\n", "command");
  code_of("command = ['x']\n", "time_limit");
  code_of(plain + "= 3\n", ":6");
  EXPECT_THROW(find_simulator("external:no-such"), BadInput);
  EXPECT_THROW(find_simulator("no/such.toml"), BadInput);
  EXPECT_THROW(find_simulator("external"), BadInput);
}

// ARCSim's parser asks for numbers where numbers are and for rows of four and five.
TEST_F(External, ArcsimGetsTheFilesItsParserReads) {
  const external::Program program = external::read_program(external::program_folder() / "arcsim.toml");
  external::ExchangeFolder folder;
  const auto values = external::request_values(request_, program, folder.path());
  external::write_request(request_, start_, program, folder.path());
  std::map<std::string, nlohmann::json> made;
  for (const external::RenderedFile& file : program.files)
    made[file.to] = nlohmann::json::parse(
        external::filled(text_of(file.from), "{{", "}}", values, file.from.string(), external::Escape::json));
  const auto& conf = made.at("conf.json");
  EXPECT_TRUE(conf.at("frame_steps").is_number_integer());
  EXPECT_TRUE(conf.at("frame_time").is_number());
  const double frames = conf.at("end_time").get<double>() / conf.at("frame_time").get<double>();
  char last[16];
  std::snprintf(last, sizeof last, "%04d_00.obj", static_cast<int>(std::lround(frames)));
  EXPECT_EQ(program.result, last);
  EXPECT_TRUE(fs::exists(conf.at("cloths").at(0).at("mesh").get<std::string>()));
  EXPECT_TRUE(fs::exists(folder.path() / "0000_00.obj"));
  EXPECT_TRUE(fs::exists(conf.at("obstacles").at(0).at("mesh").get<std::string>()));
  EXPECT_EQ(conf.at("cloths").at(0).at("materials").at(0).at("data"), (folder.path() / "material.json").string());
  EXPECT_EQ(conf.at("gravity"), nlohmann::json({0, -9.81, 0}));
  EXPECT_EQ(conf.at("obs_friction"), cloth.friction);
  const auto& material = made.at("material.json");
  EXPECT_EQ(material.at("density"), cloth.area_density);
  ASSERT_EQ(material.at("stretching").size(), 6u);
  for (const auto& row : material.at("stretching"))
    EXPECT_EQ(row, nlohmann::json({cloth.stretch_weft / 2, cloth.stretch_cross / 2, cloth.stretch_warp / 2, cloth.shear}));
  ASSERT_EQ(material.at("bending").size(), 3u);
  for (const auto& row : material.at("bending")) EXPECT_EQ(row.size(), 5u);
  EXPECT_EQ(material.at("bending").at(0).at(0), 4 * cloth.bend_warp);
}

TEST_F(External, BlenderDrapesASheetOnABallMuchAsFemDoes) {
  if (external::find_on_path("blender").empty()) GTEST_SKIP() << "Blender is not installed";
  const Drape theirs = find_simulator("external:blender").drape(request_), ours = find_simulator("fem").drape(request_);
  EXPECT_TRUE(theirs.settled);
  EXPECT_EQ(theirs.max_penetration, 0);
  EXPECT_EQ(theirs.inverted_triangles, 0);
  EXPECT_LT((theirs.positions - ours.positions).colwise().norm().mean(), .05 * .2);
}

}  // namespace
}  // namespace toile::test
