// SPDX-License-Identifier: MIT
#include "apps/LimpetDB/wall_clock_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/record.hpp"
#include "limpet/topics/wall_clock.hpp"

namespace limpet {
namespace {

constexpr Seconds kWatchStart(1.8e9);

TEST(WallClockWatch, SaysTheClocksNowAndThen) {
  WallClockWatch watch;
  const auto first = watch.Look(kWatchStart, kWatchStart + Seconds(0.1));
  ASSERT_TRUE(first.has_value());
  EXPECT_FALSE(first->warning.has_value());
  const auto record = DecodeRecord<WallClock>(first->record);
  ASSERT_TRUE(record.has_value());
  EXPECT_NEAR(record->ahead, 0.1, 1e-6);
  EXPECT_EQ(record->steps, 0);
  EXPECT_FALSE(watch.Look(kWatchStart + Seconds(1.0), kWatchStart + Seconds(1.1)).has_value());
  EXPECT_TRUE(watch.Look(kWatchStart + Seconds(61.0), kWatchStart + Seconds(61.1)).has_value());
}

TEST(WallClockWatch, WarnsOfAStepWithItsSizeUntilItIsUndone) {
  WallClockWatch watch;
  static_cast<void>(watch.Look(kWatchStart, kWatchStart));
  const auto stepped = watch.Look(kWatchStart + Seconds(1.0), kWatchStart - Seconds(9.0));
  ASSERT_TRUE(stepped && stepped->warning);
  EXPECT_THAT(*stepped->warning, testing::HasSubstr("-10.0 s"));
  EXPECT_EQ(DecodeRecord<WallClock>(stepped->record)->steps, 1);
  EXPECT_FALSE(watch.Look(kWatchStart + Seconds(2.0), kWatchStart - Seconds(8.0)).has_value());
  const auto undone = watch.Look(kWatchStart + Seconds(3.0), kWatchStart + Seconds(3.0));
  ASSERT_TRUE(undone.has_value());
  EXPECT_FALSE(undone->warning.has_value());
}

}  // namespace
}  // namespace limpet
