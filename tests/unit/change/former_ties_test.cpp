// SPDX-License-Identifier: MIT
#include "estimation/change/former_ties.hpp"

#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

ObjectEstimate Buoy(double north, double east) {
  return {.p_W = {north, east, 6.0}, .cov_W = 0.01 * Eigen::Matrix3d::Identity(), .color = "red"};
}

/// Former objects 11 and 12, four metres apart.
class FormerTiesTest : public ::testing::Test {
 protected:
  FormerTies ties_{{{.id = 11, .object = Buoy(0.0, 0.0)}, {.id = 12, .object = Buoy(4.0, 0.0)}},
                   MatchingParams{}};
};

TEST_F(FormerTiesTest, DecidedMatchesTellWhereTheFormerFrameLies) {
  ties_.Take({{.id = 1, .object = Buoy(0.5, 0.2), .former = {.id = 11}},
              {.id = 2, .object = Buoy(4.5, 0.2), .former = {.id = 12}}});
  EXPECT_EQ(ties_.NowOf(0), 0U);
  EXPECT_EQ(ties_.NowOf(1), 1U);
  EXPECT_EQ(ties_.SumOfFormer(0), 1.0);
  const ObjectEstimate now = ties_.PlaceNow(1);
  EXPECT_NEAR((now.p_W - Eigen::Vector3d(4.5, 0.2, 6.0)).norm(), 0.0, 0.1);
  EXPECT_NEAR((ties_.PlaceThen(now).p_W - Buoy(4.0, 0.0).p_W).norm(), 0.0, 1e-9);
}

TEST_F(FormerTiesTest, AnUndecidedMatchHasChancesAndDoesNotMoveTheFrame) {
  ties_.Take({{.id = 1,
               .object = Buoy(1.9, 0.0),
               .former = {.id = 12, .candidates = {{11, 0.3}, {12, 0.5}, {99, 0.1}}}}});
  EXPECT_EQ(ties_.Chance(0, 0), 0.3);
  EXPECT_EQ(ties_.Chance(1, 0), 0.5);
  EXPECT_EQ(ties_.SumOfObject(0), 0.8);  // 99 is of another session
  EXPECT_EQ(ties_.NowOf(0), std::nullopt);
  EXPECT_EQ(ties_.NowOf(1), 0U);
  EXPECT_TRUE(ties_.StandsForFormer(0));
  EXPECT_EQ(ties_.PlaceNow(0).p_W, Buoy(0.0, 0.0).p_W);
}

TEST_F(FormerTiesTest, WhatIsUnknownOfTheFrameIsInAFormerPlace) {
  ties_.Take({});
  const double unmatched = ties_.PlaceNow(0).cov_W(0, 0);
  ties_.Take({{.id = 1, .object = Buoy(0.0, 0.0), .former = {.id = 11}}});
  EXPECT_LT(ties_.PlaceNow(0).cov_W(0, 0), 0.3 * unmatched);
  EXPECT_FALSE(ties_.NowOf(1).has_value());
}

}  // namespace
}  // namespace limpet
