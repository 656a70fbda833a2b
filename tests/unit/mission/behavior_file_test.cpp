// SPDX-License-Identifier: MIT
#include "limpet/mission/behavior_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/mission/mode_set.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using Table = std::map<std::string, Value, std::less<>>;

std::string BehaviorErrorsOf(const std::string& text) {
  try {
    static_cast<void>(ParseBehaviors(text, "m.bhv"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(BehaviorFile, ReadsSeveralInitializesOfALine) {
  const BehaviorFile file =
      ParseBehaviors("initialize A = true, B = 2.5, C = \"7,8\"\ninitialize_ D=1\n", "m.bhv");
  ASSERT_EQ(file.initializes.size(), 4U);
  EXPECT_EQ(file.initializes[0].value, Value(std::string("true")));
  EXPECT_EQ(file.initializes[1].value, Value(2.5));
  EXPECT_EQ(file.initializes[2].value, Value(std::string("7,8")));
  EXPECT_TRUE(file.initializes[3].is_deferred);
  EXPECT_FALSE(file.initializes[0].is_deferred);
}

TEST(BehaviorFile, KeepsParametersInOrderWithTheirLines) {
  const BehaviorFile file = ParseBehaviors(
      "Behavior = BHV_X\n{\n  name = a // first\n  _pwt = 50\n  flag = B=c\n}\n", "m.bhv");
  ASSERT_EQ(file.behaviors.size(), 1U);
  EXPECT_EQ(file.behaviors[0].name, "BHV_X");
  ASSERT_EQ(file.behaviors[0].entries.size(), 3U);
  EXPECT_EQ(file.behaviors[0].entries[1].key, "pwt");
  EXPECT_EQ(file.behaviors[0].entries[2].value, "B=c");
  EXPECT_EQ(file.behaviors[0].entries[2].where.line, 5);
}

TEST(BehaviorFile, AcceptsABraceAtTheEndOfTheHeader) {
  EXPECT_EQ(ParseBehaviors("behavior=BHV_X {\nname=a\n}\n", "m.bhv").behaviors.size(), 1U);
}

TEST(BehaviorFile, JoinsLinesAtABackslash) {
  const BehaviorFile file =
      ParseBehaviors("Behavior=BHV_X\n{\npoints = 0,0 : \\\n  1,1\n}\n", "m.bhv");
  EXPECT_EQ(file.behaviors[0].entries[0].value, "0,0 : 1,1");
  EXPECT_EQ(file.behaviors[0].entries[0].where.line, 3);
}

TEST(BehaviorFile, TellsThatABraceAfterAValueDoesNotClose) {
  EXPECT_THAT(BehaviorErrorsOf("Behavior=BHV_X\n{\npwt = 100 }\n"),
              HasSubstr("m.bhv:3: pwt: a `}` after a value"));
}

TEST(BehaviorFile, KeepsBracesOfBalancedValues) {
  const BehaviorFile file =
      ParseBehaviors("Behavior=BHV_X\n{\npolygon = pts={0,0:1,1}\n}\n", "m.bhv");
  EXPECT_EQ(file.behaviors[0].entries[0].value, "pts={0,0:1,1}");
}

TEST(BehaviorFile, RefusesUnknownTopLevelText) {
  EXPECT_THAT(BehaviorErrorsOf("initalize A = 1\n"),
              HasSubstr("m.bhv:1: initalize: unknown text `initalize A = 1`; did you mean "
                        "`initialize`?"));
  EXPECT_THAT(BehaviorErrorsOf("# comment\n"), HasSubstr("unknown text"));
}

TEST(BehaviorFile, RefusesTwoBehaviorsOfOneName) {
  EXPECT_THAT(BehaviorErrorsOf("Behavior=BHV_X\n{\nname=a\n}\nBehavior=BHV_Y\n{\nname=a\n}\n"),
              HasSubstr("m.bhv:7: name: `a` is the name of two behaviors"));
}

TEST(BehaviorFile, RefusesNamesThatToolsCannotRead) {
  EXPECT_THAT(BehaviorErrorsOf("Behavior=BHV_X\n{\nname=a b\n}\n"),
              HasSubstr("`a b` is not allowed"));
}

TEST(BehaviorFile, RefusesDoubleEqualsInModes) {
  EXPECT_THAT(BehaviorErrorsOf("set MODE = A {\nX == 1\n} B\n"),
              HasSubstr("m.bhv:2: set MODE: `==`"));
}

TEST(BehaviorFile, TellsOnceThatAModeNeedsLinesOfItsOwn) {
  const std::string next = "Behavior=BHV_X\n{\nname=a\n}\n";
  for (const char* mode : {"set M = A { X = true } B\n", "set M = A { X = true }\nB\n",
                           "set M = A { X = true }\n", "set M = A { X = true\n} B\n"}) {
    const std::string complaint = BehaviorErrorsOf(mode + next);
    EXPECT_THAT(complaint, HasSubstr("m.bhv:1: set: `M = A { X = true")) << mode;
    EXPECT_THAT(complaint, HasSubstr("each condition on a line of its own")) << mode;
    EXPECT_EQ(complaint.find("m.bhv:", 1), std::string::npos) << complaint;
  }
}

TEST(BehaviorFile, ReportsAnOpenBlock) {
  EXPECT_THAT(BehaviorErrorsOf("Behavior=BHV_X\n{\nname=a\n"),
              HasSubstr("m.bhv:1: BHV_X: has no closing"));
}

TEST(BehaviorFile, ReadsElseOnTheSameLineOrTheNext) {
  EXPECT_EQ(ParseBehaviors("set M = A {\nX=1\n} B\n", "").modes[0].else_value, "B");
  EXPECT_EQ(ParseBehaviors("set M = A {\nX=1\n}\nB\n", "").modes[0].else_value, "B");
  EXPECT_EQ(ParseBehaviors("set M = A {\nX=1\n}\nset M = C {\nX=2\n}\n", "").modes.size(), 2U);
  EXPECT_THAT(BehaviorErrorsOf("set M = A {\nX=1\n}\n\nB\n"), HasSubstr(":5: B: unknown text"));
}

TEST(BehaviorFile, LoadsOurOwnMission) {
  const BehaviorFile file =
      LoadBehaviors(std::filesystem::path(LIMPET_SOURCE_DIR) / "missions/table1/mission.bhv");
  EXPECT_GE(file.behaviors.size(), 5U);
  EXPECT_GE(file.modes.size(), 3U);
}

class ModeSetTest : public ::testing::Test {
 protected:
  std::string ModeWith(const Table& table) {
    const auto lookup = [&table](std::string_view name) -> const Value* {
      const auto found = table.find(name);
      return found == table.end() ? nullptr : &found->second;
    };
    const std::vector<ModeSet::Mode> found = modes_.Evaluate(lookup, Seconds(0.0));
    is_changed_ = !found.empty() && found[0].is_changed;
    return found.empty() ? "" : found[0].value;
  }
  static Value Text(const char* text) { return std::string(text); }

  ModeSet modes_{ParseBehaviors("set MODE = ACTIVE {\n  DEPLOY = true\n} INACTIVE\n\n"
                                "set MODE = SURVEYING {\n  MODE = ACTIVE\n  SURVEY = true\n} "
                                "LOITERING\n",
                                "m.bhv")
                     .modes};
  bool is_changed_ = false;
};

TEST_F(ModeSetTest, TakesTheElseValueWhenConditionsFail) {
  EXPECT_EQ(ModeWith({{"DEPLOY", Text("false")}}), "INACTIVE");
  EXPECT_EQ(ModeWith({}), "INACTIVE");
}

TEST_F(ModeSetTest, NamesChildrenBelowTheirParent) {
  EXPECT_EQ(ModeWith({{"DEPLOY", Text("true")}, {"SURVEY", Text("true")}}), "ACTIVE:SURVEYING");
  EXPECT_EQ(ModeWith({{"DEPLOY", Text("true")}, {"SURVEY", Text("false")}}), "ACTIVE:LOITERING");
}

TEST_F(ModeSetTest, TellsOnlyChanges) {
  const Table table{{"DEPLOY", Text("true")}};
  ModeWith(table);
  EXPECT_TRUE(is_changed_);
  ModeWith(table);
  EXPECT_FALSE(is_changed_);
}

TEST_F(ModeSetTest, SummarisesTheTree) {
  EXPECT_EQ(modes_.Summary(), "MODE#---,ACTIVE#---,INACTIVE#ACTIVE,SURVEYING#ACTIVE,LOITERING");
}

TEST(ModeSet, ConcatenatesDeeperNesting) {
  ModeSet modes(ParseBehaviors("set M = A {\nX = 1\n}\n\nset M = B {\nM = A\n}\n\n"
                               "set M = C {\nM = A:B\n}\n",
                               "m.bhv")
                    .modes);
  const Value one = 1.0;
  const auto found = modes.Evaluate([&one](std::string_view) { return &one; }, Seconds(0.0));
  EXPECT_EQ(found[0].value, "A:B:C");
}

TEST(ModeSet, SaysNothingOfAVariableThatNothingSets) {
  ModeSet modes(ParseBehaviors("set M = A {\nX = 1\n}\n", "m.bhv").modes);
  EXPECT_TRUE(modes.Evaluate([](std::string_view) { return nullptr; }, Seconds(0.0)).empty());
}

TEST(BehaviorFile, PassesOverABlockWhoseFirstLineIsCommentedOut) {
  const BehaviorFile file = ParseBehaviors(
      "//Behavior = BHV_AvoidCollision\n{\n  name = avoid_\n  pwt  = 500\n}\n"
      "Behavior = BHV_Waypoint\n{\n  name = survey\n}\n",
      "a.bhv");
  ASSERT_EQ(file.behaviors.size(), 1U);
  EXPECT_EQ(BehaviorNameOf(file.behaviors[0]), "survey");
  ASSERT_EQ(file.warnings.size(), 1U);
  EXPECT_EQ(file.warnings[0].where.line, 2);
  EXPECT_THROW(static_cast<void>(ParseBehaviors("{\n  name = avoid_\n", "a.bhv")), ConfigError);
}

}  // namespace
}  // namespace limpet
