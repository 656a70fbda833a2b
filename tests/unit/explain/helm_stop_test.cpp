// SPDX-License-Identifier: MIT
#include "limpet/explain/helm_stop.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

void Iterate(HelmStops& stops, double time, const char* state, const char* allstop = nullptr) {
  stops.Take("IVPHELM_STATE", state, time);
  if (allstop != nullptr) stops.Take("IVPHELM_ALLSTOP", allstop, time + 0.001);
}

TEST(HelmStops, LastFromTheParkingToTheLastWordThatAllIsClear) {
  HelmStops stops;
  Iterate(stops, 1.0, "DRIVE", "clear");
  Iterate(stops, 452.7, "PARK", "ManualOverride");
  Iterate(stops, 460.0, "PARK");
  Iterate(stops, 466.2, "DRIVE", "clear");
  ASSERT_EQ(stops.stops().size(), 1U);
  EXPECT_EQ(stops.stops()[0].why, "ManualOverride");
  EXPECT_EQ(stops.stops()[0].begin, 452.7);
  EXPECT_NEAR(stops.stops()[0].end.value_or(0.0), 466.201, 1e-9);
  EXPECT_EQ(stops.At(452.6), nullptr);
  EXPECT_NE(stops.At(460.0), nullptr);
  EXPECT_EQ(stops.At(466.3), nullptr);
}

TEST(HelmStops, KnowAParkedHelmThatGivesNoReason) {
  HelmStops stops;
  Iterate(stops, 1.0, "PARK");
  Iterate(stops, 2.0, "DRIVE");
  ASSERT_EQ(stops.stops().size(), 1U);
  EXPECT_EQ(stops.stops()[0].why, "PARK");
}

TEST(HelmStops, FollowOneUponAnotherWhereTheReasonIsAnother) {
  HelmStops stops;
  Iterate(stops, 1.0, "DRIVE", "MissingNav");
  Iterate(stops, 2.0, "DRIVE", "NothingToDo");
  ASSERT_EQ(stops.stops().size(), 2U);
  EXPECT_EQ(stops.stops()[0].end, stops.stops()[1].begin);
  EXPECT_FALSE(stops.stops()[1].end);
}

TEST(HelmStops, AreNoneWhereOneBehaviorHandsOverToAnother) {
  HelmStops stops;
  Iterate(stops, 1.0, "DRIVE", "MissingDecVars:course");
  Iterate(stops, 1.1, "DRIVE", "clear");
  EXPECT_TRUE(stops.stops().empty()) << "the helm holds one iteration off";
  Iterate(stops, 2.0, "DRIVE", "MissingDecVars:course");
  Iterate(stops, 2.1, "DRIVE");
  Iterate(stops, 2.2, "DRIVE", "clear");
  EXPECT_EQ(stops.stops().size(), 1U);
}

TEST(HelmStops, NeedNoWordOfTheState) {
  HelmStops stops;
  stops.Take("IVPHELM_ALLSTOP", "MissingNav", 1.0);
  stops.Take("IVPHELM_ALLSTOP", "NothingToDo", 2.0);
  stops.Take("IVPHELM_ALLSTOP", "clear", 3.0);
  ASSERT_EQ(stops.stops().size(), 2U);
  EXPECT_EQ(stops.stops()[0].why, "MissingNav");
  EXPECT_EQ(stops.stops()[1].end, 3.0);
}

}  // namespace
}  // namespace limpet
