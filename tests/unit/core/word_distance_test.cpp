// SPDX-License-Identifier: MIT
#include "limpet/core/word_distance.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(WordDistance, CountsLettersInsertedRemovedAndChanged) {
  EXPECT_EQ(WordDistance("pSurvy", "pSurvey"), 1U);
  EXPECT_EQ(WordDistance("LatOrgin", "LatOrigin"), 1U);
  EXPECT_EQ(WordDistance("kitten", "sitting"), 3U);
  EXPECT_EQ(WordDistance("", "abc"), 3U);
  EXPECT_EQ(WordDistance("AppTick", "apptick"), 0U);
}

}  // namespace
}  // namespace limpet
