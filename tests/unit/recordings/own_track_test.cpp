// SPDX-License-Identifier: MIT
#include "limpet/recordings/own_track.hpp"

#include <algorithm>
#include <variant>

#include <gtest/gtest.h>

#include "limpet/recordings/moos_log.hpp"
#include "tests/support/moos_text.hpp"

namespace limpet {
namespace {

Recording OwnRecording(const MadeLog& log) {
  const std::string text = MoosText(log);
  AlogReader reader = AlogReader::OfText(text);
  return *ReadMoosLog(reader, "made.alog");
}

TEST(OwnTrack, IsAStreamOfALevelVehicleThatGoesAheadAndDown) {
  const auto stream = StreamOf(OwnRecording({}), Radians::FromTextUnit(2.0));
  ASSERT_TRUE(stream.has_value());
  EXPECT_EQ(stream->rows.size(), 2400U);
  const auto dvl = std::ranges::find_if(stream->rows, [](const StreamRow& row) {
    const auto* velocity = std::get_if<DvlRow>(&row);
    return velocity != nullptr && velocity->t > 10.0;
  });
  const Eigen::Vector3d& v = *std::get<DvlRow>(*dvl).v_WD_B;
  EXPECT_EQ(v.x(), 1.0);
  EXPECT_NEAR(v.z(), 0.01, 1e-6);
}

TEST(OwnTrack, NeedsAHeading) {
  EXPECT_FALSE(
      StreamOf(OwnRecording({.has_heading = false}), Radians::FromTextUnit(2.0)).has_value());
}

TEST(OwnTrack, LiesFromTheOwnPlacesByWhatGrowsFromWhereTheyBegin) {
  std::vector<SmoothedPose> track;
  std::vector<TimedPlace> own;
  for (int i = 0; i <= 10; ++i) {
    const double t = i;
    own.push_back({.t = t, .p_W = {100.0 + t, 50.0}});
    SmoothedPose pose;
    pose.t = t;
    pose.X_WB.p_WB = {t, 0.1 * t, 0.0};
    track.push_back(pose);
  }
  const TrackDifference found = CompareTracks(track, own);
  EXPECT_NEAR(found.at_end, 0.9, 1e-9);  // the last place has none behind it
  EXPECT_NEAR(found.greatest, 0.9, 1e-9);
  EXPECT_NEAR(found.path, 10.0, 1e-9);
}

TEST(OwnTrack, LiesNowhereWithoutPlaces) { EXPECT_EQ(CompareTracks({}, {}).greatest, 0.0); }

}  // namespace
}  // namespace limpet
