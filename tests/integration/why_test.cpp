// SPDX-License-Identifier: MIT
// What `limpet why` says is what the helm did: from the table of each decision anybody can compute
// the same choice again, and the weights that it names do change it.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/decision/merit.hpp"
#include "limpet/explain/explanation.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/mission.hpp"
#include "tests/support/small_mission.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

struct FlownDecision {
  double time = 0.0;
  HelmBids bids;
  std::optional<HelmPath> path;  ///< that was flown
};
struct ExplainedFlight {
  std::vector<FlownDecision> decisions;
  DecisionLog log;
};

ExplainedFlight FlySmallMission(const std::string& planner, std::uint64_t seed) {
  const TemporaryFolder folder;
  WriteSmallMission(folder.path() / "small");
  MissionFile mission = LoadMission(folder.path() / "small" / "mission.moos");
  ApplySetting(mission, "pHelm.planner=" + planner);
  const SessionPlan plan{.session = "discovery",
                         .mission_folder = folder.path() / "small",
                         .run_folder = folder.path() / "discovery",
                         .prior_folder = {},
                         .seed = seed};
  ExplainedFlight flight;
  auto& decisions = flight.decisions;
  static_cast<void>(RunSession(mission, plan, [&](const Message& message) {
    const double time = message.time.value();
    if (const auto* text = std::get_if<std::string>(&message.value)) {
      flight.log.Take({.variable = message.name, .writer = message.source_aux, .value = *text},
                      time);
    }
    if (message.name == "HELM_BIDS") {
      decisions.push_back({time, *TopicCodec<HelmBids>::Decode(message.value), {}});
    } else if (message.name == "HELM_PATH" && !decisions.empty()) {
      decisions.back().path = *TopicCodec<HelmPath>::Decode(message.value);
    }
  }));
  return flight;
}

class WhyOfAFlight : public ::testing::TestWithParam<const char*> {};

TEST_P(WhyOfAFlight, GivesTheHelmsChoiceInEveryDecision) {
  std::vector<FlownDecision> decisions = FlySmallMission(GetParam(), 3).decisions;
  std::ranges::move(FlySmallMission(GetParam(), 4).decisions, std::back_inserter(decisions));
  ASSERT_GE(decisions.size(), 4U);
  for (const auto& [time, bids, path] : decisions) {
    EXPECT_EQ(bids.considered, static_cast<int>(bids.options.size()));
    for (const BiddenOption& option : bids.options) {
      EXPECT_EQ(option.total, TotalOf(option.bids));
      EXPECT_EQ(option.rate, RateOf(option.total, option));
    }
    const Explanation explanation = Explain({.time = 0.0, .bids = bids});
    ASSERT_EQ(explanation.chosen.has_value(), path.has_value());
    if (!path) {
      continue;
    }
    const BiddenOption& chosen = bids.options[*explanation.chosen];
    EXPECT_EQ(chosen.source, path->purpose);
    double length = 0.0;
    for (const PathSegment& segment : path->segments) {
      length += segment.length;
    }
    EXPECT_NEAR(chosen.length, length, 1e-9);
    for (const Flip& flip : explanation.flips) {
      EXPECT_EQ(ChoiceOf(Reweighted(bids, flip.behavior, flip.new_weight)), flip.to);
    }
  }
}

TEST_P(WhyOfAFlight, NamesAsWaitingNobodyWhoBids) {
  const ExplainedFlight flight = FlySmallMission(GetParam(), 3);
  for (const FlownDecision& decision : flight.decisions) {
    const auto waiting = flight.log.WaitingAt(decision.time + DecisionLog::kIteration);
    EXPECT_FALSE(waiting.empty()) << "the way home waits for its mode, or what goes down";
    for (const WaitingBehavior& one : waiting) {
      EXPECT_NE(one.what, "") << one.name;
      const auto bidders = Explain({.time = decision.time, .bids = decision.bids}).bidders;
      EXPECT_EQ(std::ranges::count(bidders, one.name), 0) << one.name << " bids";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(WithPlanner, WhyOfAFlight, ::testing::Values("limpet", "paper"));

}  // namespace
}  // namespace limpet
