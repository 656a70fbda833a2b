// SPDX-License-Identifier: MIT
#include "limpet/report/current_sentence.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(CurrentSentence, SaysHowFastTheWaterIsAndWhereItSetsTo) {
  EXPECT_EQ(CurrentSentence({.north = 0.0, .east = 0.2, .sd = 0.01}),
            "0.20 m/s, sets to 090 deg, give or take 0.01 m/s");
  EXPECT_EQ(CurrentSentence({.north = -0.1, .east = 0.0, .sd = 0.02}),
            "0.10 m/s, sets to 180 deg, give or take 0.02 m/s");
}

}  // namespace
}  // namespace limpet
