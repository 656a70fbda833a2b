// SPDX-License-Identifier: MIT
#include "limpet/imaging/water_column.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// c [1/m]
Eigen::Array3f BeamAttenuation(const WaterColumn& water) { return -water.Direct(1.0).log(); }
/// K [1/m]
Eigen::Array3f DiffuseAttenuation(const WaterColumn& water) { return -water.Daylight(1.0).log(); }

TEST(WaterColumn, ClearestChannelKeepsFivePercentAtTheVisibility) {
  for (const double visibility : {1.0, 4.0, 8.0, 20.0}) {
    for (const double dissolved : {0.0, 0.5, 2.0}) {
      const WaterColumn water(Meters(visibility), {dissolved, 1.0});
      EXPECT_NEAR(water.Direct(visibility).maxCoeff(), 0.05, 1e-6)
          << visibility << " " << dissolved;
    }
  }
}

TEST(WaterColumn, DirectLightFallsExponentiallyInEachChannel) {
  const WaterColumn water(Meters(8.0), {0.5, 1.0});
  const Eigen::Array3f squared = water.Direct(2.0).square();
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(water.Direct(4.0)(c), squared(c), 1e-6);
    EXPECT_NEAR(water.Direct(3.0)(c), std::exp(-3.0 * BeamAttenuation(water)(c)), 1e-6);
  }
}

TEST(WaterColumn, RedIsLostFirstAndBlueTooWhereMuchIsDissolved) {
  const Eigen::Array3f clear = WaterColumn(Meters(15.0), {0.0, 1.0}).Direct(5.0);
  EXPECT_GT(clear(0), clear(1));
  EXPECT_GT(clear(1), 2.0 * clear(2));
  const Eigen::Array3f brown = WaterColumn(Meters(4.0), {2.0, 1.0}).Direct(4.0);
  EXPECT_LT(brown(0), 0.2 * brown(1));
}

TEST(WaterColumn, VeilGrowsWithRangeAndSaturates) {
  const WaterColumn water(Meters(6.0), {0.5, 1.0});
  EXPECT_EQ(water.Veil(0.0, {0.0, 0.0, 1.0}).maxCoeff(), 0.0);
  EXPECT_TRUE((water.Veil(4.0, {0.0, 0.0, 1.0}) > water.Veil(2.0, {0.0, 0.0, 1.0})).all());
  const Eigen::Array3f far = water.Veil(200.0, {0.0, 0.0, 1.0});
  EXPECT_TRUE((water.Veil(400.0, {0.0, 0.0, 1.0}) - far).abs().maxCoeff() < 1e-9);
  // Limit: what a metre sends back, over both coefficients.
  const Eigen::Array3f limit =
      water.BackscatterPerMeter() / (BeamAttenuation(water) + DiffuseAttenuation(water));
  EXPECT_LT((far - limit).abs().maxCoeff(), 1e-6);
}

TEST(WaterColumn, VeilOfARayThatGoesDownIsDarkerThanOfALevelOne) {
  const WaterColumn water(Meters(6.0), {0.5, 1.0});
  EXPECT_TRUE((water.Veil(5.0, {0.0, 0.0, 1.0}) < water.Veil(5.0, {0.0, 0.0, 0.0})).all());
  EXPECT_TRUE((water.Veil(5.0, {0.0, 0.0, 0.0}) < water.Veil(5.0, {0.0, 0.0, -1.0})).all());
}

TEST(WaterColumn, NoBackscatterMeansNoVeil) {
  EXPECT_EQ(WaterColumn(Meters(6.0), {0.5, 0.0}).Veil(50.0, {0.0, 0.0, 1.0}).maxCoeff(), 0.0);
}

}  // namespace
}  // namespace limpet
