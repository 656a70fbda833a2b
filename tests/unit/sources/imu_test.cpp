// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/sources/motion_sensor_fixture.hpp"

namespace limpet {
namespace {

TEST(Imu, ASampleComesThroughWithEveryBit) {
  ImuSample said;
  said.fx = 0.1, said.fy = -1.0 / 3.0, said.fz = -9.81;
  said.p = 1e-7, said.q = 0.2, said.r = -0.3, said.heading = 6.2;
  const auto read = ReadingBy<InertialInput>("imu", TopicCodec<ImuSample>::Encode(said));
  EXPECT_EQ(read.t, kMailTime);
  EXPECT_EQ(read.force_B, Eigen::Vector3d(said.fx, said.fy, said.fz));
  EXPECT_EQ(read.rate_B, Eigen::Vector3d(said.p, said.q, said.r));
  EXPECT_EQ(read.heading, said.heading);
}

TEST(Imu, OfOthersIsNoReading) { ExpectRefusals("imu"); }

}  // namespace
}  // namespace limpet
