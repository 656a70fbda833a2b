// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/sources/motion_sensor_fixture.hpp"

namespace limpet {
namespace {

TEST(Fog, ARateComesThroughWithEveryBit) {
  const auto read = ReadingBy<YawRate>("fog", Value(0.1 / 3.0));
  EXPECT_EQ(read.t, kMailTime);
  EXPECT_EQ(read.rate, 0.1 / 3.0);
}

TEST(Fog, OfOthersIsNoReading) { ExpectRefusals("fog"); }

}  // namespace
}  // namespace limpet
