// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/change_simulation.hpp"

namespace limpet {
namespace {

using trial::Calibrate;
using trial::Calibration;
using trial::ChangeWorld;

void ExpectCalibrated(const ChangeWorld& world) {
  Random random(5);
  for (const Calibration& score : Calibrate(world, LookParams{}, 3000, random)) {
    EXPECT_LE(score.brier, 0.05);
    EXPECT_LE(score.expected_error, 0.03);
  }
}

TEST(ChangeCalibration, MeansWhatItSaysDespitePassesThatFailAsAWhole) { ExpectCalibrated({}); }

TEST(ChangeCalibration, BearsADetectorTwentyPercentWorseThanBelieved) {
  ExpectCalibrated({.rate_factor = 0.8});
}

TEST(ChangeCalibration, BearsADetectorTwentyPercentBetterThanBelieved) {
  ExpectCalibrated({.detects = 0.75, .rate_factor = 1.2});
}

}  // namespace
}  // namespace limpet
