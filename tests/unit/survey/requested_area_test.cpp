// SPDX-License-Identifier: MIT
// What pSurvey answers to an operator is in tests/unit/pSurvey.
#include "limpet/survey/requested_area.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using testing::HasSubstr;

const SurveyArea kMission{.north_max = 5.0, .east_max = 5.0, .margin = 3.0};
const SurveyParams kParams;

Expected<SurveyArea> Requested(const std::string& text,
                               std::optional<PlanePoint> vehicle_W = std::nullopt) {
  return RequestedArea(text, {.area = kMission, .params = kParams, .vehicle_W = vehicle_W});
}

TEST(RequestedArea, KeepsOfTheMissionsWhatItDoesNotSay) {
  const Expected<SurveyArea> area = Requested("area={0,0:20,0:20,10:0,10}");
  ASSERT_TRUE(area);
  EXPECT_DOUBLE_EQ(area->north_max, 10.0) << "x is east";
  EXPECT_DOUBLE_EQ(area->margin, 3.0);
  EXPECT_FALSE(area->keep_out) << "zones of before are gone";
  EXPECT_DOUBLE_EQ(Requested("area={0,0:20,0:20,10:0,10},margin=1")->margin, 1.0);
}

TEST(RequestedArea, RefusesWhatCannotBeReadWithTheFormThatIsWanted) {
  for (const char* text : {"", "area=", "area={0,0:1}x", "hash=1,area={0,0:20,0:20,10:0,10}"}) {
    const Expected<SurveyArea> area = Requested(text);
    ASSERT_FALSE(area) << text;
    EXPECT_FALSE(area.error().text.empty());
  }
  EXPECT_THAT(Requested("go north").error().text, HasSubstr("wanted: area={x,y:x,y:x,y}"));
}

TEST(RequestedArea, OfAnotherSiteIsRefusedByTheVehiclesPlaceOrTheDatum) {
  const std::string far = "area={90000,0:90020,0:90020,20:90000,20}";
  EXPECT_THAT(Requested(far).error().text, HasSubstr("90 km from the mission's datum"));
  EXPECT_TRUE(Requested(far, PlanePoint(0.0, 89000.0)));
  EXPECT_THAT(Requested(far, PlanePoint(0.0, 60000.0)).error().text,
              HasSubstr("30 km from the vehicle"));
}

}  // namespace
}  // namespace limpet
