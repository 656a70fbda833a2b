// SPDX-License-Identifier: MIT
#include "estimation/navigation/track_watch.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// A pose a second along north.
std::vector<SmoothedPose> Track(int poses) {
  std::vector<SmoothedPose> track;
  for (int i = 0; i < poses; ++i)
    track.push_back({.t = 100.0 + i, .X_WB = {{0.5 * i, 0.0, 2.0}, 0.0, 0.0, 3.1}});
  return track;
}

std::vector<SmoothedPose> Moved(std::vector<SmoothedPose> track, double east_per_pose) {
  for (std::size_t i = 0; i < track.size(); ++i)
    track[i].X_WB.p_WB.y() += east_per_pose * static_cast<double>(i);
  return track;
}

TEST(TrackWatch, KeepsQuietWhileTheTrackStaysWhereItWasTold) {
  TrackWatch watch;
  watch.Note(Track(20));
  EXPECT_EQ(watch.noted(), 20);
  EXPECT_FALSE(watch.Compare(Track(20)));
  EXPECT_FALSE(watch.Compare(Moved(Track(20), 0.9 * TrackWatch::kNoticed / 19.0)));
}

TEST(TrackWatch, TellsTheShiftEveryFewSecondsAndAtTheEnd) {
  TrackWatch watch;
  watch.Note(Track(13));
  const auto shift = watch.Compare(Moved(Track(13), 0.02));
  ASSERT_TRUE(shift);
  std::vector<double> times;
  for (const auto& [t, north, east, down, yaw] : shift->steps) {
    times.push_back(t);
    EXPECT_NEAR(east, 0.02 * (t - 100.0), 1e-4);
    EXPECT_EQ(north, 0.0);
    EXPECT_EQ(down, 0.0);
    EXPECT_EQ(yaw, 0.0);
  }
  EXPECT_EQ(times, (std::vector{100.0, 105.0, 110.0, 112.0}));
}

TEST(TrackWatch, TellsTheSameShiftOnce) {
  TrackWatch watch;
  watch.Note(Track(13));
  EXPECT_TRUE(watch.Compare(Moved(Track(13), 0.02)));
  EXPECT_FALSE(watch.Compare(Moved(Track(13), 0.02)));
}

TEST(TrackWatch, PosesThatNobodyWasToldOfMayLieAnywhere) {
  TrackWatch watch;
  watch.Note(Track(5));
  std::vector<SmoothedPose> longer = Track(9);
  longer.back().X_WB.p_WB.y() = 7.0;
  EXPECT_FALSE(watch.Compare(longer));
}

TEST(TrackWatch, ATurnAcrossSouthIsASmallOne) {
  TrackWatch watch;
  watch.Note(Track(5));
  std::vector<SmoothedPose> turned = Moved(Track(5), 0.1);
  for (SmoothedPose& pose : turned)
    pose.X_WB.yaw = -3.1;
  const auto shift = watch.Compare(turned);
  ASSERT_TRUE(shift);
  EXPECT_NEAR(shift->steps.back()[4], 2.0 * (std::numbers::pi - 3.1), 1e-4);
}

}  // namespace
}  // namespace limpet
