// SPDX-License-Identifier: MIT
#include "limpet/vehicle/thruster_watchdog.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const ThrusterVector kAhead = ThrusterVector::Constant(0.5);

TEST(ThrusterWatchdog, RestsUntilACommandIsHeard) {
  const ThrusterWatchdog watchdog;
  EXPECT_TRUE(watchdog.At(Seconds(10.0)).isZero());
  EXPECT_FALSE(watchdog.IsStale(Seconds(10.0)));
}

TEST(ThrusterWatchdog, ObeysACommandForOneSecond) {
  ThrusterWatchdog watchdog;
  EXPECT_TRUE(watchdog.Hear(kAhead, Seconds(100.0)));
  EXPECT_EQ(watchdog.At(Seconds(101.0)), kAhead);
  EXPECT_TRUE(watchdog.At(Seconds(101.001)).isZero());
  EXPECT_TRUE(watchdog.IsStale(Seconds(101.001)));
}

TEST(ThrusterWatchdog, RefusesAndCountsWhatNoPilotMeans) {
  ThrusterWatchdog watchdog;
  watchdog.Hear(kAhead, Seconds(100.0));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1.01, -2.0}) {
    ThrusterVector command = kAhead;
    command(3) = bad;
    EXPECT_FALSE(watchdog.Hear(command, Seconds(100.9))) << bad;
  }
  EXPECT_EQ(watchdog.refused(), 4);
  EXPECT_TRUE(watchdog.At(Seconds(101.5)).isZero()) << "a refused command keeps nothing alive";
}

TEST(ThrusterWatchdog, AClockThatIsSetBackMakesNoCommandYoung) {
  ThrusterWatchdog watchdog;
  watchdog.Hear(kAhead, Seconds(100.0));
  watchdog.KeepUp(Seconds(40.0));
  EXPECT_EQ(watchdog.At(Seconds(41.0)), kAhead);
  EXPECT_TRUE(watchdog.At(Seconds(41.001)).isZero());
}

}  // namespace
}  // namespace limpet
