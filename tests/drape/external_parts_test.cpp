#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "contracts/simulator_scenes.h"
#include "drape/external/child.h"
#include "drape/external/exchange.h"
#include "drape/external/program.h"
#include "drape/external/static_residual.h"
#include "garment/report.h"

namespace toile::test {
namespace {

namespace fs = std::filesystem;

const Fabric cloth{.name = "cloth", .area_density = .2, .friction = .5};

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(ExternalTemplate, NamesAreFilledInAndUnknownOnesRefused) {
  const std::map<std::string, std::string> values{{"a", "1"}, {"path", "/x \"y\"\\z"}};
  const auto fill = [&](const char* text) { return external::filled(text, "{{", "}}", values, "t:1", external::Escape::json); };
  EXPECT_EQ(fill("{\"k\": {{a}}, \"p\": \"{{path}}\"}"), R"({"k": 1, "p": "/x \"y\"\\z"})");
  EXPECT_EQ(fill("{ {{ } }} {{}}"), "{ {{ } }} {{}}");
  EXPECT_THROW(fill("{{b}}"), BadInput);
}

TEST(ExternalChild, WordsReachTheProgramAsTheyAre) {
  external::ExchangeFolder folder;
  const fs::path echo = external::find_on_path("printf");
  ASSERT_FALSE(echo.empty());
  const auto outcome = external::run_child({{echo.string(), "%s|", "a b", "$HOME", "; exit 7"}, folder.path(), 10., {}});
  EXPECT_EQ(outcome.end, external::ChildEnd::exited);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(text_of(folder.path() / "stdout.txt"), "a b|$HOME|; exit 7|");
  EXPECT_EQ(external::last_words(folder.path()), "a b|$HOME|; exit 7|");
}

TEST(ExternalChild, WhatItStartedEndsWithIt) {
  external::ExchangeFolder folder;
  const auto outcome = external::run_child({{"/bin/sh", "-c", "sleep 60 & echo $! > child; wait"}, folder.path(), .3, {}});
  EXPECT_EQ(outcome.end, external::ChildEnd::out_of_time);
  const int child = std::stoi(text_of(folder.path() / "child"));
  std::string state = "gone";
  for (int tries = 0; tries < 100; ++tries) {
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string word;
    state = stat >> word >> word >> word ? word : "gone";
    if (state == "gone" || state == "Z") break;
    usleep(10000);
  }
  EXPECT_TRUE(state == "gone" || state == "Z") << state;
}

TEST(StaticResidual, IsTheWeightInFreeAirAndNothingOnATable) {
  const GarmentMesh sheet = crossed_sheet(.2, .2, 4);
  const Body body = table();
  const Eigen::Matrix3Xd lying = laid_on(sheet, 0, 1e-3), floating = laid_on(sheet, 0, .02);
  const auto residual = [&](const Eigen::Matrix3Xd& x, const Body& under) {
    return external::static_residual({.garment = sheet, .start = x, .body = under, .fabric = cloth}, x);
  };
  EXPECT_NEAR(residual(lying, body), 0, 1e-9);
  EXPECT_NEAR(residual(floating, body), 1, 1e-9);
  // Beyond the angle of friction what is left is |g| (sin - mu cos), spread over the edge of the cone.
  const double angle = .7, mu = cloth.friction;
  const Body slope = table(angle);
  EXPECT_NEAR(residual(laid_on(sheet, angle, 1e-3), slope), (std::sin(angle) - mu * std::cos(angle)) / std::sqrt(1 + mu * mu),
              1e-6);
  EXPECT_NEAR(residual(laid_on(sheet, std::atan(.9 * mu), 1e-3), table(std::atan(.9 * mu))), 0, 1e-9);
}

}  // namespace
}  // namespace toile::test
