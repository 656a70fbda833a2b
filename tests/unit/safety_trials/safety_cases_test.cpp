// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "limpet/mission/scenario.hpp"
#include "limpet/safety_trials/safety_trial.hpp"

namespace limpet {
namespace {

TEST(SafetyCases, ProvokeEveryRuleOfTheTable) {
  for (const SafetyRule& rule : SafetyRules()) {
    EXPECT_NE(std::ranges::find(SafetyCases(), rule.id, &SafetyCase::rule), SafetyCases().end())
        << rule.name;
  }
}

TEST(SafetyCases, HaveNamesOfTheirOwnAndAreAnsweredOnceTheyHaveBegun) {
  std::set<std::string_view> names;
  for (const SafetyCase& tested : SafetyCases()) {
    EXPECT_TRUE(names.insert(tested.name).second) << tested.name;
    EXPECT_TRUE(std::ranges::any_of(kTriedPhases, [&](SafetyPhase phase) {
      return phase >= tested.from &&
             SafetyRuleOf(tested.rule).ActionIn(phase) != SafetyAction::kNone;
    })) << tested.name;
    EXPECT_GT(tested.answer.value(), 0.0) << tested.name;
  }
}

TEST(SafetyCases, AreFaultsThatAScenarioUnderstands) {
  for (const SafetyCase& tested : SafetyCases()) {
    if (tested.fault.empty()) continue;
    const std::string text =
        "faults:\n  - {" + std::string(tested.fault) + ", when: SURVEY_PHASE = DIVE, at_s: 3}\n";
    EXPECT_EQ(ParseScenario(text, "scenario.yaml").faults.size(), 1U) << text;
  }
}

}  // namespace
}  // namespace limpet
