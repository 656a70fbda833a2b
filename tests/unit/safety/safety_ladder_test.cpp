// SPDX-License-Identifier: MIT
#include "limpet/safety/safety_ladder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/allocation_count.hpp"

namespace limpet {
namespace {

using Id = SafetyRuleId;

class SafetyLadderTest : public testing::Test {
 protected:
  void See(Id id, std::optional<double> measure) {
    measures_[static_cast<std::size_t>(id)] = measure;
  }
  void Run(double seconds, SafetyPhase phase = SafetyPhase::kSurvey) {
    for (int i = 0; i < std::lround(10.0 * seconds); ++i) {
      now_ += Seconds(0.1);
      ladder_.Update(measures_, phase, now_);
    }
  }

  SafetySettings settings_;
  SafetyMeasures measures_{};
  SafetyLadder ladder_{settings_};
  Seconds now_{1000.0};
};

TEST_F(SafetyLadderTest, AsksForNothingWhileAllIsWell) {
  See(Id::kDepthOverLimit, 7.0);
  See(Id::kLeak, 0.0);
  Run(100.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
  EXPECT_EQ(ladder_.leading(), nullptr);
  EXPECT_DOUBLE_EQ(ladder_.MarginOf(Id::kDepthOverLimit).value(), 93.0);
  EXPECT_FALSE(ladder_.MarginOf(Id::kAltitudeLow));
}

TEST_F(SafetyLadderTest, TripsOnlyAfterItsHoldTime) {
  See(Id::kDepthOverLimit, 101.0);
  Run(2.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
  Run(0.2);
  EXPECT_EQ(ladder_.action(), SafetyAction::kSurface);
  EXPECT_EQ(ladder_.leading()->name, "depth_over_limit");
  EXPECT_GT(ladder_.since(), Seconds(1001.9));
}

TEST_F(SafetyLadderTest, BeginsTheHoldTimeAnewAfterASoundMeasure) {
  for (int i = 0; i < 5; ++i) {
    See(Id::kDepthOverLimit, 101.0);
    Run(1.5);
    See(Id::kDepthOverLimit, 99.0);
    Run(0.1);
  }
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
}

TEST_F(SafetyLadderTest, CountsOnThroughAMeasureThatIsMissing) {
  See(Id::kDepthOverLimit, 101.0);
  Run(1.5);
  See(Id::kDepthOverLimit, std::nullopt);
  Run(1.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
  See(Id::kDepthOverLimit, 101.0);
  Run(0.1);
  EXPECT_EQ(ladder_.action(), SafetyAction::kSurface);
}

TEST_F(SafetyLadderTest, TakesWhatIsNotANumberForUnknown) {
  See(Id::kDepthOverLimit, std::numeric_limits<double>::quiet_NaN());
  See(Id::kAltitudeLow, -std::numeric_limits<double>::infinity());
  Run(10.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
}

TEST_F(SafetyLadderTest, TripsBelowALimitToo) {
  See(Id::kBatteryLow, 26.0);
  Run(20.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
  See(Id::kBatteryLow, 24.0);
  Run(11.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kReturn);
}

TEST_F(SafetyLadderTest, DoesTheHighestOfWhatStands) {
  See(Id::kDetectorStorm, 50.0);
  Run(6.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kWarn);
  See(Id::kBatteryLow, 20.0);
  Run(11.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kReturn);
  See(Id::kLeak, 1.0);
  Run(1.5);
  EXPECT_EQ(ladder_.action(), SafetyAction::kAbort);
  EXPECT_EQ(ladder_.leading()->name, "leak");
}

TEST_F(SafetyLadderTest, NamesTheRuleThatAskedFirst) {
  See(Id::kDvlLost, 200.0);
  Run(1.0);
  See(Id::kDepthOverLimit, 101.0);  // stands before it in the table
  Run(10.0);
  EXPECT_EQ(ladder_.leading()->name, "dvl_lost");
}

TEST_F(SafetyLadderTest, LetsGoOfAHoldOnceAllHasBeenWellForAWhile) {
  See(Id::kDetectorSilent, 25.0);
  Run(0.2);
  ASSERT_EQ(ladder_.action(), SafetyAction::kHold);
  See(Id::kDetectorSilent, 0.0);
  Run(1.9);
  EXPECT_EQ(ladder_.action(), SafetyAction::kHold);
  Run(0.3);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
}

TEST_F(SafetyLadderTest, HoldsNobodyOnTheWayHome) {
  See(Id::kDetectorSilent, 25.0);
  Run(0.2);
  ASSERT_EQ(ladder_.action(), SafetyAction::kHold);
  Run(0.1, SafetyPhase::kReturn);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
}

TEST_F(SafetyLadderTest, IsNotWellAgainWithinTheHysteresisOrWhileNothingIsKnown) {
  See(Id::kSigmaHigh, 5.5);
  Run(6.0);
  ASSERT_EQ(ladder_.action(), SafetyAction::kDegrade);
  See(Id::kSigmaHigh, 4.8);
  Run(60.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kDegrade);
  See(Id::kSigmaHigh, 4.0);
  Run(9.0);
  See(Id::kSigmaHigh, std::nullopt);
  Run(0.1);
  See(Id::kSigmaHigh, 4.0);
  Run(9.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kDegrade);
  Run(2.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
}

TEST_F(SafetyLadderTest, NeverTakesBackTheWayHomeByItself) {
  See(Id::kBatteryLow, 20.0);
  Run(11.0);
  ASSERT_EQ(ladder_.action(), SafetyAction::kReturn);
  See(Id::kBatteryLow, 90.0);
  Run(1000.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kReturn);
}

TEST_F(SafetyLadderTest, StandsByWhatItAskedForInALaterPhaseThatAsksForLess) {
  See(Id::kAltitudeLow, 0.5);
  Run(4.0);
  ASSERT_EQ(ladder_.action(), SafetyAction::kSurface);
  Run(100.0, SafetyPhase::kAscend);
  Run(100.0, SafetyPhase::kIdle);
  EXPECT_EQ(ladder_.action(), SafetyAction::kSurface);
}

TEST_F(SafetyLadderTest, AsksForMoreInAPhaseThatAsksForMore) {
  See(Id::kLeak, 1.0);
  Run(2.0, SafetyPhase::kIdle);
  ASSERT_EQ(ladder_.action(), SafetyAction::kWarn);
  Run(0.2, SafetyPhase::kAlign);
  EXPECT_EQ(ladder_.action(), SafetyAction::kAbort);
}

TEST_F(SafetyLadderTest, AnOperatorLiftsAnAbortAndWhatIsStillSoAsksAgain) {
  See(Id::kLeak, 1.0);
  Run(2.0);
  ASSERT_EQ(ladder_.action(), SafetyAction::kAbort);
  ladder_.Reset(now_);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
  Run(2.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kAbort);
  See(Id::kLeak, 0.0);
  ladder_.Reset(now_);
  Run(10.0);
  EXPECT_EQ(ladder_.action(), SafetyAction::kNone);
}

TEST_F(SafetyLadderTest, TakesUpWhatStoodInAFormerLife) {
  ladder_.Recall(Id::kLeak, SafetyAction::kAbort, now_);
  EXPECT_EQ(ladder_.action(), SafetyAction::kAbort);
  Run(10.0);
  EXPECT_EQ(ladder_.StandingOf(Id::kLeak), SafetyAction::kAbort);
}

TEST_F(SafetyLadderTest, ARuleThatIsOffNeverTrips) {
  settings_.is_off[static_cast<std::size_t>(Id::kLeak)] = true;
  SafetyLadder ladder(settings_);
  See(Id::kLeak, 1.0);
  ladder.Update(measures_, SafetyPhase::kSurvey, now_);
  ladder.Update(measures_, SafetyPhase::kSurvey, now_ + Seconds(10.0));
  EXPECT_EQ(ladder.action(), SafetyAction::kNone);
}

TEST_F(SafetyLadderTest, AllocatesNothing) {
  See(Id::kLeak, 1.0);
  See(Id::kDetectorStorm, 50.0);
  const long before = AllocationCount();
  Run(100.0);
  ladder_.Reset(now_);
  EXPECT_EQ(AllocationCount(), before);
}

/// Every row in every phase: nothing but what the table says, no sooner than it says.
class SafetyRow : public testing::TestWithParam<std::size_t> {};

TEST_P(SafetyRow, DoesInEveryPhaseWhatTheTableSaysAfterItsHoldTime) {
  const SafetyRule& rule = SafetyRules()[GetParam()];
  for (std::size_t p = 0; p < kSafetyPhases; ++p) {
    const auto phase = static_cast<SafetyPhase>(p);
    SafetyLadder ladder{SafetySettings()};
    SafetyMeasures measures{};
    const double off = rule.side == SafetyRule::Side::kAbove ? 0.25 : -0.25;
    measures[GetParam()] = rule.limit.value + off;
    const Seconds start(50.0);
    ladder.Update(measures, phase, start);
    if (rule.hold > Seconds(0.0)) {
      EXPECT_EQ(ladder.action(), SafetyAction::kNone) << rule.name << NameOf(phase);
    }
    ladder.Update(measures, phase, start + rule.hold);
    EXPECT_EQ(ladder.action(), rule.ActionIn(phase)) << rule.name << NameOf(phase);
  }
}

TEST_P(SafetyRow, WithAnyOtherDoesTheStrongerAction) {
  for (std::size_t other = 0; other < kSafetyRules; ++other) {
    for (std::size_t p = 0; p < kSafetyPhases; ++p) {
      const auto phase = static_cast<SafetyPhase>(p);
      SafetyLadder ladder{SafetySettings()};
      SafetyMeasures measures{};
      for (const std::size_t index : {GetParam(), other}) {
        const SafetyRule& rule = SafetyRules()[index];
        const double off = rule.side == SafetyRule::Side::kAbove ? 0.25 : -0.25;
        measures[index] = rule.limit.value + off;
      }
      ladder.Update(measures, phase, Seconds(50.0));
      ladder.Update(measures, phase, Seconds(5000.0));
      EXPECT_EQ(ladder.action(), std::max(SafetyRules()[GetParam()].ActionIn(phase),
                                          SafetyRules()[other].ActionIn(phase)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfTheTable, SafetyRow, testing::Range<std::size_t>(0, kSafetyRules),
                         [](const auto& tested) {
                           return std::string(SafetyRules()[tested.param].name);
                         });

TEST(SafetyTable, NamesAndKeysAreUnambiguousAndLimitsAreAllowed) {
  std::set<std::string_view> names, keys;
  for (const SafetyRule& rule : SafetyRules()) {
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
    EXPECT_TRUE(rule.limit.key.empty() || keys.insert(rule.limit.key).second) << rule.name;
    EXPECT_GE(rule.limit.value, rule.limit.least) << rule.name;
    EXPECT_LE(rule.limit.value, rule.limit.most) << rule.name;
    EXPECT_EQ(SafetyRuleOf(rule.id).name, rule.name);
  }
}

TEST(SafetyTable, KnowsThePhasesOfASurvey) {
  EXPECT_EQ(SafetyPhaseOf("ALIGN"), SafetyPhase::kAlign);
  EXPECT_EQ(SafetyPhaseOf("DIVE"), SafetyPhase::kDive);
  EXPECT_EQ(SafetyPhaseOf("SURVEY"), SafetyPhase::kSurvey);
  EXPECT_EQ(SafetyPhaseOf("RETURN"), SafetyPhase::kReturn);
  EXPECT_EQ(SafetyPhaseOf("ASCEND"), SafetyPhase::kAscend);
  EXPECT_EQ(SafetyPhaseOf("FIX"), SafetyPhase::kAscend);
  EXPECT_EQ(SafetyPhaseOf("DONE"), SafetyPhase::kIdle);
  EXPECT_EQ(SafetyPhaseOf("PAUSE"), SafetyPhase::kIdle) << "a word that no survey says";
  EXPECT_EQ(NameOf(SafetyPhase::kReturn), "return");
}

TEST(SafetyActions, AreTheirWords) {
  for (const char* word : {"none", "warn", "degrade", "hold", "return", "surface", "abort"}) {
    EXPECT_EQ(NameOf(SafetyActionNamed(word).value()), word);
  }
  EXPECT_FALSE(SafetyActionNamed("panic"));
}

}  // namespace
}  // namespace limpet
