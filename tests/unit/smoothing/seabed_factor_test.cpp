// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/seabed_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/landmark_factor_fixture.hpp"

namespace limpet {
namespace {

using namespace literals;

using SeabedFactorTest = LandmarkFactorTest;

TEST_F(SeabedFactorTest, IsZeroForAnObjectAtTheExpectedHeight) {
  EXPECT_NEAR(SeabedFactor(4.5_m, 1.0_m, 0.7_m).Evaluate(x_, p_W_)(0), 0.0, 1e-12);
}
TEST_F(SeabedFactorTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(SeabedFactor(3.0_m, 1.0_m, 0.7_m));
}

}  // namespace
}  // namespace limpet
