// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/range_factor.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/smoothing/landmark_factor_fixture.hpp"

namespace limpet {
namespace {

using namespace literals;

using RangeFactorTest = LandmarkFactorTest;

TEST_F(RangeFactorTest, IsZeroForTheBoxOfASphere) {
  // In the camera's xz plane the tangents to a circle of radius r enclose twice asin(r / distance).
  const Eigen::Vector3d p = InCamera();
  const double radius = 0.5;
  const auto range_of = [radius](double side, double depth) {
    const double middle = std::atan2(side, depth);
    const double half = std::asin(radius / std::hypot(side, depth));
    const double low = std::tan(middle - half), high = std::tan(middle + half);
    return radius / std::sin(0.5 * (std::atan(high) - std::atan(low)));
  };
  const double measured = 0.5 * (range_of(p.x(), p.z()) + range_of(p.y(), p.z()));
  EXPECT_NEAR(RangeFactor(camera_, Meters(measured), 0.1_m).Evaluate(x_, p_W_)(0), 0.0, 1e-9);
}
TEST_F(RangeFactorTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(RangeFactor(camera_, 3.0_m, 0.1_m));
  ExpectJacobiansMatch(RangeFactor(camera_, 3.0_m, 0.1_m, {1.0, 0.0}));
  ExpectJacobiansMatch(RangeFactor(camera_, 3.0_m, 0.1_m, {0.0, 1.0}));
}

}  // namespace
}  // namespace limpet
