// SPDX-License-Identifier: MIT
#include "limpet/scoring/option_wins.hpp"

#include <string>

#include <gtest/gtest.h>

namespace limpet {
namespace {

DecisionRecord DecisionFor(double time, const std::string& source) {
  HelmBids bids;
  bids.options.resize(2);
  bids.options[0].source = source, bids.options[1].source = "loser";
  return {.time = Seconds(time), .offer = DecisionRecord::Offer(bids)};
}

/// Northwards at 0.5 m/s for 200 s.
PoseTrack StraightTrack() {
  PoseTrack track;
  for (int i = 0; i <= 200; ++i)
    track.Add(Seconds(i), {{0.5 * i, 0.0, 3.0}, 0.0, 0.0, 0.0});
  return track;
}

TEST(OptionWins, CountTheWayUntilTheNextDecision) {
  SessionRecord record("discovery");
  record.decisions = {DecisionFor(10.0, "plan"), DecisionFor(30.0, "beam"),
                      DecisionFor(36.0, "plan")};
  const auto wins = OptionWinsOf(record, StraightTrack());
  ASSERT_EQ(wins.size(), 2U) << "who never wins is not there";
  EXPECT_EQ(wins[0].source, "plan");
  EXPECT_EQ(wins[0].decisions, 2);
  EXPECT_NEAR(wins[0].path_m, 10.0 + 82.0, 1e-9);
  EXPECT_EQ(wins[1].source, "beam");
  EXPECT_NEAR(wins[1].path_m, 3.0, 1e-9);
}

TEST(OptionWins, CountNoWayOfTheAscent) {
  SessionRecord record("discovery");
  record.decisions = {DecisionFor(10.0, "home")};
  record.phases = {{Seconds(0.0), "SURVEY"}, {Seconds(40.0), "ASCEND"}};
  EXPECT_NEAR(OptionWinsOf(record, StraightTrack()).at(0).path_m, 15.0, 1e-9);
}

TEST(OptionWins, PassOverDecisionsWithoutBidsAndSessionsWithoutTrack) {
  SessionRecord record("discovery");
  record.decisions = {DecisionFor(10.0, "plan"), {.time = Seconds(20.0)}};
  const auto wins = OptionWinsOf(record, PoseTrack());
  ASSERT_EQ(wins.size(), 1U);
  EXPECT_EQ(wins[0].decisions, 1);
  EXPECT_EQ(wins[0].path_m, 0.0);
}

}  // namespace
}  // namespace limpet
