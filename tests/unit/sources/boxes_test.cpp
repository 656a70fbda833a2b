// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/sources/motion_sensor_fixture.hpp"

namespace limpet {
namespace {

TEST(Boxes, AFrameIsOfItsExposureNotOfItsMail) {
  Detections said{.frame = 7, .exposure = Seconds(kMailTime - 0.25), .boxes = {}};
  said.boxes.push_back(
      {.u = 1.5, .v = 2.5, .w = 30.0, .h = 1.0 / 3.0, .confidence = 0.9, .color = "dark green"});
  const Value mail = TopicCodec<Detections>::Encode(said);
  const ObservationPtr seen = MotionSensorCalled("boxes")->Observe(kMailTime, mail);
  EXPECT_NEAR(SecondsOf(*seen), kMailTime - 0.25, 1e-7);
  const auto read = ReadingBy<Detections>("boxes", mail);
  EXPECT_EQ(read.frame, 7);
  EXPECT_EQ(read.exposure.value(), kMailTime - 0.25);
  ASSERT_EQ(read.boxes.size(), 1U);
  EXPECT_EQ(read.boxes[0].h, 1.0 / 3.0);
  EXPECT_EQ(read.boxes[0].color, "dark green");
}

TEST(Boxes, OfOthersIsNoReading) { ExpectRefusals("boxes"); }

}  // namespace
}  // namespace limpet
