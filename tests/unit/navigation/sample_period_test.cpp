// SPDX-License-Identifier: MIT
#include "estimation/navigation/sample_period.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SamplePeriod, IsTheUsualOneUntilTheSensorHasSpoken) {
  SamplePeriod period(0.2);
  EXPECT_EQ(period.value(), 0.2);
  period.Note(3.0);
  EXPECT_EQ(period.value(), 0.2);
}

TEST(SamplePeriod, FollowsASensorThatIsSlowerThanUsual) {
  SamplePeriod period(0.2);
  for (int i = 0; i < 6; ++i)
    period.Note(i);
  EXPECT_EQ(period.value(), 1.0);
}

TEST(SamplePeriod, JitterOfStampsAndPausesChangeNothing) {
  SamplePeriod period(0.2);
  double t = 0.0;
  for (int i = 0; i < 100; ++i) {
    period.Note(t + (i % 3 == 0 ? 0.003 : -0.002));
    t += i % 10 == 9 ? 30.0 : 0.2;
  }
  EXPECT_EQ(period.value(), 0.2);
}

TEST(SamplePeriod, AStampThatGoesBackIsNoInterval) {
  SamplePeriod period(0.2);
  for (int i = 0; i < 20; ++i)
    period.Note(100.0 - i);
  EXPECT_EQ(period.value(), 0.2);
}

}  // namespace
}  // namespace limpet
