// SPDX-License-Identifier: MIT
#include "limpet/tuning/tuning_search.hpp"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/tuning/tuning_report.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

ParameterSpace Line() { return ParameterSpace({*VariedParameter::Parse("a.x=0:4:5")}); }

TuningTask Task(std::size_t runs) {
  TuningTask task{.mission = "m", .objective = "sessions.d.path_m"};
  task.rules.runs = runs;
  return task;
}

/// Costs with noise, of a function; also asks that held-out seeds come last.
Race::Fly Costing(const std::function<double(double)>& cost, double sigma) {
  return [=](const std::vector<Contender>& contenders, const std::vector<Flight>& flights) {
    std::vector<RunOutcome> outcomes;
    for (const Flight& flight : flights) {
      const double x = contenders[flight.contender].setting[0];
      Random own(flight.seed_index, "own" + std::to_string(x));
      Random shared(flight.seed_index, "shared");
      outcomes.push_back({.cost = cost(x) + own.Normal(sigma) + shared.Normal(20.0)});
    }
    return outcomes;
  };
}

TEST(TuningSearch, FindsWhatIsBetterAndIsSureOfItOnSeedsItHasNotSeen) {
  const TuningTask task = Task(10);
  const auto outcome =
      RunTuning(Line(), {0.0}, task.rules,
                Costing([](double x) { return 100.0 + (x - 3.0) * (x - 3.0); }, 0.5));
  ASSERT_TRUE(outcome);
  EXPECT_TRUE(outcome->is_better);
  EXPECT_EQ(outcome->contenders[*outcome->winner].setting, SettingValues{3.0});
  EXPECT_LT(*outcome->Difference()->low, -9.0);
  EXPECT_GT(*outcome->Difference()->high, -9.0);
  EXPECT_THAT(VerdictText(task, Line(), *outcome), HasSubstr("a.x=3 is better than the default"));
}

TEST(TuningSearch, IsSeldomSureWhereNothingIsBetter) {
  int sure = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const auto fly = Costing([](double) { return 100.0; }, 1.0);
    const auto shifted = [&](const std::vector<Contender>& contenders,
                             std::vector<Flight> flights) {
      for (Flight& flight : flights)
        flight.seed_index += static_cast<std::size_t>(trial) * 1000;
      return fly(contenders, flights);
    };
    const auto outcome = RunTuning(Line(), {0.0}, Task(10).rules, shifted);
    sure += outcome->is_better ? 1 : 0;
    if (!outcome->is_better && outcome->winner) {
      EXPECT_THAT(VerdictText(Task(10), Line(), *outcome),
                  HasSubstr("no setting is better than the default: difference"));
    }
  }
  // One in forty by chance: the interval of 95 % lies below 0.
  EXPECT_LE(sure, 4);
}

TEST(TuningSearch, StopsWhenInterrupted) {
  EXPECT_FALSE(RunTuning(Line(), {0.0}, Task(4).rules,
                         [](const std::vector<Contender>&, const std::vector<Flight>&) {
                           return std::vector<RunOutcome>{};
                         }));
}

TEST(TuningReport, TurnsSignsAroundWhenTheGreatestIsWanted) {
  TuningTask task = Task(10);
  task.maximises = true;
  const auto outcome =
      RunTuning(Line(), {0.0}, task.rules, Costing([](double x) { return -5.0 * x; }, 0.1));
  ASSERT_TRUE(outcome && outcome->is_better);
  const auto difference = ObjectiveDifference(task, *outcome);
  EXPECT_GT(difference->mean, 19.0);
  EXPECT_LT(*difference->low, *difference->high);
}

TEST(TuningReport, WritesTheSettingsTheBestAndTheDefaultInOneForm) {
  const TuningTask task = Task(6);
  const auto outcome =
      RunTuning(Line(), {0.0}, task.rules, Costing([](double x) { return 100.0 - 2.0 * x; }, 0.1));
  ASSERT_TRUE(outcome);
  const std::string json = TuneJson(task, Line(), *outcome);
  for (const char* part : {"\"settings\": [", "\"best\": {\n  \"values\": {\n   \"a.x\": 4.0\n  }",
                           "\"default\": {", "\"mean\"", "\"low\"", "\"high\"", "\"runs\": 6",
                           "\"is_better\": true", "\"held_out_seeds\""}) {
    EXPECT_THAT(json, HasSubstr(part));
  }
  const std::string figure = TuneFigure(task, Line(), *outcome);
  EXPECT_THAT(figure, HasSubstr("Least sessions.d.path_m"));
  EXPECT_THAT(figure, HasSubstr("a.x"));
}

TEST(TuningReport, DrawsAndTellsAlsoWhenNoRunHasAnObjective) {
  const auto outcome =
      RunTuning(Line(), {0.0}, Task(4).rules,
                [](const std::vector<Contender>&, const std::vector<Flight>& flights) {
                  return std::vector<RunOutcome>(flights.size());
                });
  ASSERT_TRUE(outcome);
  EXPECT_THAT(VerdictText(Task(4), Line(), *outcome), HasSubstr("no setting but the default"));
  EXPECT_THAT(TuneFigure(Task(4), Line(), *outcome), HasSubstr("</svg>"));
  EXPECT_THAT(TuneJson(Task(4), Line(), *outcome), HasSubstr("\"mean\": null"));
}

}  // namespace
}  // namespace limpet
