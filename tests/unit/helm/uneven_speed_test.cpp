// SPDX-License-Identifier: MIT
#include "limpet/helm/uneven_speed.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

MotionDomain SpeedsTo(double high, int points) {
  MotionDomain domain;
  domain.speed = MotionAxis{.low = 0.0, .high = high, .points = points};
  return domain;
}

/// At a point of the domain.
double ValueAt(const MotionTable& table, int point) {
  return static_cast<double>(table.values()[static_cast<std::size_t>(point)]);
}

TEST(UnevenSpeed, FallsSlowlyTowardsSlowAndSteeplyTowardsFast) {
  UnevenSpeed speed;
  const MotionTable* table =
      speed.Around({.speed = 2.0, .slow_value = 0.7, .share = 1.0}, SpeedsTo(4.0, 41));
  ASSERT_NE(table, nullptr);
  EXPECT_FALSE(table->Problem());
  EXPECT_NEAR(ValueAt(*table, 0), 0.0, 1e-6);
  EXPECT_NEAR(ValueAt(*table, 1), 0.7, 1e-6);
  EXPECT_NEAR(ValueAt(*table, 20), 1.0, 1e-6);
  EXPECT_NEAR(ValueAt(*table, 22), 0.6, 1e-6) << "halfway to 0.2";
  EXPECT_NEAR(ValueAt(*table, 24), 0.2, 1e-6);
  EXPECT_NEAR(ValueAt(*table, 32), 0.1, 1e-6);
  EXPECT_NEAR(ValueAt(*table, 40), 0.0, 1e-6);
}

TEST(UnevenSpeed, OfTheSlowestTheFastestAndOneBeyondIsStillTheBestThere) {
  UnevenSpeed speed;
  const MotionDomain domain = SpeedsTo(2.0, 11);
  for (const auto& [wanted, best] :
       {std::pair{0.0, 0}, {0.05, 0}, {1.85, 9}, {2.0, 10}, {9.0, 10}}) {
    const MotionTable& table = *speed.Around({.speed = wanted, .share = 0.5}, domain);
    EXPECT_FALSE(table.Problem()) << wanted;
    for (int point = 0; point <= 10; ++point) {
      EXPECT_LE(ValueAt(table, point), point == best ? 0.5 : 0.499) << wanted << " " << point;
    }
    EXPECT_NEAR(ValueAt(table, best), 0.5, 1e-6) << wanted;
  }
}

TEST(UnevenSpeed, OfADomainOfOneSpeedIsBestThere) {
  UnevenSpeed speed;
  MotionDomain domain;
  domain.speed = MotionAxis{.low = 1.0, .high = 1.0, .points = 1};
  for (const double wanted : {0.5, 1.0, 2.0}) {
    const MotionTable& table = *speed.Around({.speed = wanted, .share = 0.5}, domain);
    EXPECT_FALSE(table.Problem()) << wanted;
    EXPECT_NEAR(ValueAt(table, 0), 0.5, 1e-6) << wanted;
  }
}

TEST(UnevenSpeed, HasNoSayWhereNoSpeedIsDecided) {
  MotionDomain domain = SpeedsTo(2.0, 11);
  domain.speed.reset();
  EXPECT_EQ(UnevenSpeed().Around({.speed = 1.0}, domain), nullptr);
}

}  // namespace
}  // namespace limpet
