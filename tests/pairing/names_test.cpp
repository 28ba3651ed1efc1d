#include "pairing/names.h"

#include <gtest/gtest.h>

#include "pairing/pieces.h"

namespace toile {
namespace {

TEST(PieceNames, AreSplitWhereWordsEnd) {
  EXPECT_EQ(words_of("RückenTeil_2"), (std::vector<std::string>{"ruecken", "teil", "2"}));
  EXPECT_EQ(words_of("Ärmel links"), (std::vector<std::string>{"aermel", "links"}));
  EXPECT_EQ(words_of("panel12b"), (std::vector<std::string>{"panel", "12", "b"}));
}

struct Said {
  const char* name;
  const char* role;
  const char* face;
  const char* hand;
};

TEST(PieceNames, AreUnderstoodInSixLanguages) {
  const auto all = test::templates();
  const auto shirt = std::find_if(all.begin(), all.end(), [](const GarmentTemplate& t) { return t.name == "shirt"; });
  ASSERT_NE(shirt, all.end());
  for (const Said& said :
       {Said{"Sleeve left", "sleeve", "", "left"}, Said{"Ärmel rechts", "sleeve", "", "right"},
        Said{"Vorderteil", "torso", "front", ""}, Said{"Rückenteil", "torso", "back", ""},
        Said{"manche gauche", "sleeve", "", "left"}, Said{"devant", "torso", "front", ""}, Said{"espalda", "torso", "back", ""},
        Said{"manga", "sleeve", "", ""}, Said{"davanti", "torso", "front", ""}, Said{"manica destra", "sleeve", "", "right"},
        Said{"achterpand", "torso", "back", ""}, Said{"mouw", "sleeve", "", ""}, Said{"Kragen", "collar", "", ""},
        Said{"poignet", "cuff", "", ""}, Said{"POCKET", "extra", "", ""}, Said{"Tasche", "extra", "", ""}}) {
    const PieceName name = read_name(said.name, *shirt);
    ASSERT_GE(name.role, 0) << said.name;
    EXPECT_EQ(shirt->roles[static_cast<std::size_t>(name.role)].role, said.role) << said.name;
    EXPECT_EQ(name.face, said.face) << said.name;
    EXPECT_EQ(name.hand, said.hand) << said.name;
  }
}

TEST(GarmentTemplates, AreRefusedWithTheirPlace) {
  const auto unknown =
      read_garment_template("name = \"x\"\nopenings = [2]\n[[seam]]\na = \"arm.top\"\nb = \"arm.top\"\n", "x.toml");
  ASSERT_FALSE(unknown.value);
  EXPECT_EQ(unknown.report.findings[0].code, "garment-template.unknown-role");
  EXPECT_EQ(unknown.report.findings[0].place, "x.toml:4");
  const auto key = read_garment_template("name = \"x\"\nopenings = [2]\ncolour = 3\n", "x.toml");
  ASSERT_FALSE(key.value);
  EXPECT_EQ(key.report.findings[0].code, "garment-template.unknown-key");
}

}  // namespace
}  // namespace toile
