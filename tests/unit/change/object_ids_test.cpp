// SPDX-License-Identifier: MIT
#include "estimation/change/object_ids.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(ObjectIds, BeginBehindThoseOfFormerObjects) {
  ObjectIds ids;
  ids.Reserve(3);
  EXPECT_EQ(ids.Take(), 4);
  ids.Reserve(2);
  EXPECT_EQ(ids.Take(), 5);
}

TEST(ObjectIds, ALandmarkThatNowStandsForAnotherGoesOnUnderItsId) {
  ObjectIds ids;
  EXPECT_EQ(ids.OfLandmark(7, {{7, 7}}), 1);
  EXPECT_EQ(ids.OfLandmark(8, {{7, 7}, {8, 8}}), 2);
  EXPECT_EQ(ids.OfLandmark(9, {{7, 9}, {8, 8}, {9, 9}}), 1);
  EXPECT_EQ(ids.OfLandmark(8, {{7, 9}, {8, 8}, {9, 9}}), 2);
  EXPECT_EQ(ids.OfLandmark(10, {{10, 10}}), 3);
}

}  // namespace
}  // namespace limpet
