// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/sources/motion_sensor_fixture.hpp"

namespace limpet {
namespace {

TEST(DepthSensor, ADepthComesThroughWithEveryBit) {
  const auto read = ReadingBy<DepthReading>("depth", Value(12.3 / 7.0));
  EXPECT_EQ(read.t, kMailTime);
  EXPECT_EQ(read.depth, 12.3 / 7.0);
}

TEST(DepthSensor, ATimeThatNobodyCanSayIsNoObservation) {
  const auto sensor = MotionSensorCalled("depth");
  EXPECT_EQ(sensor->Observe(std::nan(""), Value(1.0)), nullptr);
  EXPECT_EQ(sensor->Observe(1e300, Value(1.0)), nullptr);
}

TEST(DepthSensor, OfOthersIsNoReading) { ExpectRefusals("depth"); }

}  // namespace
}  // namespace limpet
