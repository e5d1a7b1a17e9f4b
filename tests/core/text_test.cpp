#include "engine/core/text.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

const std::vector<std::string> bones = {"leftHand", "leftLowerArm", "rightHand", "rightLowerArm", "head"};

TEST(Text, FindsTheNameThatWasMeant) {
  EXPECT_EQ(nearest_name("leftHnad", bones), "leftHand");
  EXPECT_EQ(nearest_name("LEFTHAND", bones), "leftHand");
  EXPECT_EQ(nearest_name("righthan", bones), "rightHand");
  EXPECT_EQ(nearest_name("hed", bones), "head");
}

TEST(Text, TakesTheNearestAndOfEqualsTheFirst) {
  const std::vector<std::string> names = {"abcx", "abcd", "abce"};
  EXPECT_EQ(nearest_name("abcd", names), "abcd");
  EXPECT_EQ(nearest_name("abcz", names), "abcx");
}

TEST(Text, SuggestsNothingWhereMoreThanHalfOfTheLettersDiffer) {
  const std::vector<std::string> one = {"abcd"};
  EXPECT_EQ(nearest_name("abxy", one), "abcd");
  EXPECT_EQ(nearest_name("axyz", one), std::nullopt);
  EXPECT_EQ(nearest_name("tentacle", bones), std::nullopt);
  EXPECT_EQ(nearest_name("x", {}), std::nullopt);
}

TEST(Text, CountsInsertionsRemovalsAndReplacements) {
  // Two edits are half of four letters and let through; three are not.
  const std::vector<std::string> one = {"abcd"};
  EXPECT_EQ(nearest_name("bd", one), "abcd");
  EXPECT_EQ(nearest_name("d", one), std::nullopt);
  EXPECT_EQ(nearest_name("abcdef", one), "abcd");
  const std::vector<std::string> sitting = {"sitting"};
  EXPECT_EQ(nearest_name("kitten", sitting), "sitting");  // the textbook's three edits
}

TEST(Text, LongNamesAreComparedByTheirBeginning) {
  const std::string huge(1'000'000, 'a');
  const std::vector<std::string> names = {huge + "b"};
  EXPECT_EQ(nearest_name(huge, names), huge + "b");
}

TEST(Text, ASuggestionEndsAMessage) {
  EXPECT_EQ(did_you_mean("leftHnad", bones), " (did you mean \"leftHand\"?)");
  EXPECT_EQ(did_you_mean("tentacle", bones), "");
}

TEST(Text, SplitKeepsEmptyParts) {
  using Parts = std::vector<std::string>;
  EXPECT_EQ(split("a,b,c", ','), (Parts{"a", "b", "c"}));
  EXPECT_EQ(split(",a,,", ','), (Parts{"", "a", "", ""}));
  EXPECT_EQ(split("", ','), (Parts{""}));
  EXPECT_EQ(split("a,b", ';'), (Parts{"a,b"}));
}

TEST(Text, LowersAsciiLettersOnly) {
  EXPECT_EQ(lower("AZaz09_-@[`{"), "azaz09_-@[`{");
  EXPECT_EQ(lower("\xc3\x84"), "\xc3\x84");
}

TEST(Text, ReadsNumbersThatAreWholeAndFinite) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("-2e3"), -2000.0);
  EXPECT_EQ(parse_number("+7"), 7.0);
  EXPECT_EQ(parse_number("0"), 0.0);
  for (const char* bad : {"", "+", "-", "1,5", "1.5x", " 1", "1 ", "inf", "nan", "1e999", "0x10", "++1", "--1"})
    EXPECT_EQ(parse_number(bad), std::nullopt) << '"' << bad << '"';
}

TEST(Text, ReadsWholeIntegers) {
  EXPECT_EQ(parse_integer("42"), 42);
  EXPECT_EQ(parse_integer("-42"), -42);
  EXPECT_EQ(parse_integer("9223372036854775807"), 9223372036854775807LL);
  for (const char* bad : {"", "+1", "1.0", "1e3", "9223372036854775808", "12a", " 1", "-"})
    EXPECT_EQ(parse_integer(bad), std::nullopt) << '"' << bad << '"';
}

}  // namespace
}  // namespace sinew
