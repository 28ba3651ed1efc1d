#include "edit/arguments.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

const std::vector<Parameter> parameters{{"loop", "loop", "which", {}, {}, "hem"},
                                        {"by", "m", "how far", -1.0, 1.0, {}},
                                        {"share", "", "how much", 0.0, 1.0, "0.5"}};

std::string code_of(const EditArguments& arguments) {
  try {
    read_arguments("test", parameters, arguments);
  } catch (const BadInput& bad) {
    EXPECT_FALSE(bad.finding().remedy.empty());
    EXPECT_NE(bad.finding().place.find("edit 'test'"), std::string::npos);
    return bad.finding().code;
  }
  return "";
}

TEST(Arguments, ReadLengthsInMetresAndFillInDefaults) {
  const ReadArguments read = read_arguments("test", parameters, {{"by", "-12.5 cm"}});
  EXPECT_DOUBLE_EQ(read.numbers.at("by"), -0.125);
  EXPECT_DOUBLE_EQ(read.numbers.at("share"), 0.5);
  EXPECT_EQ(read.names.at("loop"), "hem");
}

TEST(Arguments, RefuseWhatCannotBeMeant) {
  EXPECT_EQ(code_of({}), "edit.missing-parameter");
  EXPECT_EQ(code_of({{"by", "6"}}), "edit.bad-length");
  EXPECT_EQ(code_of({{"by", "nan m"}}), "edit.bad-length");
  EXPECT_EQ(code_of({{"by", "ten centimetres"}}), "edit.bad-length");
  EXPECT_EQ(code_of({{"by", "3 m"}}), "edit.out-of-range");
  EXPECT_EQ(code_of({{"by", "1 cm"}, {"share", "half"}}), "edit.bad-number");
  EXPECT_EQ(code_of({{"by", "1 cm"}, {"share", "0.5x"}}), "edit.bad-number");
  EXPECT_EQ(code_of({{"by", "1 cm"}, {"bye", "1 cm"}}), "edit.unknown-parameter");
}

TEST(Operations, AreFoundByName) {
  EXPECT_EQ(find_operation("length").name, "length");
  try {
    find_operation("lenght");
    FAIL();
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "edit.unknown-operation");
    EXPECT_NE(bad.finding().remedy.find("length"), std::string::npos);
  }
}

}  // namespace
}  // namespace toile
