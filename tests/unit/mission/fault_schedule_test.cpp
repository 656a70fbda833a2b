// SPDX-License-Identifier: MIT
#include "limpet/mission/fault_schedule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/mission/scenario.hpp"

namespace limpet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<ScenarioFault> Faults(const std::string& lines) {
  return ParseScenario("faults:\n" + lines, "scenario.yaml").faults;
}

std::string Complaint(const std::string& lines) {
  try {
    static_cast<void>(Faults(lines));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(ScenarioFaults, AreReadWithTheirDefaults) {
  const auto faults = Faults(
      "  - {what: dvl_stuck, when: SURVEY_PHASE = SURVEY, at_s: 20, for_s: 60}\n"
      "  - {what: gps_jump, size: -30}\n"
      "  - {what: thrusters_weak}\n"
      "  - {what: app_hangs, app: pHelm}\n");
  ASSERT_EQ(faults.size(), 4U);
  EXPECT_EQ(faults[0].when, "SURVEY_PHASE = SURVEY");
  EXPECT_EQ(faults[0].at, Seconds(20.0));
  EXPECT_EQ(faults[0].lasts, Seconds(60.0));
  EXPECT_DOUBLE_EQ(faults[1].size, -30.0);
  EXPECT_FALSE(faults[1].lasts);
  EXPECT_DOUBLE_EQ(faults[2].size, 0.1);
  EXPECT_EQ(faults[3].app, "pHelm");
}

TEST(ScenarioFaults, AreRefusedWithLineKeyAndWhatIsAllowed) {
  EXPECT_THAT(Complaint("  - {what: dvl_stuk}\n"), HasSubstr("scenario.yaml:2: faults[0].what"));
  EXPECT_THAT(Complaint("  - {at_s: 3}\n"), HasSubstr("faults[0].what: is missing"));
  EXPECT_THAT(Complaint("  - {what: leak, size: 3}\n"), HasSubstr("`leak` has no size"));
  EXPECT_THAT(Complaint("  - {what: battery, size: 3}\n"),
              HasSubstr("`3` is not allowed; allowed for `battery`: 0 to 1, share of a full one"));
  EXPECT_THAT(Complaint("  - {what: leak, app: pNav}\n"), HasSubstr("`leak` is about no app"));
  EXPECT_THAT(Complaint("  - {what: app_hangs}\n"), HasSubstr("is missing: which app"));
  EXPECT_THAT(Complaint("  - {what: leak, when: 'DEPTH >'}\n"), HasSubstr("faults[0].when"));
  EXPECT_THAT(Complaint("  - {what: leak, at_s: -1}\n"), HasSubstr("faults[0].at_s"));
  EXPECT_THAT(Complaint("  - {what: leak, whenn: x}\n"), HasSubstr("did you mean `when`"));
  EXPECT_THAT(Complaint("  - {what: leak, when: [a]}\n"), HasSubstr("is no word"));
  EXPECT_THAT(Complaint("  leak\n"), HasSubstr("allowed: a list"));
}

TEST(FaultScheduleTest, CountsFromTheStartOfTheSession) {
  FaultSchedule schedule(Faults("  - {what: leak, at_s: 10, for_s: 5}\n"));
  schedule.Update(Seconds(100.0));
  schedule.Update(Seconds(109.9));
  EXPECT_EQ(schedule.Active("leak"), nullptr);
  EXPECT_TRUE(schedule.Has("leak"));
  schedule.Update(Seconds(110.0));
  ASSERT_NE(schedule.Active("leak"), nullptr);
  EXPECT_TRUE(schedule.IsActive(0));
  EXPECT_EQ(schedule.Active("battery"), nullptr);
  schedule.Update(Seconds(115.0));
  EXPECT_EQ(schedule.Active("leak"), nullptr);
}

TEST(FaultScheduleTest, WaitsForItsConditionAndThenGoesOnWithoutIt) {
  FaultSchedule schedule(Faults("  - {what: leak, when: SURVEY_PHASE = DIVE, at_s: 2}\n"));
  EXPECT_THAT(schedule.Variables(), ElementsAre("SURVEY_PHASE"));
  schedule.Update(Seconds(0.0));
  schedule.Hear("SURVEY_PHASE", std::string("DIVE"));
  schedule.Update(Seconds(50.0));
  schedule.Hear("SURVEY_PHASE", std::string("SURVEY"));
  schedule.Update(Seconds(52.0));
  EXPECT_NE(schedule.Active("leak"), nullptr);
}

TEST(FaultScheduleTest, WithoutFaultsHearsNothing) {
  FaultSchedule schedule;
  schedule.Update(Seconds(1.0));
  EXPECT_TRUE(schedule.Variables().empty());
  EXPECT_FALSE(schedule.Has("leak"));
}

}  // namespace
}  // namespace limpet
