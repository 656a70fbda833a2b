// SPDX-License-Identifier: MIT
// Racing and the model-based search, on functions whose best setting is known.
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/tuning/bayes_search.hpp"
#include "limpet/tuning/race.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

/// A cost of each setting with noise of its own and noise that all settings share per seed.
struct FakeRuns {
  std::function<double(const Setting&)> cost;
  double own_sigma = 1.0;
  double shared_sigma = 50.0;
  std::vector<int> runs_of{};  ///< how often each contender was flown
  std::set<std::pair<std::size_t, std::size_t>> flown{};

  std::vector<RunOutcome> operator()(const std::vector<Contender>& contenders,
                                     const std::vector<Flight>& flights) {
    runs_of.resize(contenders.size());
    std::vector<RunOutcome> outcomes;
    for (const Flight& flight : flights) {
      EXPECT_TRUE(flown.emplace(flight.contender, flight.seed_index).second) << "flown twice";
      ++runs_of[flight.contender];
      Random shared(flight.seed_index, "shared");
      Random own(flight.seed_index, "own" + std::to_string(flight.contender));
      outcomes.push_back({.cost = cost(contenders[flight.contender].setting) +
                                  shared.Normal(shared_sigma) + own.Normal(own_sigma)});
    }
    return outcomes;
  }
};

TEST(Race, EliminatesLosersEarlyAlthoughSeedsDifferMoreThanSettings) {
  FakeRuns runs{.cost = [](const Setting& s) { return 10.0 * s[0]; }};
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
  FakeRuns runs{.cost = [](const Setting&) { return 1.0; }};
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

ParameterSpace Square() {
  return ParameterSpace({*VariedParameter::Parse("a.x=0:10"), *VariedParameter::Parse("a.y=0:1")});
}

/// Least at x = 7, y = 0.25.
double Bowl(const Setting& s) {
  return 2.0 * std::abs(s[0] - 7.0) + 20.0 * (s[1] - 0.25) * (s[1] - 0.25);
}

TEST(BayesSearch, ComesNearTheBestInFewSettingsDespiteNoise) {
  const ParameterSpace space = Square();
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
  const std::vector<Setting> next = MostPromising(space, flown, 10, 1);
  EXPECT_THAT(next, testing::UnorderedElementsAre(Setting{1.0}, Setting{3.0}, Setting{4.0}));
}

TEST(ParameterSpace, ReadsWhatIsVaried) {
  const auto parameter = VariedParameter::Parse("cover.frontier_weight=0:1:5");
  ASSERT_TRUE(parameter);
  EXPECT_EQ(parameter->name, "cover.frontier_weight");
  EXPECT_EQ(parameter->ValueAt(0.3), 0.25);
  EXPECT_EQ(parameter->ValueAt(2.0), 1.0);
  EXPECT_EQ(parameter->Text(), "cover.frontier_weight=0:1:5");
  EXPECT_EQ(VariedParameter::Parse("a.b=0:1:11")->ValueAt(0.3), 0.3);
  for (const char* wrong : {"", "a.b", "a=0:1", ".b=0:1", "a.=0:1", "a.b=1", "a.b=2:1", "a.b=1:1",
                            "a.b=x:1", "a.b=0:1:1", "a.b=0:1:5000", "a.b=0:1:2:3"}) {
    EXPECT_FALSE(VariedParameter::Parse(wrong)) << wrong;
  }
}

TEST(ParameterSpace, MakesAGridOfAllLevels) {
  const ParameterSpace space(
      {*VariedParameter::Parse("a.x=0:1:2"), *VariedParameter::Parse("a.y=0:4")});
  const auto grid = space.Grid();
  ASSERT_TRUE(grid);
  ASSERT_EQ(grid->size(), 10U);
  EXPECT_EQ((*grid)[1], (Setting{0.0, 1.0}));
  EXPECT_EQ(space.TextsOf((*grid)[9]), (std::vector<std::string>{"a.x=1", "a.y=4"}));
  std::vector<VariedParameter> many(9, *VariedParameter::Parse("a.x=0:1:10"));
  EXPECT_FALSE(ParameterSpace(many).Grid());
}

TEST(ParameterSpace, SpreadsSettingsOverEveryPartOfEachRange) {
  const std::vector<Setting> spread = Square().Spread(10, 3);
  ASSERT_EQ(spread.size(), 10U);
  std::set<int> parts;
  for (const Setting& setting : spread)
    parts.insert(static_cast<int>(setting[0]));
  EXPECT_EQ(parts.size(), 10U);
  EXPECT_EQ(Square().Spread(10, 3), spread);
}

}  // namespace
}  // namespace limpet
