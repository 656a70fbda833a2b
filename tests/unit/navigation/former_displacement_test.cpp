// SPDX-License-Identifier: MIT
#include "estimation/navigation/former_displacement.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace limpet {
namespace {

const std::vector<Eigen::Vector2d> kFivePlaces{
    {4.0, 1.0}, {2.0, 10.0}, {6.0, -3.0}, {-6.0, -5.0}, {-3.0, 7.0}};

std::vector<ObjectEstimate> ObjectsOf(const std::vector<Eigen::Vector2d>& places, double sigma) {
  std::vector<ObjectEstimate> objects;
  for (const Eigen::Vector2d& p : places) {
    objects.push_back({.p_W = {p.x(), p.y(), 6.0},
                       .cov_W = sigma * sigma * Eigen::Matrix3d::Identity(),
                       .color = "yellow"});
  }
  return objects;
}

/// Five objects of which the first has been moved, all matched; each place known to `sigma` [m].
struct TwoSessions {
  std::vector<ObjectEstimate> former, now;
  MatchingParams params{};
  SessionMatch match{};
  std::vector<double> chances;
};

TwoSessions CompareTwo(const Eigen::Vector2d& move, double sigma, std::size_t objects = 5,
                       const Eigen::Vector2d& shift = {0.3, -0.4}) {
  std::vector<Eigen::Vector2d> places(kFivePlaces.begin(),
                                      kFivePlaces.begin() + static_cast<std::ptrdiff_t>(objects));
  TwoSessions two{.former = ObjectsOf(places, sigma), .now = {}, .chances = {}};
  places.front() += move;
  for (Eigen::Vector2d& place : places)
    place += shift;
  two.now = ObjectsOf(places, sigma);
  FormerMatches all(objects);
  for (std::size_t i = 0; i < objects; ++i)
    all[i] = static_cast<int>(i);
  const Eigen::Matrix4d prior = OffsetPrior(two.params);
  two.match = FitSessions(two.former, two.now, all, two.params, prior);
  two.chances = ChancesOfSamePlace(two.former, two.now, two.params, prior, two.match);
  return two;
}

TEST(FormerDisplacement, WhatStandsWhereItStoodIsTheSame) {
  for (const double chance : CompareTwo({0.0, 0.0}, 0.1).chances)
    EXPECT_GT(chance, 0.99);
}

TEST(FormerDisplacement, AnotherColourMakesItLessSureAndFarOffAnotherObject) {
  const auto chance_at = [](double north, bool is_of_another_color) {
    TwoSessions two{.former = ObjectsOf(kFivePlaces, 0.2), .now = {}, .chances = {}};
    two.now = two.former;
    two.now.front().p_W.x() += north;
    if (is_of_another_color) two.now.front().color = "red";
    const Eigen::Matrix4d prior = OffsetPrior(two.params);
    two.match = FitSessions(two.former, two.now, {0, 1, 2, 3, 4}, two.params, prior);
    return ChancesOfSamePlace(two.former, two.now, two.params, prior, two.match).front();
  };
  EXPECT_GT(chance_at(0.05, false), 0.98);
  EXPECT_LT(chance_at(0.05, true), chance_at(0.05, false));
  EXPECT_GT(chance_at(0.05, true), 0.9);
  EXPECT_LT(chance_at(0.9, true), chance_at(0.9, false));
}

TEST(FormerDisplacement, AMoveShowsWherePlacesAreKnown) {
  const TwoSessions two = CompareTwo({1.3, 0.0}, 0.1);
  EXPECT_LT(two.chances.front(), 0.1);
  for (std::size_t i = 1; i < two.chances.size(); ++i)
    EXPECT_GT(two.chances[i], 0.98) << i;
}

TEST(FormerDisplacement, WhatMayHaveMovedOrNotIsNeither) {
  const double chance = CompareTwo({0.0, 0.9}, 0.2).chances.front();
  EXPECT_GT(chance, 0.1);
  EXPECT_LT(chance, 0.9);
}

TEST(FormerDisplacement, WhereNothingIsKnownWellAMoveIsNotSeen) {
  EXPECT_GT(CompareTwo({0.5, 0.0}, 0.5).chances.front(), 0.9);
}

TEST(FormerDisplacement, WhatMovedDoesNotPullTheFrame) {
  const TwoSessions two = CompareTwo({0.0, 1.2}, 0.1);
  EXPECT_NEAR(two.match.offset.Apply(two.former[1].p_W).y(), two.now[1].p_W.y(), 0.03);
}

TEST(FormerDisplacement, AloneItIsJudgedByTheFramesPriorsOnly) {
  // Offset by half a metre, and fixes of two sessions differ by 0.6 m: no sign of a move.
  EXPECT_GT(CompareTwo({0.0, 0.0}, 0.1, 1, {0.4, 0.3}).chances.front(), 0.8);
}

TEST(FormerDisplacement, OfTwoObjectsNobodyKnowsWhichOneMoved) {
  const std::vector<double> chances = CompareTwo({0.9, 0.0}, 0.1, 2, {0.0, 0.0}).chances;
  EXPECT_LT(chances[0], 0.9);
  EXPECT_GT(chances[0], 0.02);
}

/// The course of the move must not matter, its length does.
TEST(FormerDisplacement, GrowsWithTheDistanceWhateverTheCourse) {
  for (double course = 0.0; course < 6.0; course += 0.7) {
    const Eigen::Vector2d ahead = Eigen::Rotation2Dd(course) * Eigen::Vector2d(1.0, 0.0);
    double before = 1.0;
    for (double distance = 0.0; distance < 1.5; distance += 0.1) {
      const double chance = CompareTwo(distance * ahead, 0.15).chances.front();
      EXPECT_LE(chance, before + 1e-9) << distance << " m";
      EXPECT_GE(chance, 0.0);
      before = chance;
    }
    EXPECT_LT(before, 0.1);
  }
}

/// Five objects, each place known to 0.1 m; the first went down, and all seem deeper by `all`.
TwoSessions CompareInDepth(double first, double all, double sigma = 0.1) {
  TwoSessions two{.former = ObjectsOf(kFivePlaces, sigma), .now = {}, .chances = {}};
  two.now = two.former;
  two.now.front().p_W.z() += first;
  for (ObjectEstimate& object : two.now)
    object.p_W.z() += all;
  const Eigen::Matrix4d prior = OffsetPrior(two.params);
  two.match = FitSessions(two.former, two.now, {0, 1, 2, 3, 4}, two.params, prior);
  two.chances = ChancesOfSamePlace(two.former, two.now, two.params, prior, two.match);
  return two;
}

TEST(FormerDisplacement, AMoveInDepthAloneIsNotCalledTheSamePlace) {
  for (const double down : {0.6, -0.6}) {
    EXPECT_LT(CompareInDepth(down, 0.0).chances[0], 0.9) << down;
    EXPECT_LT(CompareInDepth(1.5 * down, 0.0).chances[0], 0.1) << down;
    EXPECT_LT(CompareInDepth(down, 0.0, 0.03).chances[0], 0.3) << down;
    for (std::size_t i = 1; i < 5; ++i)
      EXPECT_GT(CompareInDepth(down, 0.0).chances[i], 0.97) << down;
  }
}

TEST(FormerDisplacement, AnotherTideOrDepthSensorMovesNothing) {
  for (const double all : {0.1, -0.3, 0.5}) {
    for (const double chance : CompareInDepth(0.0, all).chances)
      EXPECT_GT(chance, 0.97) << all;
    EXPECT_LT(CompareInDepth(0.7, all).chances[0], 0.9) << all;
  }
}

TEST(FormerDisplacement, ADepthThatIsKnownBadlyIsNoMove) {
  TwoSessions two = CompareInDepth(0.0, 0.0);
  two.now[0].p_W.z() += 0.6;
  two.now[0].cov_W(2, 2) = 0.25;
  const Eigen::Matrix4d prior = OffsetPrior(two.params);
  two.match = FitSessions(two.former, two.now, {0, 1, 2, 3, 4}, two.params, prior);
  EXPECT_GT(ChancesOfSamePlace(two.former, two.now, two.params, prior, two.match)[0], 0.95);
}

TEST(FormerDisplacement, UnmatchedObjectsAreLeftAlone) {
  TwoSessions two = CompareTwo({0.0, 0.0}, 0.1);
  two.match.now_of_former = {std::nullopt, 1, std::nullopt, 3, std::nullopt};
  const auto chances =
      ChancesOfSamePlace(two.former, two.now, two.params, OffsetPrior(two.params), two.match);
  EXPECT_EQ(chances[0], 1.0);
  EXPECT_GT(chances[1], 0.9);
  EXPECT_EQ(chances[4], 1.0);
}

}  // namespace
}  // namespace limpet
