// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "limpet/topics/mapping.hpp"
#include "limpet/topics/sensors.hpp"
#include "tests/unit/topics/round_trip.hpp"

namespace limpet {
namespace {

TEST(BinaryTopic, BringsBackAFrame) {
  CameraFrame sent;
  sent.frame = 9;
  sent.exposure = Seconds(12.5);
  sent.width_px = 2;
  sent.height_px = 1;
  sent.bgr = {1, 2, 3, 4, 5, 6};
  const auto back = RoundTrip(sent);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->frame, 9U);
  EXPECT_EQ(back->bgr, sent.bgr);
}

TEST(BinaryTopic, TakesAnEmptyFrame) {  // found by fuzzing: no address to copy from
  EXPECT_TRUE(RoundTrip(CameraFrame{}).has_value());
}

TEST(BinaryTopic, HasTheHeaderItsCommentPromises) {
  const Binary bytes = std::get<Binary>(TopicCodec<CameraFrame>::Encode({}));
  ASSERT_EQ(bytes.size(), 32U);
  EXPECT_EQ(bytes[0], std::byte{'L'});
  EXPECT_EQ(bytes[3], std::byte{'1'});
}

TEST(BinaryTopic, BringsBackAGridDelta) {
  GridDelta sent;
  sent.frame = {.north_min = -15.0, .east_min = -18.0, .cell_m = 0.25, .rows = 120, .columns = 144};
  sent.cells = {{.index = 17279, .now = {.seen_height = 2.0F, .seabed_down = 7.5F}}};
  const auto back = RoundTrip(sent);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->frame.columns, 144);
  EXPECT_EQ(back->cells.at(0).now.seabed_down, 7.5F);
}

TEST(BinaryTopic, BringsBackWhatWasOutOfSight) {
  GridDelta sent;
  sent.frame = {.cell_m = 0.25, .rows = 1, .columns = 1};
  sent.cells = {
      {.index = 0, .now = {.seen_height = 2.0F, .seabed_down = 7.5F, .seen_floor = 1.2F}}};
  EXPECT_EQ(RoundTrip(sent)->cells.at(0).now.seen_floor, 1.2F);
}

TEST(BinaryTopic, ReadsAGridDeltaOfAnOlderLog) {
  GridDelta sent;
  sent.frame = {.cell_m = 0.25, .rows = 1, .columns = 1};
  sent.cells = {
      {.index = 0, .now = {.seen_height = 2.0F, .seabed_down = 7.5F, .seen_floor = 1.2F}}};
  Binary bytes = std::get<Binary>(TopicCodec<GridDelta>::Encode(sent));
  bytes[3] = std::byte{'1'};  // LGD1 had no floors
  bytes.resize(bytes.size() - sizeof(float));
  const auto back = TopicCodec<GridDelta>::Decode(bytes);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->cells.at(0).now.seabed_down, 7.5F);
  EXPECT_EQ(back->cells.at(0).now.seen_floor, 0.0F);
}

TEST(BinaryTopic, RefusesACellOutsideTheGrid) {
  GridDelta sent;
  sent.frame.rows = 2;
  sent.frame.columns = 2;
  sent.cells = {{.index = 4, .now = {.seen_height = 0.0F, .seabed_down = 0.0F}}};
  EXPECT_FALSE(RoundTrip(sent).has_value());
}

TEST(BinaryTopic, RefusesAnyTruncation) {
  GridDelta sent;
  sent.frame.rows = 2;
  sent.frame.columns = 2;
  sent.cells.resize(3);
  Binary bytes = std::get<Binary>(TopicCodec<GridDelta>::Encode(sent));
  while (!bytes.empty()) {
    bytes.pop_back();
    EXPECT_FALSE(TopicCodec<GridDelta>::Decode(bytes).has_value());
  }
}

}  // namespace
}  // namespace limpet
