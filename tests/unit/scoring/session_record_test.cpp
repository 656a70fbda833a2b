// SPDX-License-Identifier: MIT
#include "limpet/scoring/session_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/topics/simulation.hpp"
#include "limpet/topics/survey_phase.hpp"
#include "tests/support/synthetic_session.hpp"

namespace limpet {
namespace {

template <class T>
Message MessageOf(const Topic<T>& topic, double time, const T& value) {
  return {topic.name, TopicCodec<T>::Encode(value), Seconds(kEpoch + time), "pTest", "", "alpha",
          -1};
}

TEST(SessionRecord, KeepsTheTruthAtNoMoreThan25Hz) {
  SessionRecord record("discovery");
  for (int i = 0; i <= 50; ++i)
    record.Collect(MessageOf(topics::kSimTruth, 0.02 * i, SimTruth{}));
  EXPECT_EQ(record.truth.size(), 26U);
}

TEST(SessionRecord, PassesOverWhatItDoesNotUnderstand) {
  SessionRecord record("discovery");
  record.Collect({"NAV_STATE", std::string("nonsense"), Seconds(kEpoch), "pTest", "", "", -1});
  record.Collect({"ELSE", 3.0, Seconds(kEpoch), "pTest", "", "", -1});
  EXPECT_TRUE(record.nav.empty());
}

TEST(SessionRecord, KeepsEveryWarningWithItsTimes) {
  SessionRecord record("discovery");
  const auto say = [&record](double time, const std::string& text) {
    record.Collect({"PNAV_WARNINGS", text, Seconds(kEpoch + time), "pNav", "", "", -1});
  };
  say(1.0, "DVL_STALE (alarm): no bottom lock for 1 s");
  say(2.0, "DVL_STALE (alarm): no bottom lock for 2 s; GPS_LOST: no fix");
  say(5.0, "GPS_LOST: no fix");
  ASSERT_EQ(record.warnings.size(), 2U);
  EXPECT_EQ(record.warnings[0].app, "pNav");
  EXPECT_EQ(record.warnings[0].id, "DVL_STALE");
  EXPECT_EQ(record.warnings[0].severity, Severity::kAlarm);
  EXPECT_EQ(record.warnings[0].text, "no bottom lock for 2 s") << "its latest";
  EXPECT_EQ(record.warnings[0].from, Seconds(kEpoch + 1.0));
  EXPECT_EQ(record.warnings[0].to, Seconds(kEpoch + 5.0));
  EXPECT_EQ(record.warnings[1].text, "no fix");
  EXPECT_FALSE(record.warnings[1].to.has_value());
  EXPECT_TRUE(SessionRecord::Listens("PNAV_WARNINGS"));
}

TEST(SessionRecord, TakesAPathAndItsBidsForOneDecisionInEitherOrder) {
  const HelmPath path{7, 0.0, 0.0, 0.0, {{0.0, 5.0}}, "cover"};
  const HelmBids bids{.path_id = 7, .cause = "arrival", .considered = 10, .options = {}};
  for (const bool is_path_first : {true, false}) {
    SessionRecord record("discovery");
    if (is_path_first) record.Collect(MessageOf(topics::kHelmPath, 1.0, path));
    record.Collect(MessageOf(topics::kHelmBids, 1.0, bids));
    if (!is_path_first) record.Collect(MessageOf(topics::kHelmPath, 1.0, path));
    ASSERT_EQ(record.decisions.size(), 1U);
    EXPECT_TRUE(record.decisions[0].has_way);
    EXPECT_TRUE(record.decisions[0].offer.has_value());
  }
}

TEST(SessionRecord, KeepsOfADecisionWhatAReportTells) {
  HelmBids bids{.path_id = 7, .cause = "arrival", .considered = 10, .options = {}};
  for (const double end : {1.0, 2.0, 3.0, 4.0}) {
    bids.options.push_back(
        {.source = end == 1.0 ? "beam" : "plan", .end = {end, -end}, .bids = {}});
  }
  bids.options[0].bids = {{.behavior = "cover", .bid = {.value = 4.0, .why = {{"useful", 4.0}}}}};
  bids.options[0].total = 4.0, bids.options[0].rate = 4.0;
  const DecisionRecord::Offer offer(bids);
  EXPECT_EQ(offer.chosen_source, "beam");
  EXPECT_EQ(offer.purpose, BidPurpose::kCover);
  ASSERT_EQ(offer.ends.size(), DecisionRecord::Offer::kBest);
  EXPECT_EQ(offer.ends[2], (std::array{3.0, -3.0}));
  EXPECT_TRUE(DecisionRecord::Offer({}).chosen_source.empty());
}

TEST(SessionRecord, NotesAPhaseOnceHoweverOftenItIsRepeated) {
  SessionRecord record("discovery");
  for (int i = 0; i < 3; ++i) {
    record.Collect(MessageOf(topics::kSurveyPhase, i, std::string("SURVEY ")));
  }
  ASSERT_EQ(record.phases.size(), 1U);
  EXPECT_EQ(record.PhaseStart(SurveyPhase::kSurvey)->value(), kEpoch);
}

TEST(SessionRecord, AddsUpTheGridFromItsChanges) {
  GridDelta delta;
  delta.frame = {0.0, 0.0, 0.25, 2, 2};
  delta.cells = {{1, {0.5F, 7.5F}}};
  SessionRecord record("discovery");
  record.Collect(MessageOf(topics::kMapDelta, 0.0, delta));
  delta.cells = {{2, {1.0F, 7.4F}}};
  record.Collect(MessageOf(topics::kMapDelta, 1.0, delta));
  EXPECT_EQ(record.grid.cells.At(0, 0).seen_height, -1.0F);
  EXPECT_EQ(record.grid.cells.At(0, 1).seen_height, 0.5F);
  EXPECT_EQ(record.grid.cells.At(1, 0).seen_height, 1.0F);
  EXPECT_EQ(record.grid.cells.At(1, 1).seen_height, -1.0F);
}

TEST(SessionRecord, IgnoresACellOutsideTheGrid) {
  GridDelta delta;
  delta.frame = {0.0, 0.0, 0.25, 2, 2};
  delta.cells = {{99, {0.5F, 7.5F}}};
  SessionRecord record("discovery");
  record.Collect(MessageOf(topics::kMapDelta, 0.0, delta));
  int seen = 0;
  record.grid.EachSeen([&seen](int, int, const SeenCell&) { ++seen; });
  EXPECT_EQ(seen, 0);
}

TEST(SessionRecord, RemembersOnlyChangesOfBelief) {
  SessionRecord record("change");
  OpiBeliefs beliefs;
  beliefs.opis = RightBeliefs(Table1Scenario(), "change", 0.0);
  for (int i = 0; i < 3; ++i)
    record.Collect(MessageOf(topics::kMapOpis, i, beliefs));
  EXPECT_EQ(record.beliefs.size(), beliefs.opis.size());
}

TEST(SessionRecord, KeepsTheEnergyAndWhatTheWayHomeTookAsItBegan) {
  SessionRecord record("discovery");
  EXPECT_FALSE(record.energy.has_value());
  const auto say = [&record](double time, const EnergyState& state) {
    record.Collect(MessageOf(topics::kEnergyState, time, state));
  };
  say(1.0, {.used_wh = 1.0, .left_wh = 90.0, .home_wh = 20.0, .reserve_wh = 50.0});
  record.Collect(MessageOf(topics::kSurveyPhase, 2.0, std::string("RETURN")));
  say(3.0, {.used_wh = 9.0, .left_wh = 82.0, .home_wh = 2.0, .reserve_wh = 50.0});
  EXPECT_EQ(record.energy->last.used_wh, 9.0);
  EXPECT_EQ(record.energy->home_wh, 20.0);
  EXPECT_EQ(record.energy->least_spare_wh, 20.0);
}

TEST(PoseTrack, TurnsTheShortWayThroughSouth) {
  PoseTrack track;
  track.Add(Seconds(0.0), {{0.0, 0.0, 0.0}, 0.0, 0.0, 3.0});
  track.Add(Seconds(1.0), {{1.0, 0.0, 0.0}, 0.0, 0.0, -3.0});
  EXPECT_NEAR(std::abs(track.At(0.5)->yaw), 3.14159265, 1e-6);
}

TEST(PoseTrack, KnowsNothingOutsideItsTime) {
  PoseTrack track;
  track.Add(Seconds(0.0), {});
  track.Add(Seconds(1.0), {});
  EXPECT_FALSE(track.At(1.5).has_value());
}

TEST(PoseTrack, MeasuresTheWayBetweenPoses) {
  PoseTrack track;
  track.Add(Seconds(0.0), {});
  track.Add(Seconds(1.0), {{3.0, 4.0, 0.0}, 0.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(track.PathAt(0.5), 2.5);
}

}  // namespace
}  // namespace limpet
