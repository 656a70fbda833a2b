// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/sources/motion_sensor_fixture.hpp"

namespace limpet {
namespace {

TEST(Gps, AFixComesThroughWithItsSigma) {
  const GpsFix said{.north = -12.3 / 7.0, .east = 1e4 / 3.0, .sd = 0.4};
  const auto read = ReadingBy<PositionFix>("gps", TopicCodec<GpsFix>::Encode(said));
  EXPECT_EQ(read.p_W, Eigen::Vector2d(said.north, said.east));
  EXPECT_EQ(read.sd, said.sd);
}

TEST(Gps, OfOthersIsNoReading) { ExpectRefusals("gps"); }

}  // namespace
}  // namespace limpet
