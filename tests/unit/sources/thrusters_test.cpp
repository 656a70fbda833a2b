// SPDX-License-Identifier: MIT
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/topics/mission.hpp"
#include "tests/unit/sources/motion_sensor_fixture.hpp"

namespace limpet {
namespace {

TEST(Thrusters, ReadsWhatEachIsTold) {
  const ThrusterCommand said{.t1 = 0.1, .t2 = -1.0, .t4 = 1.0 / 3.0, .t7 = 0.25};
  const auto read =
      ReadingBy<ThrusterShares>("thrusters", TopicCodec<ThrusterCommand>::Encode(said));
  EXPECT_EQ(read.t, kMailTime);
  EXPECT_THAT(read.shares, ::testing::ElementsAre(0.1, -1.0, 0.0, 1.0 / 3.0, 0.0, 0.0, 0.25, 0.0));
}

TEST(Thrusters, OfOthersIsNoReading) { ExpectRefusals("thrusters"); }

TEST(Thrusters, AShareThatIsNoNumberIsNone) {
  const auto sensor = MotionSensorCalled("thrusters");
  const ThrusterShares told{.t = 1.0, .shares = {std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_FALSE(sensor->ReadingOf(*ObservationOf(told)).has_value());
}

TEST(Thrusters, AMissionMayDoWithoutThem) {
  EXPECT_TRUE(MotionSensorCalled("thrusters")->is_dispensable());
  EXPECT_FALSE(MotionSensorCalled("imu")->is_dispensable());
}

}  // namespace
}  // namespace limpet
