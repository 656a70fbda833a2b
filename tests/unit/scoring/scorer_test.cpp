// SPDX-License-Identifier: MIT
#include "limpet/scoring/scorer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/topics/survey_phase.hpp"
#include "tests/support/synthetic_session.hpp"

namespace limpet {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

SessionScore ScoreOf(const SyntheticSession& session) {
  return ScoreSession(RecordOf(session), Table1Scenario(), Table1Settings());
}

SyntheticSession Discovery() {
  SyntheticSession session;
  session.opis = RightBeliefs(Table1Scenario(), "discovery", 0.3);
  return session;
}

/// The score of a whole discovery session, computed once.
const SessionScore& WholeDiscovery() {
  static const SessionScore score = ScoreOf(Discovery());
  return score;
}

/// Long enough for what the end of a session says, short enough to be quick.
SyntheticSession Brief(SyntheticSession session) {
  session.seconds_of_survey = 20.0;
  return session;
}

SyntheticSession Change() {
  SyntheticSession session;
  session.name = "change";
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  return session;
}

TEST(Scorer, CountsNearlyAllOfTheBottomUnderCloseLanes) {
  EXPECT_GT(WholeDiscovery().coverage.covered, 0.99);
}

TEST(Scorer, FindsTheBandHarderToCoverThanTheBottom) {
  SyntheticSession session = Discovery();
  session.lane_spacing_m = 5.0;
  const CoverageScore coverage = ScoreOf(session).coverage;
  EXPECT_LT(coverage.detected_band, coverage.covered - 0.05);
}

TEST(Scorer, SeesGapsBetweenLanesThatAreTooFarApart) {
  SyntheticSession session = Discovery();
  session.lane_spacing_m = 8.0;  // the image is 6.71 m wide
  // Four lanes, the first of them close to the western border.
  EXPECT_NEAR(ScoreOf(session).coverage.covered, (2.5 + 3.355 + 3 * 6.71) / 36.0, 0.05);
}

TEST(Scorer, LeavesALevelOpenThatWasNeverReached) {
  SyntheticSession session = Discovery();
  session.seconds_of_survey = 300.0;
  EXPECT_FALSE(ScoreOf(session).coverage.seabed.front().path_m.has_value());
}

TEST(Scorer, CountsTheWayToALevelFromTheStartOfTheSurvey) {
  const SessionScore score = WholeDiscovery();
  const CoverageLevel& level = score.coverage.seabed.front();
  EXPECT_NEAR(*level.path_m, 0.5 * *level.time_s, 0.5);  // at 0.5 m/s, the dive not counted
}

TEST(Scorer, CountsTheDiveInTheWayOfTheSession) {
  const SessionScore score = WholeDiscovery();
  EXPECT_NEAR(score.path_m - score.coverage.curve.path_m.back(), 3.5, 0.2);
}

TEST(Scorer, MeasuresAConstantOffsetOfTheEstimate) {
  EXPECT_NEAR(*ScoreOf(Brief(Discovery())).nav.position_rmse_m, 0.3, 1e-3);
}

TEST(Scorer, RemovesAConstantOffsetWhenAligning) {
  EXPECT_LT(*ScoreOf(Brief(Discovery())).nav.aligned_rmse_m, 1e-3);
}

TEST(Scorer, CallsAnEstimateConsistentWhoseErrorIsOneDeviationOnEachAxis) {
  SyntheticSession session = Brief(Discovery());
  session.nav_offset_m = 0.3 * std::sqrt(3.0);
  EXPECT_NEAR(*ScoreOf(session).nav.nees_mean, 3.0, 0.01);
}

TEST(Scorer, ComparesWithDeadReckoningAtTheEnd) {
  const SessionScore score = WholeDiscovery();
  EXPECT_NEAR(*score.nav.dead_reckoning_final_error_m, 0.01 * score.coverage.curve.path_m.back(),
              0.1);
}

TEST(Scorer, TakesTheErrorAtTheEndBeforeFixesAtTheSurfaceMendIt) {
  SessionRecord record = RecordOf(Brief(Discovery()));
  const Seconds after = record.PhaseStart(SurveyPhase::kAscend).value() + Seconds(60.0);
  for (PoseTrack* track : {&record.truth, &record.nav, &record.dead_reckoning}) {
    track->Add(after, Pose{});
  }
  record.nav_sd.push_back(record.nav_sd.back());
  const NavScore nav = ScoreSession(record, Table1Scenario(), Table1Settings()).nav;
  EXPECT_NEAR(*nav.final_error_m, 0.3, 1e-3);
  EXPECT_GT(*nav.dead_reckoning_final_error_m, 0.05);
}

TEST(Scorer, MeasuresHowFarFromTheStartPointTheSessionTrulyEnded) {
  const SessionRecord record = RecordOf(Brief(Discovery()));
  const std::size_t last = record.truth.size() - 1;
  EXPECT_NEAR(*ScoreOf(Brief(Discovery())).home_error_m,
              std::hypot(record.truth.north(last) + 12.5, record.truth.east(last) + 15.5), 1e-9);
}

TEST(Scorer, FindsEveryReportedObjectAtItsDistanceFromTheTruth) {
  const SessionScore score = ScoreOf(Brief(Discovery()));
  ASSERT_EQ(score.opis.found.size(), 4U);
  for (const OpiScore& opi : score.opis.found)
    EXPECT_NEAR(opi.error_m, 0.3, 1e-9);
}

TEST(Scorer, NamesTheObjectThatWasMissed) {
  SyntheticSession session = Brief(Discovery());
  session.opis.erase(session.opis.begin() + 1);
  EXPECT_THAT(ScoreOf(session).opis.missed, ElementsAre("OPI 2"));
}

TEST(Scorer, CountsAReportFarFromEveryObjectAsInvented) {
  SyntheticSession session = Brief(Discovery());
  session.opis[0].object.p_W[0] += 4.0;
  const OpiScores opis = ScoreOf(session).opis;
  EXPECT_EQ(opis.invented.size(), 1U);
  EXPECT_THAT(opis.missed, ElementsAre("OPI 1"));
}

TEST(Scorer, CountsTheSecondReportOfOneObjectAsInvented) {
  SyntheticSession session = Brief(Discovery());
  session.opis.push_back(session.opis[0]);
  session.opis.back().id = 17;
  EXPECT_EQ(ScoreOf(session).opis.invented.size(), 1U);
}

TEST(Scorer, TakesNoUncertainBeliefForAReport) {
  SyntheticSession session = Brief(Discovery());
  session.opis[3].decided = Status::kUncertain;
  EXPECT_THAT(ScoreOf(session).opis.missed, ElementsAre("OPI 4"));
}

/// Which object of the discovery it is, if any, may stay open: it is there all the same.
TEST(Scorer, FindsAMappedObjectThatIsSurelyThereThoughItsStatusIsOpen) {
  SyntheticSession session = Brief(Change());
  OpiBelief& open = session.opis[0];
  open.landmark = 7;
  open.decided = Status::kUncertain;
  open.posterior = {.confirmed = 0.62, .removed = 0.01, .appeared = 0.36, .nothing = 0.01};
  const OpiScores opis = ScoreOf(session).opis;
  EXPECT_THAT(opis.missed, IsEmpty());
  EXPECT_EQ(opis.found.size(), 3U);
  EXPECT_TRUE(opis.changes.at(0).is_open()) << "found, and its status is still open";
  open.posterior = {.confirmed = 0.52, .removed = 0.20, .appeared = 0.26, .nothing = 0.02};
  EXPECT_EQ(ScoreOf(session).opis.missed.size(), 1U) << "it may well be gone";
}

TEST(Scorer, ReportsWhatIsSurelyThereWithoutATruth) {
  SyntheticSession session = Brief(Change());
  session.opis[0].landmark = 7;
  session.opis[0].decided = Status::kUncertain;
  session.opis[0].posterior = {
      .confirmed = 0.62, .removed = 0.01, .appeared = 0.36, .nothing = 0.01};
  const SessionRecord record = RecordOf(session);
  EXPECT_EQ(ReportedOpis(record, true).reported.size(), 3U);
  EXPECT_EQ(ReportedOpis(record, false).reported.size(), 2U) << "a discovery decides that alone";
}

TEST(Scorer, PrefersTheSmoothersPlaceOverTheMaps) {
  SyntheticSession session = Brief(Discovery());
  session.opis[0].landmark = 5;
  SessionRecord record = RecordOf(session);
  Landmark landmark;
  landmark.id = 5;
  landmark.object.p_W = {4.0, 1.0, 5.5};
  record.landmarks = {landmark};
  const SessionScore score = ScoreSession(record, Table1Scenario(), Table1Settings());
  EXPECT_NEAR(score.opis.found[0].error_m, 0.0, 1e-9);
}

TEST(Scorer, FindsAllFiveStatusesOfTable1Right) {
  const SessionScore score = ScoreOf(Brief(Change()));
  ASSERT_EQ(score.opis.changes.size(), 5U);
  for (const ChangeScore& change : score.opis.changes)
    EXPECT_TRUE(change.is_right());
}

TEST(Scorer, MissesNothingWhenARemovedObjectIsGone) {
  EXPECT_THAT(ScoreOf(Brief(Change())).opis.missed, IsEmpty());
}

TEST(Scorer, ListsADecisionAboutNothing) {
  SyntheticSession session = Brief(Change());
  session.opis.push_back(session.opis[0]);
  session.opis.back().object.p_W = {-12.0, 14.0, 7.0};
  const OpiScores opis = ScoreOf(session).opis;
  ASSERT_EQ(opis.changes.size(), 6U);
  EXPECT_FALSE(opis.changes.back().truth.has_value());
}

TEST(Scorer, TellsTwoObjectsOfOnePlaceApartByTheirColour) {
  Scenario scenario = Table1Scenario();
  scenario.opis.resize(2);
  const Eigen::Vector3d place(4.0, 1.0, 5.5);
  scenario.opis[0].color = "yellow", scenario.opis[1].color = "orange";
  scenario.opis[0].places = {{"discovery", place}};
  scenario.opis[1].places = {{"change", place}};
  SyntheticSession session = Brief(Change());
  session.opis.resize(2);
  session.opis[0].object.color = "yellow", session.opis[1].object.color = "orange";
  session.opis[0].object.p_W = {4.1, 1.0, 5.5}, session.opis[1].object.p_W = {4.2, 1.0, 5.5};
  session.opis[0].decided = Status::kRemoved, session.opis[1].decided = Status::kNew;
  for (int turn = 0; turn < 2; ++turn) {
    const SessionScore score = ScoreSession(RecordOf(session), scenario, Table1Settings());
    EXPECT_EQ(score.opis.changes[0].decided, Status::kRemoved);
    EXPECT_EQ(score.opis.changes[1].decided, Status::kNew);
    std::swap(session.opis[0].object.p_W, session.opis[1].object.p_W);
  }
}

TEST(Scorer, ExpectsMovedOfAnObjectThatChangedItsPlace) {
  Scenario scenario = Table1Scenario();
  scenario.opis[0].places["change"] = Eigen::Vector3d(8.0, 1.0, 5.5);
  const SessionScore score = ScoreSession(RecordOf(Brief(Change())), scenario, Table1Settings());
  EXPECT_EQ(score.opis.changes[0].expected, Status::kMoved);
}

TEST(Scorer, ExpectsMovedFromHalfAMetreOn) {
  Scenario scenario = Table1Scenario();
  const auto expected = [&scenario](double off) {
    scenario.opis[0].places["discovery"] = Eigen::Vector3d(4.1, 1.0, 5.5);
    scenario.opis[0].places["change"] = Eigen::Vector3d(4.1 + off, 1.0, 5.5);
    return ScoreSession(RecordOf(Brief(Change())), scenario, Table1Settings())
        .opis.changes[0]
        .expected;
  };
  EXPECT_EQ(expected(0.5), Status::kMoved);
  EXPECT_EQ(expected(-0.5), Status::kMoved);
  EXPECT_EQ(expected(0.49), Status::kConfirmed);
}

TEST(Scorer, HasNoProbabilityOfWhatNoLookSaysAnythingAbout) {
  SyntheticSession session = Brief(Change());
  session.opis.clear();
  for (const ChangeScore& change : ScoreOf(session).opis.changes) {
    EXPECT_TRUE(change.is_open());
    EXPECT_FALSE(change.probability.has_value());
  }
}

TEST(Scorer, MeasuresTheWayUntilAllFormerObjectsWereSeen) {
  const SessionScore score = ScoreOf(Change());
  // The last former object in the order of the lanes is OPI 2 at 10 m east.
  ASSERT_TRUE(score.coverage.prior_opis_seen_path_m.has_value());
  EXPECT_GT(*score.coverage.prior_opis_seen_path_m, 200.0);
}

TEST(Scorer, CountsAFormerObjectThatTheDiveShowedAsSeenAtTheStart) {
  Scenario scenario = Table1Scenario();
  scenario.opis.resize(1);
  // 2 m ahead of the start point and 1.5 m above the bottom: in sight from above alone.
  scenario.opis[0].places["discovery"] = Eigen::Vector3d(-10.5, -15.5, 6.0);
  const SessionScore score = ScoreSession(RecordOf(Brief(Change())), scenario, Table1Settings());
  EXPECT_EQ(score.coverage.prior_opis_seen_path_m, 0.0);
}

TEST(Scorer, ComparesEachSessionWithTheOneBeforeIt) {
  Scenario scenario = Table1Scenario();
  for (ScenarioOpi& opi : scenario.opis)
    opi.places["third"] = opi.Place("discovery");  // all as it was before the change
  SyntheticSession session = Brief(Change());
  session.name = "third";
  session.former = "change";
  const SessionScore score = ScoreSession(RecordOf(session), scenario, Table1Settings());
  ASSERT_EQ(score.opis.changes.size(), 5U);
  EXPECT_EQ(score.opis.changes[0].expected, Status::kConfirmed);
  EXPECT_EQ(score.opis.changes[1].expected, Status::kNew);  // OPI 2 is back
  EXPECT_EQ(score.opis.changes[4].expected, Status::kRemoved);
}

TEST(Scorer, TakesTheRunsOrderWhereTheLogDoesNotNameTheFormerSession) {
  SyntheticSession session = Brief(Change());
  session.former = "";
  ReportSettings settings = Table1Settings();
  settings.sessions = {"discovery", "change"};
  EXPECT_EQ(ScoreSession(RecordOf(session), Table1Scenario(), settings).opis.changes.size(), 5U);
  settings.sessions = {"change"};
  EXPECT_THAT(ScoreSession(RecordOf(session), Table1Scenario(), settings).opis.changes, IsEmpty());
}

TEST(Scorer, JudgesNothingWithoutTruth) {
  SessionRecord record = RecordOf(Brief(Change()));
  record.truth = {};
  const SessionScore score = ScoreSession(record, Table1Scenario(), Table1Settings());
  EXPECT_FALSE(score.has_truth);
  EXPECT_THAT(score.opis.invented, IsEmpty());
  EXPECT_THAT(score.opis.missed, IsEmpty());
  EXPECT_EQ(score.opis.reported.size(), 3U);
  EXPECT_FALSE(score.nav.position_rmse_m || score.nav.nees_mean || score.home_error_m);
}

TEST(Scorer, KnowsNoNavigationErrorWhereNoEstimateWasRecorded) {
  SessionRecord record = RecordOf(Brief(Discovery()));
  record.nav = {};
  const NavScore nav = ScoreSession(record, Table1Scenario(), Table1Settings()).nav;
  EXPECT_FALSE(nav.position_rmse_m || nav.final_error_m || nav.nees_mean);
}

TEST(Scorer, ScoresAnEmptySessionWithoutFailing) {
  const SessionScore score =
      ScoreSession(SessionRecord("discovery"), Table1Scenario(), Table1Settings());
  EXPECT_EQ(score.ended, "aborted");
}

}  // namespace
}  // namespace limpet
