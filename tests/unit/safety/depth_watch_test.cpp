// SPDX-License-Identifier: MIT
#include "limpet/safety/depth_watch.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

class DepthWatchTest : public testing::Test {
 protected:
  /// A second in which `wanted` is said and `depth` measured.
  void Second(double wanted, double depth) {
    now_ += Seconds(1.0);
    watch_.Want(wanted, now_);
    watch_.Hear(depth, now_);
  }
  DepthWatch watch_;
  Seconds now_{1000.0};
};

TEST_F(DepthWatchTest, CountsTheTimeInWhichTheVehicleComesNoNearer) {
  for (int i = 0; i <= 30; ++i)
    Second(6.0, 0.1);
  EXPECT_DOUBLE_EQ(watch_.lacking_for().value(), 30.0);
  for (int i = 0; i < 20; ++i)
    Second(6.0, 0.1 + 0.2 * (i % 2));  // waves
  EXPECT_DOUBLE_EQ(watch_.lacking_for().value(), 50.0);
}

TEST_F(DepthWatchTest, CountsAlsoWhileItIsCarriedTheOtherWay) {
  for (int i = 0; i <= 30; ++i)
    Second(6.0, 4.0 - 0.1 * i);
  EXPECT_DOUBLE_EQ(watch_.lacking_for().value(), 30.0);
}

TEST_F(DepthWatchTest, BeginsAnewWithEachProgress) {
  for (int i = 0; i <= 100; ++i)
    Second(6.0, 0.04 * i);  // slowly, but down it goes
  EXPECT_LT(watch_.lacking_for().value(), 10.0);
}

TEST_F(DepthWatchTest, IsContentNearTheDepthThatIsWanted) {
  for (int i = 0; i <= 100; ++i)
    Second(6.0, 5.2);
  EXPECT_DOUBLE_EQ(watch_.lacking_for().value(), 0.0);
}

TEST_F(DepthWatchTest, BeginsAnewWhereAnotherDepthIsWanted) {
  for (int i = 0; i <= 30; ++i)
    Second(6.0, 3.0);
  Second(0.0, 3.0);
  EXPECT_DOUBLE_EQ(watch_.lacking_for().value(), 0.0);
}

TEST_F(DepthWatchTest, BeginsAnewAfterAnExcuse) {
  for (int i = 0; i <= 30; ++i)
    Second(6.0, 3.0);
  watch_.Excuse();
  Second(6.0, 3.0);
  EXPECT_DOUBLE_EQ(watch_.lacking_for().value(), 0.0);
}

TEST_F(DepthWatchTest, KnowsNothingWhereNoDepthIsWanted) {
  watch_.Hear(3.0, now_);
  EXPECT_FALSE(watch_.lacking_for());
  Second(6.0, 3.0);
  EXPECT_TRUE(watch_.lacking_for());
  now_ += Seconds(3.0);
  watch_.Hear(3.0, now_);
  EXPECT_FALSE(watch_.lacking_for());
}

}  // namespace
}  // namespace limpet
