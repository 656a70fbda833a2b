// SPDX-License-Identifier: MIT
#include "limpet/scoring/phase_times.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

SessionRecord Through(const std::vector<std::pair<double, std::string>>& phases) {
  SessionRecord record("discovery");
  for (const auto& [time, phase] : phases)
    record.phases.push_back({Seconds(time), phase});
  return record;
}

TEST(PhaseTimes, CountEachPhaseUntilTheNextOne) {
  const auto times = TimesOfPhases(
      Through({{0.0, "IDLE"}, {10.0, "ALIGN"}, {70.0, "DIVE"}, {95.0, "DONE"}}), Seconds(98.0));
  ASSERT_EQ(times.size(), 3U) << "the wait for DEPLOY does not count";
  EXPECT_EQ(times[0].phase, "ALIGN");
  EXPECT_DOUBLE_EQ(times[0].seconds, 60.0);
  EXPECT_DOUBLE_EQ(times[1].seconds, 25.0);
  EXPECT_EQ(times[2].phase, "DONE");
  EXPECT_DOUBLE_EQ(times[0].seconds + times[1].seconds + times[2].seconds, 88.0)
      << "they add up to the time since DEPLOY";
}

TEST(PhaseTimes, CountAPhaseThatIsEnteredAgainOnce) {
  const auto times =
      TimesOfPhases(Through({{0.0, "SURVEY"}, {10.0, "RETURN"}, {30.0, "SURVEY"}, {35.0, "DONE"}}),
                    Seconds(40.0));
  ASSERT_EQ(times.size(), 3U);
  EXPECT_DOUBLE_EQ(times[0].seconds, 15.0);
  EXPECT_DOUBLE_EQ(times[1].seconds, 20.0);
}

TEST(PhaseTimes, EndWithTheLastPoseOfASessionThatWasCutShort) {
  const auto times = TimesOfPhases(Through({{0.0, "SURVEY"}}), Seconds(12.5));
  ASSERT_EQ(times.size(), 1U);
  EXPECT_DOUBLE_EQ(times[0].seconds, 12.5);
}

TEST(PhaseTimes, CountWhatASurveySpentAtTheSurfaceForFixesApart) {
  SessionRecord record = Through({{0.0, "DIVE"}, {20.0, "SURVEY"}, {620.0, "RETURN"}});
  for (const auto& [time, text] : std::vector<std::pair<double, std::string>>{
           {1.0, "false"}, {100.0, "true"}, {132.0, "false"}, {300.0, "true"}, {332.0, "false"}}) {
    record.Collect(Message{.name = "SURFACE_FIX",
                           .value = text,
                           .time = Seconds(time),
                           .source = "pHelm",
                           .source_aux = "",
                           .community = ""});
  }
  EXPECT_TRUE(SessionRecord::Listens("SURFACE_FIX"));
  const auto times = TimesOfPhases(record, Seconds(700.0));
  ASSERT_EQ(times.size(), 4U);
  EXPECT_DOUBLE_EQ(times[1].seconds, 600.0 - 64.0);
  EXPECT_EQ(times[2].phase, "SURFACE_FIX");
  EXPECT_DOUBLE_EQ(times[2].seconds, 64.0);
}

TEST(PhaseTimes, EndAStayThatTheSurveyEndsIn) {
  SessionRecord record = Through({{0.0, "SURVEY"}, {50.0, "ASCEND"}});
  record.surface_fixes = {{Seconds(40.0), true}};
  const auto times = TimesOfPhases(record, Seconds(60.0));
  ASSERT_EQ(times.size(), 3U);
  EXPECT_DOUBLE_EQ(times[0].seconds, 40.0);
  EXPECT_DOUBLE_EQ(times[1].seconds, 10.0);
  EXPECT_DOUBLE_EQ(times[2].seconds, 10.0);
}

TEST(PhaseTimes, AreNoneWhereNoPhaseIsKnown) {
  EXPECT_TRUE(TimesOfPhases(Through({}), Seconds(10.0)).empty());
}

}  // namespace
}  // namespace limpet
