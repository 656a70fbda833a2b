// SPDX-License-Identifier: MIT
#include "limpet/preflight/unseen_ground.hpp"

#include <string>

#include <gtest/gtest.h>

#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

Setting SettingOf(double value) {
  Setting setting;
  setting.text = std::to_string(value);
  return setting;
}

/// Of the area with these corners, as missions write them, surveyed from 4 m with turns of 3 m.
std::optional<UnseenShare> UnseenIn(const std::string& corners,
                                    const std::optional<PlanePoint>& start = {}) {
  SurveyFacts facts;
  facts.area = AreaWithin(*ParsePlaces("pts={" + corners + "}"));
  facts.area.margin = 2.0;
  facts.altitude = SettingOf(4.0);
  facts.band = SettingOf(1.0);
  facts.turning_radius = 3.0;
  return UnseenGround(facts, Region(facts.area, Meters(0.5)), start);
}

TEST(UnseenGround, IsLittleOfTwoFieldsThatAStraightNeckJoins) {
  const auto unseen = UnseenIn("-20,-8:-3,-8:-3,-1:3,-1:3,-8:20,-8:20,8:3,8:3,1:-3,1:-3,8:-20,8");
  ASSERT_TRUE(unseen);
  EXPECT_LT(unseen->share, 0.03);
}

TEST(UnseenGround, IsLittleFromAStartInEitherField) {
  for (const double east : {-12.0, 12.0}) {
    const auto unseen = UnseenIn("-20,-8:-3,-8:-3,-1:3,-1:3,-8:20,-8:20,8:3,8:3,1:-3,1:-3,8:-20,8",
                                 PlanePoint(0.0, east));
    ASSERT_TRUE(unseen);
    EXPECT_LT(unseen->share, 0.03);
    EXPECT_FALSE(unseen->is_start_shut_off);
  }
}

TEST(UnseenGround, IsLittleOfTwoFieldsThatASlantingNeckJoins) {
  const auto unseen =
      UnseenIn("-24,-16:-6,-16:-6,-5.2:6,3.2:6,-4:24,-4:24,16:6,16:6,5.6:-6,-2.8:-6,4:-24,4");
  ASSERT_TRUE(unseen);
  EXPECT_LT(unseen->share, 0.05);
}

TEST(UnseenGround, IsHalfWhereTheNeckBendsSharply) {
  // Up out of one field, and at a right angle into the other: no room to turn in between.
  const auto unseen = UnseenIn(
      "-30,-8:-14,-8:-14,8:-21,8:-21,20:0,20:0,8:-2,8:-2,-8:14,-8:14,8:1,8:1,21:-22,21:"
      "-22,8:-30,8");
  ASSERT_TRUE(unseen);
  EXPECT_GT(unseen->share, 0.3);
}

TEST(UnseenGround, IsNothingBeyondASlitThatIsFlownOver) {
  // 3 m wide, and the vehicle may go 2 m beyond the area on either side.
  const auto unseen = UnseenIn("-25,-12:-1.5,-12:-1.5,10:1.5,10:1.5,-12:25,-12:25,12:-25,12");
  ASSERT_TRUE(unseen);
  EXPECT_LT(unseen->share, 0.01);
}

TEST(UnseenGround, IsWhatAPassageDoesNotShow) {
  // The neck is a spur without a field at its end: nobody comes back from there.
  const auto unseen = UnseenIn("-20,-8:-3,-8:-3,-1:17,-1:17,1:-3,1:-3,8:-20,8");
  ASSERT_TRUE(unseen);
  EXPECT_GT(unseen->share, 0.04);
}

}  // namespace
}  // namespace limpet
