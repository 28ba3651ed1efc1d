#include "formats/toml/toml.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Toml, BrokenTextsAreErrorsWithTheirLine) {
  for (const char* broken :
       {"[=]", "[", "[[ =x]]", "[,a]", "x = [1, }", "x = [\"a\", }\"b\"]", "x = }", "x = { a = , }", "[\x01]", "x = \"",
        "x = ", "a.=1", "x = 1e", "x = 0x", "\xC3\xA4 = 1", "x = \"\\u12\"", "a = 1\na = 2"}) {
    const Loaded<TomlNode> alone = parse_toml(broken, "x.toml"),
                           later = parse_toml("b = 1\n\n" + std::string(broken), "x.toml");
    for (const auto* parsed : {&alone, &later}) {
      ASSERT_FALSE(parsed->value) << broken;
      EXPECT_EQ(parsed->report.findings.at(0).code, "toml.syntax");
      EXPECT_FALSE(parsed->report.findings[0].remedy.empty());
    }
    if (std::string(broken).find('\n') == std::string::npos) {
      EXPECT_EQ(later.report.findings[0].place.substr(0, 8), "x.toml:3") << broken << ": " << later.report.findings[0].place;
    }
  }
}

TEST(Toml, NestingIsBounded) {
  EXPECT_FALSE(parse_toml("x = " + std::string(100'000, '['), "x.toml").value);
  EXPECT_TRUE(parse_toml("x = [[[[[[1]]]]]]", "x.toml").value);
}

}  // namespace
}  // namespace toile
