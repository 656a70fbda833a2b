// SPDX-License-Identifier: MIT
#include "limpet/replay_output/replay_summary.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string SummaryOf(const ReplayResult& result, const FormerSession& former = {},
                      const SensorStream& stream = {}) {
  return ReplaySummary(stream, result, former, 3.0);
}

ReplayResult Fixed() {
  ReplayResult result;
  result.has_fix = true;
  return result;
}

TEST(ReplaySummary, OfASoundReplayIsWhatThereIsAndWhatWasRefused) {
  EXPECT_EQ(SummaryOf(Fixed()),
            "0 poses, 0 landmarks; \n"
            "refused: 0 rows, 0 velocities, 0 depths, 0 fixes, 0 late frames\n");
}

TEST(ReplaySummary, SaysThatNoFixPlacesIt) {
  EXPECT_THAT(SummaryOf({}), HasSubstr("no GPS fix was used"));
}

TEST(ReplaySummary, TellsTheDatum) {
  SensorStream stream;
  stream.datum.emplace();
  stream.datum->latitude_deg = 43.5;
  EXPECT_THAT(SummaryOf(Fixed(), {}, stream),
              HasSubstr("north and east count from the first fix, 43.5000000, 0.0000000\n"));
}

TEST(ReplaySummary, TellsWhereThePlaceWasInDoubt) {
  ReplayResult result = Fixed();
  for (const double t : {0.0, 1.0, 2.0, 4.0}) {
    result.online.push_back({.t = t, .X_WB = {}});
    result.online_covariance_W.emplace_back((t > 1.0 ? 25.0 : 1.0) * Eigen::Matrix3d::Identity());
  }
  EXPECT_THAT(SummaryOf(result), HasSubstr("known to no better than 3 m (1-sigma) for 3 s, at "
                                           "worst to 5 m at 2 s\n"));
}

TEST(ReplaySummary, SaysADepthSensorThatWasNotZeroed) {
  ReplayResult result = Fixed();
  result.surface_reading = 10.3;
  EXPECT_THAT(SummaryOf(result), HasSubstr("the depth sensor read 10.3 m where fixes came"));
}

TEST(ReplaySummary, SaysWhichSensorsCannotBothBeRight) {
  ReplayResult result = Fixed();
  result.disagreements = {{.what = SensorAgreement::kTurn, .text = "the compass turns -1 times"}};
  EXPECT_THAT(SummaryOf(result), HasSubstr("the compass turns -1 times\n"));
}

TEST(ReplaySummary, SaysWhatBoxesShowedWithoutAPlace) {
  ReplayResult result = Fixed();
  result.unplaced = {{.color = "yellow", .boxes = 14, .p_W = {4.2, -1.6, 5.0}}};
  EXPECT_THAT(SummaryOf(result), HasSubstr("14 boxes (yellow) showed something near north 4, east "
                                           "-2, and agreed in no place\n"));
}

TEST(ReplaySummary, CountsTheObjectsKnownAgain) {
  ReplayResult result = Fixed();
  result.landmarks.resize(3);
  result.landmarks[1].former.id = 7;
  FormerSession former;
  EXPECT_THAT(SummaryOf(result, former), Not(HasSubstr("former session")));
  former.objects = {{.id = 7, .object = {}}, {.id = 8, .object = {}}};
  EXPECT_THAT(SummaryOf(result, former),
              HasSubstr("former session: 1 of 2 objects recognised; its frame lies 0.00 m north"));
}

TEST(ReplaySummary, SaysAlsoWhatNoSourceHeard) {
  ReplayResult result = Fixed();
  result.sources.sources.push_back({.name = "usbl", .variable = "USBL_FIX", .counts = {}});
  result.sources.unheard["ODD\x1b"] = 12;
  result.sources.after_end = 2;
  const std::string text = SummaryOf(result);
  EXPECT_THAT(text, HasSubstr("usbl: no row of USBL_FIX\n"));
  EXPECT_THAT(text, HasSubstr("12 rows of ODD"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b"))) << "nothing that a terminal obeys";
  EXPECT_THAT(text, HasSubstr("2 rows of further sensors lie after the stream's end\n"));
}

}  // namespace
}  // namespace limpet
