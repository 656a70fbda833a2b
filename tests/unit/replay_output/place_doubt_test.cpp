// SPDX-License-Identifier: MIT
#include "limpet/replay_output/place_doubt.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr double kHigh = 3.0;  // [m]

/// A place a second, each known to these 1-sigmas of an axis [m].
ReplayResult KnownTo(const std::vector<double>& sigmas, bool has_fix = true) {
  ReplayResult result;
  result.has_fix = has_fix;
  for (const double sigma : sigmas) {
    result.online.push_back({.t = static_cast<double>(result.online.size()), .X_WB = {}});
    result.online_covariance_W.emplace_back(sigma * sigma * Eigen::Matrix3d::Identity());
  }
  return result;
}

TEST(PlaceDoubt, ThereIsNoneOfAPlaceThatWasAlwaysKnown) {
  EXPECT_FALSE(WorstDoubt(ReplayResult{}, kHigh));
  EXPECT_FALSE(WorstDoubt(KnownTo({1.0, 2.0, 3.0}), kHigh));
}

TEST(PlaceDoubt, CountsTheTimeAndTellsTheWorst) {
  const auto doubt = WorstDoubt(KnownTo({1.0, 1.0, 4.0, 6.0, 5.0, 1.0, 4.0}), kHigh);
  ASSERT_TRUE(doubt);
  EXPECT_DOUBLE_EQ(doubt->seconds, 4.0);
  EXPECT_DOUBLE_EQ(doubt->sigma, 6.0);
  EXPECT_DOUBLE_EQ(doubt->t, 3.0);
}

TEST(PlaceDoubt, BeforeTheFirstFixNoPlaceIsInDoubt) {
  EXPECT_FALSE(WorstDoubt(KnownTo({50.0, 50.0, 1.0, 1.0}), kHigh));
  EXPECT_TRUE(WorstDoubt(KnownTo({50.0, 50.0, 1.0, 9.0}), kHigh));
}

TEST(PlaceDoubt, WhatTheStartWasTakenForIsNoKnowledge) {
  EXPECT_FALSE(WorstDoubt(KnownTo({1.0, 9.0, 9.0}), kHigh));
}

TEST(PlaceDoubt, AStartThatNothingPlacesDoesNotCount) {
  EXPECT_FALSE(WorstDoubt(KnownTo({10.0, 10.0, 10.4}, false), kHigh));
  const auto doubt = WorstDoubt(KnownTo({10.0, 10.0, 11.0}, false), kHigh);
  ASSERT_TRUE(doubt);
  EXPECT_NEAR(doubt->sigma, 4.58, 0.01) << "what it has lost since";
}

TEST(PlaceDoubt, TheWorseOfNorthAndEastCountsAndDepthDoesNot) {
  ReplayResult result = KnownTo({1.0, 1.0, 1.0});
  result.online_covariance_W[1](2, 2) = 100.0;
  EXPECT_FALSE(WorstDoubt(result, kHigh));
  result.online_covariance_W[2](1, 1) = 100.0;
  EXPECT_TRUE(WorstDoubt(result, kHigh));
}

}  // namespace
}  // namespace limpet
