// SPDX-License-Identifier: MIT
#include "limpet/report/lanes_sentence.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

SessionScore SurveyBesideLanes() {
  SessionScore session;
  session.lanes = LanesScore{.passes = 9,
                             .path_m = 420.0,
                             .seabed = {{.level = 0.95, .path_m = 250.0, .time_s = 500.0}},
                             .band = {{.level = 0.95, .path_m = 360.0, .time_s = 720.0}}};
  session.coverage.seabed = {{.level = 0.95, .path_m = 200.0, .time_s = 400.0}};
  session.coverage.band = {{.level = 0.95, .path_m = 342.0, .time_s = 684.0}};
  session.survey_path_m = 399.0;
  return session;
}

TEST(LanesSentence, SaysByHowMuchTheSurveyBeatsThem) {
  EXPECT_EQ(LanesSentence(SurveyBesideLanes()),
            "lanes: 95 % of bottom 250 m, of band 360 m, home 420 m; this survey 0.80, 0.95, 0.95 "
            "of that");
}

TEST(LanesSentence, ClaimsNoShareOfWhatWasNeverReached) {
  SessionScore session = SurveyBesideLanes();
  session.coverage.band = {{.level = 0.95, .path_m = {}, .time_s = {}}};
  session.lanes->seabed = {{.level = 0.95, .path_m = {}, .time_s = {}}};
  EXPECT_EQ(LanesSentence(session),
            "lanes: 95 % of bottom never, of band 360 m, home 420 m; this survey -, -, 0.95 of "
            "that");
}

TEST(LanesSentence, IsNoneWithoutLanes) { EXPECT_EQ(LanesSentence(SessionScore{}), ""); }

TEST(WinsSentence, NamesFourGeneratorsAndSumsTheRest) {
  SessionScore session;
  session.wins = {{.source = "plan", .decisions = 20, .path_m = 300.0},
                  {.source = "tour", .decisions = 3, .path_m = 40.0},
                  {.source = "home", .decisions = 1, .path_m = 20.0},
                  {.source = "beam", .decisions = 2, .path_m = 9.0},
                  {.source = "gaps", .decisions = 2, .path_m = 4.0},
                  {.source = "transit", .decisions = 1, .path_m = 2.0}};
  EXPECT_EQ(WinsSentence(session),
            "options flown (decisions): plan 300 m (20), tour 40 m (3), home 20 m (1), beam 9 m "
            "(2), others 6 m (3)");
}

TEST(WinsSentence, IsNoneWhereNothingWasChosen) { EXPECT_EQ(WinsSentence(SessionScore{}), ""); }

}  // namespace
}  // namespace limpet
