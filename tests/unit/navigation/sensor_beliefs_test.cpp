// SPDX-License-Identifier: MIT
#include "estimation/navigation/sensor_beliefs.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// The sheets' defaults are those of the vehicle that every figure of the README was measured with.
TEST(SensorBeliefs, OfTheUsualVehicleAreThoseThatTheEstimatorsWereTunedWith) {
  NavigatorParams params;
  BelieveSheets(SensorSheets{}, params);
  BelieveHull(VehicleParams{}, params);
  const NavigatorParams usual;
  EXPECT_EQ(params.odometry.dvl_B, usual.odometry.dvl_B);
  EXPECT_EQ(params.odometry.velocity_noise, usual.odometry.velocity_noise);
  EXPECT_EQ(params.odometry.velocity_period, usual.odometry.velocity_period);
  EXPECT_EQ(params.odometry.scale_sigma, usual.odometry.scale_sigma);
  EXPECT_EQ(params.odometry.misalign_sigma, usual.odometry.misalign_sigma);
  EXPECT_EQ(params.odometry.yaw_walk, usual.odometry.yaw_walk);
  EXPECT_EQ(params.odometry.yaw_bias, usual.odometry.yaw_bias);
  EXPECT_EQ(params.tilt_sigma, usual.tilt_sigma);
  EXPECT_EQ(params.depth_sigma, usual.depth_sigma);
  EXPECT_EQ(params.gps_correlation, usual.gps_correlation);
  EXPECT_EQ(params.depth_bias_sigma, usual.depth_bias_sigma);
  EXPECT_EQ(params.depth_bias_drift, usual.depth_bias_drift);
  EXPECT_EQ(params.surface_depth, usual.surface_depth);
  EXPECT_EQ(params.surface_depth_sigma, usual.surface_depth_sigma);

  const AttitudeParams attitude = BelievedAttitude(SensorSheets{});
  const AttitudeParams usual_attitude;
  EXPECT_EQ(attitude.gyro_noise, usual_attitude.gyro_noise);
  EXPECT_EQ(attitude.gyro_bias_sigma, usual_attitude.gyro_bias_sigma);
  EXPECT_EQ(attitude.tilt_floor, usual_attitude.tilt_floor);
  EXPECT_EQ(attitude.yaw_random_walk, usual_attitude.yaw_random_walk);
  EXPECT_EQ(attitude.yaw_bias_sigma, usual_attitude.yaw_bias_sigma);
  EXPECT_EQ(attitude.heading_sigma, Radians::FromTextUnit(0.75));
}

TEST(SensorBeliefs, AreNeverBetterThanTheSheet) {
  const SensorSheets sheets;
  NavigatorParams params;
  BelieveSheets(sheets, params);
  EXPECT_GE(params.odometry.velocity_noise, sheets.dvl.noise_mps);
  EXPECT_GE(params.odometry.scale_sigma, sheets.dvl.scale_sigma);
  EXPECT_GE(params.odometry.misalign_sigma, sheets.dvl.misalignment_sigma.value());
  EXPECT_GE(params.odometry.yaw_bias, RadiansFromDegrees(sheets.fog.bias_deg_per_h) / 3600.0);
  EXPECT_GE(params.depth_sigma.value(), sheets.depth.bias_m);
}

TEST(SensorBeliefs, WithoutAFibreOpticGyroTheImusYawRateIsBelievedLess) {
  SensorSheets sheets;
  sheets.fog.is_present = false;
  NavigatorParams with, without;
  BelieveSheets(SensorSheets{}, with);
  BelieveSheets(sheets, without);
  EXPECT_GT(without.odometry.yaw_walk, 10.0 * with.odometry.yaw_walk);
  EXPECT_GT(without.odometry.yaw_bias, sheets.imu.gyro_bias_radps);
  EXPECT_EQ(BelievedAttitude(sheets).yaw_bias_sigma.value(), without.odometry.yaw_bias);
}

TEST(SensorBeliefs, ASlowerNoisierDvlIsBelievedSlowerAndNoisier) {
  SensorSheets sheets;
  sheets.dvl.rate = Hertz(2.0);
  sheets.dvl.noise_mps = 0.05;
  NavigatorParams params;
  BelieveSheets(sheets, params);
  EXPECT_EQ(params.odometry.velocity_period, Seconds(0.5));
  EXPECT_EQ(params.odometry.velocity_noise, 0.06);
}

}  // namespace
}  // namespace limpet
