// SPDX-License-Identifier: MIT
#include "limpet/sensors/gps_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/sensors/statistics.hpp"

namespace limpet {
namespace {

SimTruth AtDepth(double down) {
  SimTruth truth;
  truth.down = down;
  return truth;
}

TEST(GpsModel, HasNoFixOnceTheAntennaIsUnderWater) {
  GpsModel gps({}, Random(1));
  EXPECT_TRUE(gps.Sample(AtDepth(0.13), Seconds(0.0)));
  EXPECT_FALSE(gps.Sample(AtDepth(0.26), Seconds(1.0)));
}

TEST(GpsModel, ErrorHasItsSigmaOverSessions) {
  Statistics errors;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    errors.Add(GpsModel({}, Random(seed)).Sample(AtDepth(0.1), Seconds(0.0))->north);
  }
  EXPECT_NEAR(errors.sigma(), 0.4, 0.04);
}

/// Correlation of the errors of two fixes `apart` [s].
double Correlation(double apart) {
  double product = 0.0, square = 0.0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    GpsModel gps({.sheet = {.noise_m = 0.0}}, Random(seed));
    const double first = gps.Sample(AtDepth(0.1), Seconds(0.0))->east;
    product += first * gps.Sample(AtDepth(0.1), Seconds(apart))->east;
    square += first * first;
  }
  return product / square;
}

TEST(GpsModel, ErrorsOfFixesCloseInTimeAreNearlyTheSame) { EXPECT_GT(Correlation(5.0), 0.9); }

TEST(GpsModel, ErrorsOfFixesFarApartAreNot) {
  EXPECT_NEAR(Correlation(120.0), std::exp(-1.0), 0.08);
  EXPECT_NEAR(Correlation(1200.0), 0.0, 0.08);
}

}  // namespace
}  // namespace limpet
