// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "limpet/helm/revisit_policy.hpp"

namespace limpet {
namespace {

constexpr double kDetection = 0.95;
constexpr double kFalseAlarm = 0.01;

TEST(ValueOfALook, IsNothingWhenTheStatusIsKnown) {
  EXPECT_DOUBLE_EQ(ExpectedEntropyDrop({.confirmed = 1.0}, kDetection, kFalseAlarm), 0.0);
}

TEST(ValueOfALook, IsGreatestWhenConfirmedAndRemovedAreEquallyLikely) {
  const double even =
      ExpectedEntropyDrop({.confirmed = 0.5, .removed = 0.5}, kDetection, kFalseAlarm);
  const double skewed =
      ExpectedEntropyDrop({.confirmed = 0.9, .removed = 0.1}, kDetection, kFalseAlarm);
  EXPECT_GT(even, skewed);
  EXPECT_GT(even, 0.5);  // a good detector resolves most of ln 2
}

TEST(ValueOfALook, CannotTellNewFromConfirmed) {
  EXPECT_NEAR(ExpectedEntropyDrop({.confirmed = 0.5, .appeared = 0.5}, kDetection, kFalseAlarm),
              0.0, 1e-12);
}

TEST(ValueOfALook, IsLessWithAWorseDetector) {
  const StatusPosterior even{.confirmed = 0.5, .removed = 0.5};
  EXPECT_GT(ExpectedEntropyDrop(even, 0.95, 0.01), ExpectedEntropyDrop(even, 0.7, 0.2));
}

}  // namespace
}  // namespace limpet
