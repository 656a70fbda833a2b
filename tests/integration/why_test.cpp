// SPDX-License-Identifier: MIT
// What `limpet why` says is what the helm did: from the table of each decision anybody can compute
// the same choice again, and the weights that it names do change it.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
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
  HelmBids bids;
  std::optional<HelmPath> path;  ///< that was flown
};

std::vector<FlownDecision> FlySmallMission(const std::string& planner, std::uint64_t seed) {
  const TemporaryFolder folder;
  WriteSmallMission(folder.path() / "small");
  MissionFile mission = LoadMission(folder.path() / "small" / "mission.moos");
  ApplySetting(mission, "pHelm.planner=" + planner);
  const SessionPlan plan{.session = "discovery",
                         .mission_folder = folder.path() / "small",
                         .run_folder = folder.path() / "discovery",
                         .prior_folder = {},
                         .seed = seed};
  std::vector<FlownDecision> decisions;
  static_cast<void>(RunSession(mission, plan, [&decisions](const Message& message) {
    if (message.name == "HELM_BIDS") {
      decisions.push_back({*TopicCodec<HelmBids>::Decode(message.value), {}});
    } else if (message.name == "HELM_PATH" && !decisions.empty()) {
      decisions.back().path = *TopicCodec<HelmPath>::Decode(message.value);
    }
  }));
  return decisions;
}

class WhyOfAFlight : public ::testing::TestWithParam<const char*> {};

TEST_P(WhyOfAFlight, GivesTheHelmsChoiceInEveryDecision) {
  std::vector<FlownDecision> decisions = FlySmallMission(GetParam(), 3);
  std::ranges::move(FlySmallMission(GetParam(), 4), std::back_inserter(decisions));
  ASSERT_GE(decisions.size(), 4U);
  for (const auto& [bids, path] : decisions) {
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

INSTANTIATE_TEST_SUITE_P(WithPlanner, WhyOfAFlight, ::testing::Values("limpet", "paper"));

}  // namespace
}  // namespace limpet
