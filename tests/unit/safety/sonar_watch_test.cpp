// SPDX-License-Identifier: MIT
#include "limpet/safety/sonar_watch.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

SonarPing Ping(std::vector<double> ranges) {
  return {.first = -0.5, .step = 0.5, .reach = 15.0, .ranges = std::move(ranges)};
}

TEST(SonarWatch, NoticesAPingThatIsRepeated) {
  SonarWatch watch;
  EXPECT_FALSE(watch.heard());
  EXPECT_FALSE(watch.stuck_for());
  for (int i = 0; i <= 40; ++i) {
    watch.Hear(Ping({0.0, 7.25, 0.0}), Seconds(100.0 + 0.25 * i));
  }
  EXPECT_EQ(watch.heard(), Seconds(110.0));
  EXPECT_DOUBLE_EQ(watch.stuck_for().value(), 10.0);
  watch.Hear(Ping({0.0, 7.26, 0.0}), Seconds(110.25));
  EXPECT_DOUBLE_EQ(watch.stuck_for().value(), 0.0);
}

TEST(SonarWatch, TellsApartTheSameEchoFromAnotherBeam) {
  SonarWatch watch;
  watch.Hear(Ping({0.0, 7.25, 0.0}), Seconds(100.0));
  watch.Hear(Ping({0.0, 0.0, 7.25}), Seconds(110.0));
  EXPECT_DOUBLE_EQ(watch.stuck_for().value(), 0.0);
}

TEST(SonarWatch, TakesOpenWaterForNoFault) {
  SonarWatch watch;
  for (int i = 0; i < 400; ++i) {
    watch.Hear(Ping({0.0, 0.0, 0.0}), Seconds(100.0 + 0.25 * i));
  }
  EXPECT_DOUBLE_EQ(watch.stuck_for().value(), 0.0);
}

}  // namespace
}  // namespace limpet
