// SPDX-License-Identifier: MIT
// Errors that are functions of heading, rate and time: what they are, and nothing unless asked for.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/simulation/compass_error.hpp"
#include "limpet/simulation/depth_error.hpp"
#include "limpet/simulation/gyro_error.hpp"
#include "limpet/simulation/mounting_error.hpp"
#include "limpet/simulation/object_motion.hpp"

namespace limpet {
namespace {

TEST(CompassErrorOfNothing, IsNone) {
  CompassError error({}, Random(1));
  for (double yaw = -3.0; yaw < 3.0; yaw += 0.1)
    EXPECT_EQ(error.Of(yaw), 0.0);
}

TEST(CompassErrorOfIron, TurnsOnceWithTheVehicle) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const CompassErrorParams params{.constant = Radians(random.Normal(0.1)),
                                    .sine = Radians(random.Normal(0.1)),
                                    .cosine = Radians(random.Normal(0.1)),
                                    .noise = Radians(0.0)};
    CompassError error(params, Random(3));
    const double yaw = random.Uniform(-3.1, 3.1);
    // Opposite headings have the constant in common, and nothing else.
    EXPECT_NEAR(error.Of(yaw) + error.Of(yaw + std::numbers::pi), 2.0 * params.constant.value(),
                1e-12);
    EXPECT_NEAR(error.Of(yaw + 2.0 * std::numbers::pi), error.Of(yaw), 1e-12);
    EXPECT_NEAR(error.Of(0.0), params.constant.value() + params.cosine.value(), 1e-12);
    EXPECT_NEAR(error.Of(0.5 * std::numbers::pi), params.constant.value() + params.sine.value(),
                1e-12);
  }
}

TEST(CompassErrorOfNoise, HasItsSigma) {
  CompassError error({.constant = Radians(0.0),
                      .sine = Radians(0.0),
                      .cosine = Radians(0.0),
                      .noise = Radians(0.05)},
                     Random(4));
  double squares = 0.0;
  for (int i = 0; i < 10000; ++i)
    squares += std::pow(error.Of(0.3), 2);
  EXPECT_NEAR(std::sqrt(squares / 10000.0), 0.05, 0.002);
}

TEST(DepthErrorOfTrend, BeginsWhenFirstAskedAndGrowsByTheHour) {
  DepthError error({.offset = Meters(0.3), .trend_m_per_h = 0.6});
  EXPECT_NEAR(error.At(Seconds(5000.0)), 0.3, 1e-12);
  EXPECT_NEAR(error.At(Seconds(5000.0 + 1800.0)), 0.6, 1e-12);
  EXPECT_NEAR(error.At(Seconds(5000.0 + 3600.0)), 0.9, 1e-12);
}

TEST(GyroErrorOfScale, IsAShareOfTheTurn) {
  GyroError error({.scale_error = 0.01, .drift_deg_per_h = 0.0, .drift_time = Seconds(1800.0)});
  for (const double rate : {-0.3, 0.0, 0.2})
    EXPECT_NEAR(error.Of(rate, Seconds(10.0)), 0.01 * rate, 1e-15);
}

TEST(GyroErrorOfWarmth, ComesFromNothingToAllOfIt) {
  GyroError error({.scale_error = 0.0, .drift_deg_per_h = 36.0, .drift_time = Seconds(600.0)});
  const double all = RadiansFromDegrees(36.0) / 3600.0;
  EXPECT_EQ(error.Of(0.0, Seconds(100.0)), 0.0) << "cold when first asked";
  EXPECT_NEAR(error.Of(0.0, Seconds(700.0)), (1.0 - std::exp(-1.0)) * all, 1e-12);
  EXPECT_NEAR(error.Of(0.0, Seconds(20000.0)), all, 1e-12);
}

TEST(MountingErrorOfNothing, IsTheCameraAsItsFileSays) {
  const CameraModel camera;
  const CameraModel same = MountingErrorParams{}.Applied(camera);
  EXPECT_TRUE(same.R_BC.isApprox(camera.R_BC, 1e-12));
  EXPECT_EQ(same.p_BC, camera.p_BC);
}

TEST(MountingErrorOfACamera, MovesItsPictureAsTheMountTurns) {
  const CameraModel camera;
  const Eigen::Vector3d below(0.0, 0.0, 4.0);
  MountingErrorParams rolled;
  rolled.roll = Radians(0.1);
  // The camera's axis leans to port; what is straight below shows to starboard of it.
  const auto pixel = camera.Project(camera.InCamera(Pose{}, below));
  const CameraModel tilted = rolled.Applied(camera);
  const auto seen = tilted.Project(tilted.InCamera(Pose{}, below));
  EXPECT_GT(std::abs(seen->x() - pixel->x()), 30.0);
  EXPECT_NEAR(seen->y(), pixel->y(), 1e-9);
  MountingErrorParams ahead;
  ahead.off_B = {0.5, 0.0, 0.0};
  const CameraModel moved = ahead.Applied(camera);
  EXPECT_GT(moved.Project(moved.InCamera(Pose{}, below))->y(), pixel->y())
      << "what was below the camera is behind it now";
}

TEST(ObjectMotionOfSway, SwingsToEitherSideAndComesBack) {
  ObjectMotionParams motion;
  motion.sway_W = {0.4, -0.2, 0.1};
  motion.sway_period = Seconds(8.0);
  EXPECT_TRUE(motion.At(Seconds(0.0)).isZero());
  EXPECT_TRUE(motion.At(Seconds(2.0)).isApprox(motion.sway_W, 1e-12));
  EXPECT_TRUE(motion.At(Seconds(6.0)).isApprox(-motion.sway_W, 1e-12));
  EXPECT_LT(motion.At(Seconds(8.0)).norm(), 1e-12);
}

TEST(ObjectMotionOfDrift, GoesOnForGood) {
  ObjectMotionParams motion;
  motion.drift_W = {0.01, 0.02, 0.0};
  EXPECT_TRUE(motion.At(Seconds(100.0)).isApprox(Eigen::Vector3d(1.0, 2.0, 0.0), 1e-12));
}

}  // namespace
}  // namespace limpet
