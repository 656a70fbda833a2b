// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/sources/motion_sensor_fixture.hpp"

namespace limpet {
namespace {

TEST(Dvl, APingSaysItsVelocityWithEveryBit) {
  DvlSample said;
  said.has_lock = true;
  said.u = 0.5, said.v = -0.1 / 3.0, said.w = 0.01;
  const auto read = ReadingBy<BottomTrack>("dvl", TopicCodec<DvlSample>::Encode(said));
  EXPECT_EQ(read.v_WD_D, Eigen::Vector3d(0.5, -0.1 / 3.0, 0.01));
  EXPECT_EQ(read.altitude, std::nullopt);
}

TEST(Dvl, WithoutLockThereIsNoVelocity) {
  DvlSample said;
  said.u = said.v = said.w = 0.5;
  said.altitude = 3.9;
  const auto read = ReadingBy<BottomTrack>("dvl", TopicCodec<DvlSample>::Encode(said));
  EXPECT_EQ(read.v_WD_D, std::nullopt);
  EXPECT_EQ(read.altitude, 3.9);
}

TEST(Dvl, OfOthersIsNoReading) { ExpectRefusals("dvl"); }

}  // namespace
}  // namespace limpet
