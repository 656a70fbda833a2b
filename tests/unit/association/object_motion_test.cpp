// SPDX-License-Identifier: MIT
#include "estimation/association/object_motion.hpp"

#include <gtest/gtest.h>

#include "tests/support/object_flight.hpp"

namespace limpet {
namespace {

class ObjectMotionTest : public ::testing::Test, protected ObjectFlight {
 protected:
  ObjectMotionTest() { objects_ = {{5.0, 0.5, 6.5}}; }
  void FlyBy(double east) {
    FlyTo({10.0, east});
    FlyTo({0.0, east});
  }
};

TEST_F(ObjectMotionTest, AnObjectThatSwaysIsKnownToMoveAndIsStillOne) {
  sway_W_ = {0.2, 0.3, 0.0};
  for (const double east : {0.0, 0.7, 1.2})
    FlyBy(east);
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_GT(Found()[0].motion_sd, 0.1);
  EXPECT_LT(Found()[0].motion_sd, 0.4);
  EXPECT_LT((Found()[0].p_W - objects_[0]).norm(), 0.3);
}

TEST_F(ObjectMotionTest, AnObjectThatStandsStillIsNotTakenForOneThatMoves) {
  noise_px_ = 6.0;
  false_share_ = 0.2;
  for (const double east : {0.0, 0.7, 1.2})
    FlyBy(east);
  ASSERT_GE(Found().size(), 1U);
  for (const TrackedObject& object : Found())
    EXPECT_EQ(object.motion_sd, 0.0);
}

TEST_F(ObjectMotionTest, AnObjectThatStandsElsewhereAtTheNextPassIsOneThatMoves) {
  FlyBy(0.0);
  time_ += 60.0;
  objects_[0] += Eigen::Vector3d(0.3, 0.7, 0.0);
  FlyBy(0.5);
  FlyBy(0.8);
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_GT(Found()[0].motion_sd, 0.2);
}

TEST_F(ObjectMotionTest, TwoObjectsThatAreSeenTogetherAreTwo) {
  objects_.emplace_back(5.0, 1.6, 6.5);
  for (const double east : {0.0, 0.7, 1.2})
    FlyBy(east);
  ASSERT_EQ(Found().size(), 2U);
  EXPECT_EQ(Found()[0].motion_sd + Found()[1].motion_sd, 0.0);
}

TEST_F(ObjectMotionTest, WhatMovesHoldsTheVehicleLessThanWhatStands) {
  BoxReading exact;
  exact.centre_px = {320.0, 240.0};
  exact.sigma_px = {3.0, 4.0};
  EXPECT_EQ(OfMeanPlace(exact, 0.0, camera_, 0.5).sigma_px, exact.sigma_px);
  const BoxReading of_mean = OfMeanPlace(exact, 0.3, camera_, 0.0);
  EXPECT_GT(of_mean.sigma_px.minCoeff(), 0.09 * camera_.fx);
  EXPECT_EQ(of_mean.centre_px, exact.centre_px);
}

}  // namespace
}  // namespace limpet
