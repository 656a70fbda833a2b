// SPDX-License-Identifier: MIT
#include "estimation/matching/move_hypotheses.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

Displacement Apart(double north, double down, double sigma = 0.1) {
  return {.off_W = {north, 0.0, down}, .cov_W = sigma * sigma * Eigen::Matrix3d::Identity()};
}

double ChanceStayed(const Displacement& displacement) {
  const MoveHypotheses h = WeighMoves(displacement, 2.5);
  return h.stayed / (h.stayed + h.moved + h.replaced);
}

TEST(MoveHypotheses, WhatIsWhereItWasHasStayed) { EXPECT_GT(ChanceStayed(Apart(0.0, 0.0)), 0.99); }

TEST(MoveHypotheses, AMoveOverTheGroundOrInDepthAloneShows) {
  EXPECT_LT(ChanceStayed(Apart(0.8, 0.0)), 0.05);
  EXPECT_LT(ChanceStayed(Apart(0.0, 0.8)), 0.05);
  EXPECT_LT(ChanceStayed(Apart(0.0, -0.8)), 0.05);
}

TEST(MoveHypotheses, WhereDepthsAreKnownBadlyTheyTellNothing) {
  Displacement apart = Apart(0.0, 0.6);
  apart.cov_W(2, 2) = 0.36;
  EXPECT_GT(ChanceStayed(apart), 0.95);
}

TEST(MoveHypotheses, WhatIsTooFarApartForAnyOfThemHasNotMoved) {
  ObjectEstimate here, far;
  here.cov_W = far.cov_W = 0.01 * Eigen::Matrix3d::Identity();
  far.p_W.z() = 100.0;
  EXPECT_EQ(ChanceMoved(here, far, 2.5), 0.0) << "no 0 by 0";
}

TEST(MoveHypotheses, AreDensities) {
  // Summed over a box wider than all moves; what replaces it may be anywhere.
  constexpr double kStep = 0.1;
  double stayed = 0.0, moved = 0.0;
  const auto add = [&](double north, double east, double down) {
    Displacement apart = Apart(north, down, 0.2);
    apart.off_W.y() = east;
    const MoveHypotheses h = WeighMoves(apart, 2.5);
    stayed += h.stayed * std::pow(kStep, 3), moved += h.moved * std::pow(kStep, 3);
  };
  constexpr int kHalf = 32;  // steps
  for (int i = -kHalf; i <= kHalf; ++i) {
    for (int j = -kHalf; j <= kHalf; ++j) {
      for (int k = -kHalf; k <= kHalf; ++k) {
        add(kStep * i, kStep * j, kStep * k);
      }
    }
  }
  EXPECT_NEAR(stayed, 0.86, 0.01);
  EXPECT_NEAR(moved, 0.14, 0.004);
}

TEST(ChanceMoved, FallsWithTheDistanceToNothingBeyondItsReach) {
  ObjectEstimate former{.cov_W = 0.02 * Eigen::Matrix3d::Identity(), .color = "yellow"};
  double before = 1.0;
  for (const double distance : {0.8, 1.4, 2.0, 2.6, 3.4}) {
    ObjectEstimate now = former;
    now.p_W.x() += distance;
    const double chance = ChanceMoved(former, now, 2.5);
    EXPECT_LT(chance, before) << distance;
    before = chance;
  }
  EXPECT_LT(before, 0.05);
}

}  // namespace
}  // namespace limpet
