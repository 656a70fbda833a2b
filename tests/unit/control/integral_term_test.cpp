// SPDX-License-Identifier: MIT
#include "limpet/control/integral_term.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

TEST(IntegralTerm, StandsStillWhileThrustersSaturateButMayUnwind) {
  IntegralTerm integral({.gain = 1.0, .limit = 10.0});
  const double before = integral.Update(1.0, Seconds(1.0), false);
  EXPECT_EQ(integral.Update(1.0, Seconds(1.0), true), before);
  EXPECT_LT(integral.Update(-0.5, Seconds(1.0), true), before);
}

TEST(IntegralTerm, StaysWithinItsLimit) {
  IntegralTerm integral({.gain = 1.0, .limit = 2.0});
  for (int i = 0; i < 10; ++i)
    (void)integral.Update(1.0, Seconds(1.0), false);
  EXPECT_EQ(integral.value(), 2.0);
}

TEST(IntegralProperties, NeverLeaveTheirLimitNorGrowWhileActuatorsSaturate) {
  Random random(5, "integral");
  for (int run = 0; run < 50; ++run) {
    IntegralTerm integral({.gain = random.Uniform(0.1, 2.0), .limit = 0.5});
    for (int step = 0; step < 200; ++step) {
      const double before = std::abs(integral.value());
      const bool is_saturated = random.Chance(0.4);
      const double value = integral.Update(random.Uniform(-3.0, 3.0), Seconds(0.1), is_saturated);
      EXPECT_LE(std::abs(value), 0.5);
      if (is_saturated) {
        EXPECT_LE(std::abs(value), before);
      }
    }
  }
}

}  // namespace
}  // namespace limpet
