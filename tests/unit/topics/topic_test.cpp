// SPDX-License-Identifier: MIT
#include "limpet/topics/topic.hpp"

#include <gtest/gtest.h>

#include "limpet/topics/navigation.hpp"
#include "limpet/topics/sensors.hpp"
#include "tests/unit/topics/round_trip.hpp"

namespace limpet {
namespace {

TEST(RecordTopic, KeepsEveryBitOfItsNumbers) {
  const NavState state{.north = 0.1, .east = -1e-300, .down = 1.0 / 3.0, .altitude = 4.2};
  const auto back = RoundTrip(state);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->north, 0.1);
  EXPECT_EQ(back->east, -1e-300);
  EXPECT_EQ(back->down, 1.0 / 3.0);
  EXPECT_EQ(back->altitude, 4.2);
}

TEST(RecordTopic, LeavesUnknownsOut) {
  DvlSample ping;
  ping.u = 0.5;
  const auto back = RoundTrip(ping);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->u, 0.5);
  EXPECT_FALSE(back->v.has_value());
}

TEST(RecordTopic, RefusesARecordThatLacksAField) {
  EXPECT_FALSE(TopicCodec<DeadReckoning>::Decode(std::string("north=1,east=2,down=3")).has_value());
  EXPECT_FALSE(TopicCodec<DeadReckoning>::Decode(Value(3.0)).has_value());
}

TEST(PlainTopic, RefusesAnotherType) {
  EXPECT_FALSE(TopicCodec<double>::Decode(std::string("1")).has_value());
  EXPECT_FALSE(TopicCodec<std::string>::Decode(1.0).has_value());
  EXPECT_FALSE(TopicCodec<Binary>::Decode(1.0).has_value());
}

TEST(PlainTopic, SpeaksMoosFlags) {
  EXPECT_EQ(TopicCodec<bool>::Encode(true), Value(std::string("true")));
  EXPECT_EQ(TopicCodec<bool>::Decode(std::string("TRUE")), true);
  EXPECT_FALSE(TopicCodec<bool>::Decode(std::string("maybe")).has_value());
}

}  // namespace
}  // namespace limpet
