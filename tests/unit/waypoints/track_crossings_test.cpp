// SPDX-License-Identifier: MIT
#include "limpet/waypoints/track_crossings.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// So much of a circle of 20 m, in steps of half a metre.
void GoRound(TrackCrossings& track, double rounds) {
  constexpr double kRadius = 20.0, kStep = 0.5;
  const int steps = static_cast<int>(rounds * 2.0 * std::numbers::pi * kRadius / kStep);
  for (int i = 0; i < steps; ++i) {
    // Round after round a little farther out, as a spiral: it crosses itself nowhere.
    const double angle = i * kStep / kRadius, radius = kRadius + 0.1 * angle;
    track.Move({.x = radius * std::cos(angle), .y = radius * std::sin(angle)});
  }
}

TEST(TrackCrossings, CountsALoopOnceAndBeginsANewTrackThere) {
  TrackCrossings track;
  for (double x = -30.0; x < 30.0; x += 0.4) {
    track.Move({.x = x, .y = 0.0});
  }
  EXPECT_EQ(track.count(), 0);
  for (double angle = 0.0; angle < 1.5 * std::numbers::pi; angle += 0.02) {
    track.Move({.x = 30.0 + 20.0 * std::sin(angle), .y = 20.0 - 20.0 * std::cos(angle)});
  }
  for (double y = 20.0; y > -30.0; y -= 0.4) {
    track.Move({.x = 10.0, .y = y});
  }
  EXPECT_EQ(track.count(), 1);
  track.Reset();
  EXPECT_EQ(track.count(), 0);
}

TEST(TrackCrossings, AreNoneOnASpiralNorForAVehicleThatStands) {
  TrackCrossings track;
  GoRound(track, 3.0);
  EXPECT_EQ(track.count(), 0);
  for (int i = 0; i < 100; ++i) {
    track.Move({.x = 500.0 + 0.3 * (i % 2), .y = 0.0});
  }
  EXPECT_EQ(track.count(), 0);
}

}  // namespace
}  // namespace limpet
