// SPDX-License-Identifier: MIT
#include "estimation/navigation/dvl_velocities.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

const Eigen::Vector3d kSlow(0.2, 0.0, 0.0), kFast(0.6, 0.1, 0.0);

TEST(DvlVelocities, AreInterpolatedBetweenTwoAndTheLastOneIsHeld) {
  DvlVelocities velocities(Seconds(0.2));
  EXPECT_TRUE(velocities.empty());
  EXPECT_EQ(velocities.At(1.0), Eigen::Vector3d::Zero().eval());
  velocities.Add(1.0, kSlow);
  velocities.BelieveNewest();
  velocities.Add(1.2, kFast);
  velocities.BelieveNewest();
  EXPECT_NEAR((velocities.At(1.05) - (0.75 * kSlow + 0.25 * kFast)).norm(), 0.0, 1e-12);
  EXPECT_EQ(velocities.At(5.0), kFast);
  EXPECT_FALSE(velocities.IsNews(1.2));
  EXPECT_TRUE(velocities.IsNews(1.3));
}

TEST(DvlVelocities, BeforeOneIsTrueNothingIsInterpolated) {
  DvlVelocities velocities(Seconds(0.2));
  velocities.Add(1.0, std::nullopt);
  velocities.Add(1.2, kFast);
  EXPECT_EQ(velocities.At(1.1), kFast);
  EXPECT_EQ(velocities.previous_time(), 1.2);
}

TEST(DvlVelocities, WhatWasNotMeasuredIsTheLastOneUntilSomethingBridgesIt) {
  DvlVelocities velocities(Seconds(0.2));
  velocities.Add(1.0, kSlow);
  velocities.BelieveNewest();
  velocities.Add(2.0, std::nullopt);
  EXPECT_EQ(velocities.At(2.0), kSlow);
  velocities.BridgeNewest(kFast);
  EXPECT_EQ(velocities.At(2.0), kFast);
  EXPECT_EQ(velocities.believed_time(), 1.0) << "a bridge is no measurement";
}

TEST(DvlVelocities, ADropoutBeginsAfterAPauseThatIsLongForThisDvl) {
  for (const double period : {0.1, 0.2, 1.0}) {
    DvlVelocities velocities{Seconds(period)};
    EXPECT_TRUE(velocities.DropoutAge(0.0)) << "nothing was measured yet";
    double t = 100.0;
    for (int i = 0; i < 20; ++i, t += period) {
      velocities.NotePeriod(t);
      velocities.Add(t, kSlow);
      velocities.BelieveNewest();
    }
    const double last = t - period, pause = period < 0.5 ? 0.5 : 2.4 * period;
    EXPECT_DOUBLE_EQ(velocities.LongestPause(), pause);
    EXPECT_FALSE(velocities.DropoutAge(last + 0.99 * pause));
    EXPECT_FALSE(velocities.WasSilentBefore(last + 0.99 * pause));
    ASSERT_TRUE(velocities.DropoutAge(last + 1.01 * pause));
    EXPECT_NEAR(*velocities.DropoutAge(last + 1.01 * pause), 1.01 * pause, 1e-9);
    EXPECT_TRUE(velocities.WasSilentBefore(last + 1.01 * pause));
  }
}

}  // namespace
}  // namespace limpet
