// SPDX-License-Identifier: MIT
#include "limpet/simulation/stamp_error.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(StampError, LeavesStampsAloneUnlessToldOtherwise) {
  StampError error({}, Random(1));
  EXPECT_EQ(error.StampOf(Seconds(12.34)), Seconds(12.34));
}

TEST(StampError, DelaysEveryStamp) {
  StampError error({.delay = Seconds(0.25)}, Random(1));
  EXPECT_EQ(error.StampOf(Seconds(1.0)), Seconds(1.25));
}

TEST(StampError, NeverStampsBeforeItsLastStamp) {
  StampError error({.jitter = Seconds(0.1), .late_share = 0.2, .late = Seconds(1.0)}, Random(1));
  Seconds last(-1.0);
  int late = 0;
  for (int i = 0; i < 1000; ++i) {
    const Seconds now(0.05 * i), stamp = error.StampOf(now);
    EXPECT_GE(stamp, last);
    late += stamp - now > Seconds(0.6) ? 1 : 0;
    last = stamp;
  }
  EXPECT_GT(late, 200);  // those that follow a late one wait for it
}

}  // namespace
}  // namespace limpet
