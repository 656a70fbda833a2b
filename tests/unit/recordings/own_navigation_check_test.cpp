// SPDX-License-Identifier: MIT
#include "limpet/recordings/own_navigation_check.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "limpet/recordings/moos_log.hpp"
#include "tests/support/moos_text.hpp"

namespace limpet {
namespace {

OwnNavigation OwnOf(const MadeLog& log) {
  const std::string text = MoosText(log);
  AlogReader reader = AlogReader::OfText(text);
  return ReadMoosLog(reader, "made.alog")->own;
}

TEST(OwnNavigationCheck, FindsThatPlacesSpeedsAndHeadingsAgree) {
  const auto check = CheckOwnNavigation(OwnOf({}));
  ASSERT_TRUE(check.has_value());
  EXPECT_NEAR(check->places->Rate(), 5.0, 1e-6);
  EXPECT_NEAR(check->path_of_places, 159.8, 0.01);
  EXPECT_NEAR(check->path_of_speeds, 159.8, 0.01);
  EXPECT_GT(check->speed.count, 25U);
  EXPECT_LT(check->speed.greatest, 0.01);
  EXPECT_LT(check->course.within_95, 0.01);
}

TEST(OwnNavigationCheck, ShowsAVehicleThatGoesAnotherWayThanItHeads) {
  const auto check = CheckOwnNavigation(OwnOf({.course_off = 20.0}));
  EXPECT_NEAR(check->course.median, 20.0 * std::numbers::pi / 180.0, 0.01);
}

TEST(OwnNavigationCheck, ComparesNothingWithAHeadingThatIsNotThere) {
  const auto check = CheckOwnNavigation(OwnOf({.has_heading = false}));
  EXPECT_FALSE(check->headings.has_value());
  EXPECT_EQ(check->course.count, 0U);
}

TEST(OwnNavigationCheck, IsNothingOfARecordingWithoutOwnNavigation) {
  EXPECT_FALSE(CheckOwnNavigation({}).has_value());
}

}  // namespace
}  // namespace limpet
