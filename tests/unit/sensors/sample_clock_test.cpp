// SPDX-License-Identifier: MIT
#include "limpet/sensors/sample_clock.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SampleClock, GivesItsRateOnAverageFromAFasterTruth) {
  SampleClock clock(Hertz(20.0));
  int due = 0;
  for (int i = 0; i < 5000; ++i)
    due += clock.IsDue(Seconds(1767225600.0 + i / 50.0)) ? 1 : 0;
  EXPECT_EQ(due, 2000);
}

TEST(SampleClock, TakesEveryTruthAtTheTruthsOwnRate) {
  SampleClock clock(Hertz(50.0));
  for (int i = 0; i < 5000; ++i)
    ASSERT_TRUE(clock.IsDue(Seconds(1767225600.0 + i / 50.0))) << i;
}

}  // namespace
}  // namespace limpet
