// SPDX-License-Identifier: MIT
// Slips in `limpet tune --objective` that are found before anything is flown.
#include "apps/limpet/verbs/tune_keys.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;

std::string ComplaintAboutKeys(const std::string& text) {
  return ImpossibleKey(*ReportExpression::Parse(text), {"discovery", "change"}).value_or("");
}

TEST(TunedObjective, MayNameWhatAReportHas) {
  for (const char* text :
       {"sessions.discovery.path_m + sessions.change.path_m", "seed == 1",
        "settings.object_height_max_m", "sessions.discovery.missed.count == 0",
        "sessions.discovery.coverage.95.path_m", "sessions.discovery.opis.0.error_m",
        "sessions.discovery.water.visibility_m", "sessions.discovery.lanes.path_m",
        "sessions.discovery.phase_s.SURVEY", "sessions.discovery.options_won.beam.path_m",
        "sessions.change.changes.count", "sessions.change.prior_opis_seen_path_m",
        "sessions.discovery.energy.used_wh", "sessions.discovery.estimated_path_m",
        "sessions.discovery.nav.nees_mean", "sessions.discovery.unseen_share.band", "1 + 2"}) {
    EXPECT_EQ(ComplaintAboutKeys(text), "") << text;
  }
}

TEST(TunedObjective, IsRefusedForAKeyThatNoReportHasAndToldTheNearest) {
  EXPECT_THAT(ComplaintAboutKeys("2 * sessions.discovery.pth_m"),
              HasSubstr("at 5: report.json has no `sessions.discovery.pth_m`; did you mean "
                        "`sessions.discovery.path_m`?"));
  EXPECT_THAT(ComplaintAboutKeys("pth_m"), HasSubstr("`pth_m`; did you mean `sessions."));
  EXPECT_THAT(ComplaintAboutKeys("sessions.harbour.path_m"), HasSubstr("no `sessions.harbour"));
  EXPECT_THAT(ComplaintAboutKeys("sessions.discovery.mised.count == 0"),
              HasSubstr("did you mean `sessions.discovery.missed.count`?"));
}

TEST(TunedObjective, MayNotBeWhatDependsOnTheMachine) {
  EXPECT_THAT(ComplaintAboutKeys("sessions.discovery.wall_s"), HasSubstr("report.json has no"));
}

}  // namespace
}  // namespace limpet
