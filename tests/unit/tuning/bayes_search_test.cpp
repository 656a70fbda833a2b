// SPDX-License-Identifier: MIT
#include "limpet/tuning/bayes_search.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tuning/fake_runs.hpp"

namespace limpet {
namespace {

/// Least at x = 7, y = 0.25.
double Bowl(const SettingValues& s) {
  return 2.0 * std::abs(s[0] - 7.0) + 20.0 * (s[1] - 0.25) * (s[1] - 0.25);
}

TEST(BayesSearch, ComesNearTheBestInFewSettingsDespiteNoise) {
  const ParameterSpace space(
      {*VariedParameter::Parse("a.x=0:10"), *VariedParameter::Parse("a.y=0:1")});
  FakeRuns runs{.cost = Bowl, .own_sigma = 0.5};
  Race race({.runs = 8}, {.setting = {2.0, 0.9}}, std::ref(runs));
  race.Enter(space.Spread(6, 1));
  ASSERT_TRUE(race.Run());
  for (int round = 0; round < 5; ++round) {
    race.Enter(MostPromising(space, race.contenders(), 4, 7));
    ASSERT_TRUE(race.Run());
  }
  const Contender& best = race.contenders()[*race.Best(true)];
  EXPECT_NEAR(best.setting[0], 7.0, 0.6);
  EXPECT_NEAR(best.setting[1], 0.25, 0.2);
}

TEST(BayesSearch, ProposesNothingTwiceAndStopsWhenAllLevelsAreTried) {
  const ParameterSpace space({*VariedParameter::Parse("a.x=0:4:5")});
  std::vector<Contender> flown{{.setting = {2.0}, .is_default = true, .outcomes = {{1.0}, {2.0}}},
                               {.setting = {0.0}, .outcomes = {{2.0}, {3.0}}}};
  const std::vector<SettingValues> next = MostPromising(space, flown, 10, 1);
  EXPECT_THAT(next, testing::UnorderedElementsAre(SettingValues{1.0}, SettingValues{3.0},
                                                  SettingValues{4.0}));
}

}  // namespace
}  // namespace limpet
