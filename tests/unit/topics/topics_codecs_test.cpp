// SPDX-License-Identifier: MIT
#include <limits>

#include <gtest/gtest.h>

#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/simulation.hpp"

namespace limpet {
namespace {

template <class T>
std::optional<T> RoundTrip(const T& value) {
  return TopicCodec<T>::Decode(TopicCodec<T>::Encode(value));
}

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

TEST(JsonTopic, BringsBackDetections) {
  const Detections sent{
      .frame = 7,
      .exposure = Seconds(1767225600.25),
      .boxes = {{.u = 1.5, .v = 2, .w = 3, .h = 4, .confidence = 0.9, .color = "yellow"}}};
  const auto back = RoundTrip(sent);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->exposure, sent.exposure);
  ASSERT_EQ(back->boxes.size(), 1U);
  EXPECT_EQ(back->boxes[0].color, "yellow");
  EXPECT_EQ(back->boxes[0].u, 1.5);
}

TEST(JsonTopic, BringsBackDecisionsWithTheirReasons) {
  HelmBids sent;
  sent.cause = "arrived";
  sent.options.push_back({.source = "beam",
                          .length = 12.0,
                          .total = 3.5,
                          .end = {1.0, 2.0},
                          .bids = {{.behavior = "cover",
                                    .value = 15.5,
                                    .weight = 1.0,
                                    .has_veto = false,
                                    .why = "useful=16"}}});
  const auto back = RoundTrip(sent);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->options.at(0).bids.at(0).why, "useful=16");
  EXPECT_EQ(back->options.at(0).end[1], 2.0);
}

TEST(JsonTopic, BringsBackAFrameWithoutAltitude) {
  ObservedFrame sent;
  sent.boxes.push_back({.color = "yellow", .landmark = 3});
  const auto back = RoundTrip(sent);
  ASSERT_TRUE(back.has_value());
  EXPECT_FALSE(back->altitude.has_value());
  EXPECT_EQ(back->boxes.at(0).landmark, 3);
}

TEST(JsonTopic, DoesNotThrowAtBrokenUtf8) {
  Detections sent;
  sent.boxes.push_back({.u = 0, .v = 0, .w = 1, .h = 1, .confidence = 1, .color = "\xff"});
  EXPECT_TRUE(RoundTrip(sent).has_value());
}

TEST(JsonTopic, RefusesWhatIsNoJsonOrLacksAField) {
  for (const char* text : {"", "{", "[]", "null", "{\"frame\":1}", "{\"frame\":\"x\"}"}) {
    EXPECT_FALSE(TopicCodec<Detections>::Decode(std::string(text)).has_value()) << text;
  }
}

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
  sent.cells = {{.index = 17279, .seen_height = 2.0F, .seabed_down = 7.5F}};
  const auto back = RoundTrip(sent);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->frame.columns, 144);
  EXPECT_EQ(back->cells.at(0).seabed_down, 7.5F);
}

TEST(BinaryTopic, BringsBackWhatWasOutOfSight) {
  GridDelta sent;
  sent.frame = {.cell_m = 0.25, .rows = 1, .columns = 1};
  sent.cells = {{.index = 0, .seen_height = 2.0F, .seabed_down = 7.5F, .seen_floor = 1.2F}};
  EXPECT_EQ(RoundTrip(sent)->cells.at(0).seen_floor, 1.2F);
}

TEST(BinaryTopic, ReadsAGridDeltaOfAnOlderLog) {
  GridDelta sent;
  sent.frame = {.cell_m = 0.25, .rows = 1, .columns = 1};
  sent.cells = {{.index = 0, .seen_height = 2.0F, .seabed_down = 7.5F, .seen_floor = 1.2F}};
  Binary bytes = std::get<Binary>(TopicCodec<GridDelta>::Encode(sent));
  bytes[3] = std::byte{'1'};  // LGD1 had no floors
  bytes.resize(bytes.size() - sizeof(float));
  const auto back = TopicCodec<GridDelta>::Decode(bytes);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->cells.at(0).seabed_down, 7.5F);
  EXPECT_EQ(back->cells.at(0).seen_floor, 0.0F);
}

TEST(BinaryTopic, RefusesACellOutsideTheGrid) {
  GridDelta sent;
  sent.frame.rows = 2;
  sent.frame.columns = 2;
  sent.cells = {{.index = 4, .seen_height = 0.0F, .seabed_down = 0.0F}};
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

TEST(ThrusterCommandTopic, SaysTheSeventhAndEighthThrusterWhereThereIsOne) {
  const std::vector<double> shares{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
  const auto text = [&](std::size_t count) {
    return EncodeRecord(ThrusterCommand::Of({shares.data(), count}));
  };
  EXPECT_EQ(text(5), "t1=0.1,t2=0.2,t3=0.3,t4=0.4,t5=0.5,t6=0");
  EXPECT_EQ(text(8), "t1=0.1,t2=0.2,t3=0.3,t4=0.4,t5=0.5,t6=0.6,t7=0.7,t8=0.8");
  const auto read = DecodeRecord<ThrusterCommand>(text(8));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->Shares().at(7), 0.8);
}

}  // namespace
}  // namespace limpet
