// SPDX-License-Identifier: MIT
#include "limpet/helm/rate_of_closure.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "limpet/core/units.hpp"

namespace limpet {
namespace {

MotionDomain Field() {
  MotionDomain domain;
  domain.speed = MotionAxis{.low = 0.0, .high = 4.0, .points = 41};
  return domain;
}

/// At so many degrees and tenths of a metre a second.
double At(const MotionTable& table, int degrees, int tenths) {
  const std::size_t point =
      static_cast<std::size_t>(degrees) * table.stride(MotionVariable::kCourse) +
      static_cast<std::size_t>(tenths) * table.stride(MotionVariable::kSpeed);
  return static_cast<double>(table.values()[point]);
}

TEST(RateOfClosure, IsBestStraightAtThePlaceAtTheWantedSpeed) {
  RateOfClosure closure;
  const MotionTable* table =
      closure.Toward({.bearing = RadiansFromDegrees(90.0), .speed = 2.0}, Field());
  ASSERT_NE(table, nullptr);
  EXPECT_FALSE(table->Problem());
  EXPECT_NEAR(At(*table, 90, 20), 1.0, 1e-6);
  EXPECT_NEAR(*std::ranges::min_element(table->values()), 0.0F, 1e-6F);
  EXPECT_NEAR(At(*table, 270, 40), 0.0, 1e-6) << "away, at full speed";
}

TEST(RateOfClosure, MindsSlowTwiceAsMuchAsFast) {
  RateOfClosure closure;
  const MotionTable& table =
      *closure.Toward({.bearing = RadiansFromDegrees(90.0), .speed = 2.0}, Field());
  const double slow = 1.0 - At(table, 90, 10), fast = 1.0 - At(table, 90, 30);
  EXPECT_NEAR(slow, 2.0 * fast, 1e-6);
}

TEST(RateOfClosure, WouldRatherCreepThanGoAsideFast) {
  RateOfClosure closure;
  const MotionTable& table =
      *closure.Toward({.bearing = RadiansFromDegrees(90.0), .speed = 2.0}, Field());
  EXPECT_GT(At(table, 180, 2), At(table, 180, 20));
  EXPECT_NEAR(At(table, 120, 20), At(table, 60, 20), 1e-6) << "both sides are as good";
}

TEST(RateOfClosure, HasNoSayWhereTheHelmDecidesNoSpeed) {
  MotionDomain domain;
  domain.speed.reset();
  RateOfClosure closure;
  EXPECT_EQ(closure.Toward({.bearing = 0.0, .speed = 1.0}, domain), nullptr);
}

}  // namespace
}  // namespace limpet
