// SPDX-License-Identifier: MIT
#include "limpet/report/water_sentence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(WaterSentence, SaysWhatWasNotInSight) {
  WaterScore water{.visibility = {.visibility = Meters(2.9), .sd = Meters(1.2)},
                   .believed = {.seabed = 0.0, .band = 0.7, .band_top = 0.97},
                   .seen_from_m = 1.2};
  EXPECT_THAT(WaterSentence(water), HasSubstr("visibility 2.9 m, give or take 1.2 m"));
  EXPECT_THAT(WaterSentence(water), HasSubstr("from 1.2 m above the bottom up only"));
  water.believed = {};
  EXPECT_THAT(WaterSentence(water), HasSubstr("nothing is inspected"));
  water = {.visibility = {.visibility = Meters(9.0), .sd = Meters(4.0)},
           .believed = {1.0, 1.0, 1.0}};
  EXPECT_THAT(WaterSentence(water), HasSubstr("the bottom was in sight"));
}

TEST(WaterSentence, OfASessionWithoutAnImageDoesNotSayThatTheBottomWasInSight) {
  const WaterScore water{.visibility = {.visibility = Meters(9.0), .sd = Meters(4.0)},
                         .believed = {},
                         .seen_from_m = 0.0};
  EXPECT_THAT(WaterSentence(water), HasSubstr("nothing was seen, nothing is inspected"));
  EXPECT_THAT(WaterSentence(water), Not(HasSubstr("in sight")));
}

}  // namespace
}  // namespace limpet
