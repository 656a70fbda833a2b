// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/console/command.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Words = std::vector<std::string>;

Command DiveForm() {
  return {.name = "limpet dive",
          .words = "<place> [NAME ...]",
          .options = {{.names = "-d,--depth,--moos_depth",
                       .value = "M",
                       .fallback = "5",
                       .rule = NumberBetween(0.0, 100.0, "metres")},
                      {.names = "--runs", .value = "N", .fallback = "2", .rule = WholeNumber(1)},
                      {.names = "--note", .value = "TEXT", .is_repeatable = true},
                      {.names = "-q,--quiet"},
                      {.names = "-Q"}},
          .takes = "a place",
          .least_words = 1};
}

Arguments Read(const Words& words) { return ReadArguments(DiveForm(), words); }

std::string ComplaintOf(const Words& words) {
  try {
    static_cast<void>(Read(words));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(CommandReader, TakesValuesBehindABlankOrAnEqualsSign) {
  EXPECT_EQ(Read({"bay", "--depth", "7"}).Number("depth"), 7.0);
  EXPECT_EQ(Read({"--depth=8", "bay"}).Number("depth"), 8.0);
  EXPECT_EQ(Read({"bay", "-d", "9"}).Number("depth"), 9.0);
  EXPECT_EQ(Read({"bay", "-d9.5"}).Number("depth"), 9.5);
  EXPECT_EQ(Read({"bay", "--moos_depth=10"}).Number("depth"), 10.0);
}

TEST(CommandReader, TakesAValueAsItStands) {
  const Arguments given = Read({"bay", "--note=", "--note", "", "--note", "-3", "--note=a=b",
                                "--note", "[a,b]", "--note", "--quiet", "--note=%x y"});
  EXPECT_THAT(given.All("note"), ElementsAre("", "", "-3", "a=b", "[a,b]", "--quiet", "%x y"));
  EXPECT_FALSE(given.Has("quiet"));
}

TEST(CommandReader, CountsTheLastOfSeveralValues) {
  const Arguments given = Read({"bay", "--runs", "3", "--runs", "4"});
  EXPECT_EQ(given.Integer("runs"), 4);
}

TEST(CommandReader, FallsBackOnWhatIsDeclared) {
  const Arguments given = Read({"bay"});
  EXPECT_EQ(given.Integer("runs"), 2);
  EXPECT_EQ(given.Number("depth"), 5.0);
  EXPECT_FALSE(given.Has("runs"));
  EXPECT_EQ(given.Find("note"), std::nullopt);
  EXPECT_THAT(given.All("note"), IsEmpty());
}

TEST(CommandReader, KeepsWordsInOrderAmongOptions) {
  const Arguments given = Read({"bay", "-q", "[x,y]", "A=1", "--runs", "3", "-", "-5", "*"});
  EXPECT_THAT(given.positionals(), ElementsAre("bay", "[x,y]", "A=1", "-", "-5", "*"));
  EXPECT_TRUE(given.Has("quiet"));
}

TEST(CommandReader, TakesEverythingBehindTwoDashesForWords) {
  const Arguments given = Read({"-Q", "--", "--depth", "-q", "--help"});
  EXPECT_THAT(given.positionals(), ElementsAre("--depth", "-q", "--help"));
  EXPECT_FALSE(given.Has("quiet"));
  EXPECT_TRUE(given.Has("Q"));
}

TEST(CommandReader, NamesWhatIsWrong) {
  EXPECT_EQ(ComplaintOf({}), "dive takes a place");
  EXPECT_EQ(ComplaintOf({"bay", "--dpeth", "7"}), "unknown option --dpeth; did you mean --depth?");
  EXPECT_EQ(ComplaintOf({"--dpeth=7"}), "unknown option --dpeth; did you mean --depth?")
      << "before the missing word";
  EXPECT_EQ(ComplaintOf({"bay", "--zzzzzzzz"}), "unknown option --zzzzzzzz");
  EXPECT_EQ(ComplaintOf({"bay", "--depth"}), "--depth needs a value");
  EXPECT_EQ(ComplaintOf({"bay", "-d"}), "-d needs a value");
  EXPECT_EQ(ComplaintOf({"bay", "--depth", "deep"}), "--depth takes 0 to 100 metres, not `deep`");
  EXPECT_EQ(ComplaintOf({"bay", "--depth=nan"}), "--depth takes 0 to 100 metres, not `nan`");
  EXPECT_EQ(ComplaintOf({"bay", "--runs="}),
            "--runs takes a whole number of at least 1, not an empty word");
  EXPECT_EQ(ComplaintOf({"bay", "--quiet=false"}), "--quiet takes no value");
}

TEST(CommandReader, LeavesHelpToWhoAsksForIt) {
  for (const Words& words : {Words{"--help"}, {"-h"}, {"--dpeth", "-h"}, {"--runs", "0", "--help"}})
    EXPECT_TRUE(Read(words).Has("help"));
  EXPECT_FALSE(Read({"bay"}).Has("help"));
}

}  // namespace
}  // namespace limpet
