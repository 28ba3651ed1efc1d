#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using Stages = std::map<std::string, std::set<std::string>>;

// The stages as their CMakeLists declare them: "drape: body geometry".
Stages declared() {
  Stages stages;
  std::ifstream in(TOILE_STAGES);
  for (std::string line; std::getline(in, line);) {
    const auto colon = line.find(':');
    if (colon == std::string::npos) continue;
    std::istringstream rest(line.substr(colon + 1));
    auto& depends = stages[line.substr(0, colon)];
    for (std::string stage; rest >> stage;) depends.insert(stage);
  }
  return stages;
}

// What `stage` may include: itself and everything below it.
std::set<std::string> reach(const Stages& stages, const std::string& stage) {
  std::set<std::string> all{stage};
  if (const auto found = stages.find(stage); found != stages.end())
    for (const std::string& below : found->second) all.merge(reach(stages, below));
  return all;
}

std::string stage_of(const fs::path& file) {
  const fs::path relative = fs::relative(file, TOILE_SOURCE_DIR);
  auto part = relative.begin();
  return *part == "formats" ? "formats" : (++part)->string();
}

TEST(Architecture, StagesAreDeclared) { EXPECT_GE(declared().size(), 13u); }

TEST(Architecture, NoStageIncludesWhatItDoesNotDeclare) {
  const Stages stages = declared();
  const std::regex include("^#include \"([a-z_]+)/.*");
  int files = 0;
  for (const char* root : {"/src", "/formats"})
    for (const auto& entry : fs::recursive_directory_iterator(std::string(TOILE_SOURCE_DIR) + root)) {
      const auto extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      ++files;
      const std::string stage = stage_of(entry.path());
      const std::set<std::string> allowed = reach(stages, stage);
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_match(line, match, include)) continue;
        EXPECT_TRUE(allowed.count(match[1])) << entry.path() << ": " << stage << " must not include " << match[1];
      }
    }
  EXPECT_GT(files, 50);
}

TEST(Architecture, DependenciesHaveNoCycle) {
  const Stages stages = declared();
  for (const auto& [stage, depends] : stages)
    for (const std::string& below : depends) EXPECT_FALSE(reach(stages, below).count(stage)) << stage << " and " << below;
}

// Heavy third-party headers stay out of ours, so that nobody who includes a stage pays for them.
TEST(Architecture, HeadersKeepHeavyLibrariesPrivate) {
  const std::regex heavy("^#include <(CGAL|OpenMesh|libxml|tiny_obj_loader|toml|nlohmann/json|CLI|cairo|cholmod|kainjow)[/.+].*");
  for (const char* root : {"/src", "/formats"})
    for (const auto& entry : fs::recursive_directory_iterator(std::string(TOILE_SOURCE_DIR) + root)) {
      if (entry.path().extension() != ".h") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) EXPECT_FALSE(std::regex_match(line, heavy)) << entry.path() << ": " << line;
    }
}

}  // namespace
