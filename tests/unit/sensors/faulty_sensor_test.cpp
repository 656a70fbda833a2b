// SPDX-License-Identifier: MIT
#include "limpet/sensors/faulty_sensor.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// A schedule with one fault, so from 10 to 20 s.
FaultSchedule With(const char* what, double size = 0.0) {
  ScenarioFault fault;
  fault.what = what;
  fault.at = Seconds(10.0);
  fault.lasts = Seconds(10.0);
  fault.size = size;
  FaultSchedule schedule({fault});
  schedule.Update(Seconds(0.0));
  return schedule;
}

DvlSample Ping(double u) {
  DvlSample sample;
  sample.has_lock = true;
  sample.u = u;
  sample.v = 0.1;
  sample.w = 0.02;
  sample.altitude = u + 4.0;
  return sample;
}

TEST(FaultySensorTest, SaysWhatItMeasuresWhileAllIsSound) {
  FaultSchedule schedule = With("dvl_stuck");
  FaultyDvl dvl(Random(1));
  EXPECT_EQ(dvl.Pass(Ping(0.5), schedule)->u, 0.5);
  EXPECT_EQ(dvl.Pass(Ping(0.6), schedule)->altitude, 4.6);
}

TEST(FaultySensorTest, RepeatsItselfWhileItSticksAndGoesOnAfterwards) {
  FaultSchedule schedule = With("dvl_stuck");
  FaultyDvl dvl(Random(1));
  static_cast<void>(dvl.Pass(Ping(0.5), schedule));
  schedule.Update(Seconds(12.0));
  EXPECT_EQ(dvl.Pass(Ping(0.6), schedule)->u, 0.5);
  EXPECT_EQ(dvl.Pass(Ping(0.7), schedule)->altitude, 4.5);
  schedule.Update(Seconds(21.0));
  EXPECT_EQ(dvl.Pass(Ping(0.8), schedule)->u, 0.8);
}

TEST(FaultySensorTest, SticksAtItsFirstValueIfItHadNone) {
  FaultSchedule schedule = With("depth_stuck");
  schedule.Update(Seconds(12.0));
  FaultySensor<double> depth("depth");
  EXPECT_EQ(depth.Pass(3.0, schedule), 3.0);
  EXPECT_EQ(depth.Pass(4.0, schedule), 3.0);
}

TEST(FaultySensorTest, IsSilent) {
  FaultSchedule schedule = With("depth_silent");
  schedule.Update(Seconds(12.0));
  FaultySensor<double> depth("depth");
  EXPECT_FALSE(depth.Pass(3.0, schedule));
}

TEST(FaultySensorTest, ADvlMayFlipBeOffOrLoseItsLock) {
  FaultyDvl dvl(Random(1));
  FaultSchedule flipped = With("dvl_flipped");
  flipped.Update(Seconds(12.0));
  const DvlSample sample = *dvl.Pass(Ping(0.5), flipped);
  EXPECT_EQ(sample.u, -0.5);
  EXPECT_EQ(sample.v, -0.1);
  EXPECT_EQ(sample.w, 0.02);
  FaultSchedule biased = With("dvl_biased", 0.3);
  biased.Update(Seconds(12.0));
  EXPECT_DOUBLE_EQ(*dvl.Pass(Ping(0.5), biased)->u, 0.8);
  FaultSchedule blind = With("dvl_no_lock");
  blind.Update(Seconds(12.0));
  EXPECT_FALSE(dvl.Pass(Ping(0.5), blind)->u);
  EXPECT_FALSE(dvl.Pass(Ping(0.5), blind)->has_lock);
}

TEST(FaultySensorTest, AnAltitudeMayStickOrBeOffByItself) {
  FaultyDvl dvl(Random(1));
  FaultSchedule stuck = With("altitude_stuck");
  static_cast<void>(dvl.Pass(Ping(0.5), stuck));
  stuck.Update(Seconds(12.0));
  const DvlSample sample = *dvl.Pass(Ping(0.7), stuck);
  EXPECT_EQ(sample.u, 0.7);
  EXPECT_EQ(sample.altitude, 4.5);
  FaultSchedule biased = With("altitude_biased", 3.0);
  biased.Update(Seconds(12.0));
  EXPECT_DOUBLE_EQ(*dvl.Pass(Ping(0.5), biased)->altitude, 7.5);
  DvlSample blind;
  EXPECT_FALSE(dvl.Pass(blind, biased)->altitude);
}

TEST(FaultySensorTest, SomeOfTheImusAndTheDvlsSamplesMayBeOutliers) {
  FaultyImu imu(Random(1));
  FaultyDvl dvl(Random(2));
  FaultSchedule glitches = With("imu_outliers", 0.25), jumps = With("dvl_outliers", 0.25);
  const ImuSample sound{.fz = -9.81, .heading = 1.0};
  int odd_inertial = 0, odd_velocities = 0;
  for (int i = 0; i < 2000; ++i) {
    if (i == 1000) glitches.Update(Seconds(12.0)), jumps.Update(Seconds(12.0));
    odd_inertial += imu.Pass(sound, glitches)->fz != sound.fz ? 1 : 0;
    odd_velocities += dvl.Pass(Ping(0.5), jumps)->u != 0.5 ? 1 : 0;
    if (i == 999) {
      EXPECT_EQ(odd_inertial + odd_velocities, 0);
    }
  }
  EXPECT_NEAR(odd_inertial, 250, 50);
  EXPECT_NEAR(odd_velocities, 250, 50);
}

TEST(FaultySensorTest, DepthAndGpsMayBeOff) {
  FaultSchedule depth = With("depth_biased", 2.0);
  FaultSchedule gps = With("gps_jump", 50.0);
  EXPECT_EQ(WithDepthFault(3.0, depth), 3.0);
  EXPECT_EQ(WithGpsFault(GpsFix{.north = 1.0, .east = 0.0, .sd = 0.0}, gps).north, 1.0);
  depth.Update(Seconds(12.0));
  gps.Update(Seconds(12.0));
  EXPECT_EQ(WithDepthFault(3.0, depth), 5.0);
  EXPECT_EQ(WithGpsFault(GpsFix{.north = 1.0, .east = 0.0, .sd = 0.0}, gps).north, 51.0);
}

}  // namespace
}  // namespace limpet
