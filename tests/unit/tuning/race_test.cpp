// SPDX-License-Identifier: MIT
#include "limpet/tuning/race.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tuning/fake_runs.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

TEST(Race, EliminatesLosersEarlyAlthoughSeedsDifferMoreThanSettings) {
  FakeRuns runs{.cost = [](const SettingValues& s) { return 10.0 * s[0]; }};
  Race race({.runs = 20}, {.setting = {2.0}}, std::ref(runs));
  race.Enter({{0.0}, {1.0}, {3.0}, {9.0}});
  ASSERT_TRUE(race.Run());
  EXPECT_EQ(race.Best(true), 1U);
  EXPECT_EQ(runs.runs_of[1], 20);
  EXPECT_EQ(runs.runs_of[4], 5);
  EXPECT_THAT(race.contenders()[4].eliminated, HasSubstr("worse than the leader by"));
  EXPECT_EQ(runs.runs_of[0], 20) << "the default is always flown to the end";
  EXPECT_TRUE(race.contenders()[0].is_in());
}

TEST(Race, EliminatesNoneOfEquals) {
  FakeRuns runs{.cost = [](const SettingValues&) { return 1.0; }};
  Race race({.runs = 20}, {.setting = {0.0}}, std::ref(runs));
  race.Enter({{1.0}, {2.0}, {3.0}});
  ASSERT_TRUE(race.Run());
  for (const Contender& contender : race.contenders())
    EXPECT_TRUE(contender.is_in()) << contender.eliminated;
}

TEST(Race, EliminatesWhatBreaksConstraintsTooOftenHoweverCheap) {
  const auto fly = [](const std::vector<Contender>& all, const std::vector<Flight>& flights) {
    std::vector<RunOutcome> outcomes;
    for (const Flight& flight : flights) {
      const double x = all[flight.contender].setting[0];
      outcomes.push_back({.cost = x, .keeps_constraints = x >= 0.0});
    }
    return outcomes;
  };
  Race race({.runs = 10}, {.setting = {5.0}}, fly);
  race.Enter({{-1.0}, {1.0}});
  ASSERT_TRUE(race.Run());
  EXPECT_THAT(race.contenders()[1].eliminated, HasSubstr("break a constraint"));
  EXPECT_EQ(race.Best(true), 2U);
}

TEST(Race, CountsARunWithoutObjectiveAsFailed) {
  const auto fly = [](const std::vector<Contender>&, const std::vector<Flight>& flights) {
    return std::vector<RunOutcome>(flights.size());
  };
  Race race({.runs = 4}, {.setting = {5.0}}, fly);
  race.Enter({{1.0}});
  ASSERT_TRUE(race.Run());
  EXPECT_FALSE(race.Best(true));
}

TEST(Race, StopsWhenItIsInterrupted) {
  Race race({.runs = 4}, {.setting = {5.0}},
            [](const std::vector<Contender>&, const std::vector<Flight>&) {
              return std::vector<RunOutcome>{};
            });
  EXPECT_FALSE(race.Run());
}

}  // namespace
}  // namespace limpet
