// SPDX-License-Identifier: MIT
#include "limpet/survey/look.hpp"

#include <string>
#include <variant>

#include <gtest/gtest.h>

namespace limpet {
namespace {

bool IsLook(const LookModel& model, double drop, double ahead, double starboard) {
  return ChanceToDetect(model, Pose{}, {ahead, starboard, drop}) >= kLookChance;
}

TEST(LookWindow, ShowsThePlaceFromEverywhereInIt) {
  const LookModel model;
  for (const double drop : {1.0, 2.0, 3.5, 6.0}) {
    const auto window = LookWindowAbove(model, {.drop = drop});
    ASSERT_TRUE(window) << drop;
    for (const double x : {-1.0, 0.0, 1.0}) {
      for (const double y : {-1.0, 0.0, 1.0}) {
        EXPECT_TRUE(IsLook(model, drop, x * window->half_along, y * window->half_across));
      }
    }
  }
}

TEST(LookWindow, LeavesNoMoreThanACornerUnused) {
  const LookModel model;
  const auto window = LookWindowAbove(model, {.drop = 3.5});
  ASSERT_TRUE(window);
  EXPECT_FALSE(IsLook(model, 3.5, 1.3 * window->half_along, 0.0));
  EXPECT_FALSE(IsLook(model, 3.5, 0.0, 1.3 * window->half_across));
}

TEST(LookWindow, KeepsTheSlackToTheEdge) {
  const LookModel model;
  const auto window = LookWindowAbove(model, {.drop = 3.5, .slack = 0.5});
  ASSERT_TRUE(window);
  EXPECT_TRUE(IsLook(model, 3.5, window->half_along + 0.5, window->half_across + 0.5));
}

TEST(LookWindow, IsNarrowerForAnObjectThatFloats) {
  const auto low = LookWindowAbove(LookModel{}, {.drop = 3.5});
  const auto high = LookWindowAbove(LookModel{}, {.drop = 1.5});
  EXPECT_LT(high->half_across, 1.5);  // within the 1.5 m that used to count as a look
  EXPECT_LT(high->half_across, low->half_across);
}

TEST(LookWindow, IsNoneWhereNothingCanBeSeen) {
  LookModel murky;
  murky.detection.visibility = Meters(2.0);
  EXPECT_FALSE(LookWindowAbove(murky, {.drop = 3.5}));
  EXPECT_FALSE(LookWindowAbove(LookModel{}, {.drop = -0.5}));  // as high as the camera
}

TEST(LookModel, SurvivesItsMessage) {
  LookModel model;
  model.detection.visibility = Meters(5.0);
  model.object_radius = 0.3;
  model.camera = CameraModel::FromFieldOfView(640, 480, {.across = 1.0, .along = 0.8});
  const auto decoded = TopicCodec<MapLook>::Decode(TopicCodec<MapLook>::Encode(ToMapLook(model)));
  ASSERT_TRUE(decoded);
  const auto sent = LookWindowAbove(model, {.drop = 2.0, .slack = 0.1});
  const auto received = LookWindowAbove(ToLookModel(*decoded), {.drop = 2.0, .slack = 0.1});
  EXPECT_DOUBLE_EQ(sent->half_across, received->half_across);
}

TEST(LookModel, IsNotTakenFromAMessageThatSaysAnythingOfTheDetectorUnderAnotherName) {
  const std::string text =
      std::get<std::string>(TopicCodec<MapLook>::Encode(ToMapLook(LookModel{})));
  EXPECT_TRUE(TopicCodec<MapLook>::Decode(text));
  std::string former = text;  // as logs of former versions have it
  former.replace(former.find("visibility_m="), std::string("visibility_m=").size(), "visibility=");
  EXPECT_FALSE(TopicCodec<MapLook>::Decode(former));
}

}  // namespace
}  // namespace limpet
