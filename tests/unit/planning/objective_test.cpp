// SPDX-License-Identifier: MIT
#include "limpet/planning/objective.hpp"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/planning/scene.hpp"

namespace limpet {
namespace {

Target DrawTarget(Random& random) {
  return {.north = random.Uniform(-10.0, 10.0),
          .east = random.Uniform(-10.0, 10.0),
          .window = {random.Uniform(0.3, 2.0), random.Uniform(0.3, 3.0)},
          .value = random.Uniform(0.5, 20.0)};
}

class ObjectiveProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "objective"};
};

TEST_P(ObjectiveProperties, ATargetIsSeenFromWhereItLiesInItsWindow) {
  for (int i = 0; i < 200; ++i) {
    const Target target = DrawTarget(random_);
    const double yaw = random_.Uniform(-3.1, 3.1);
    const double ahead = random_.Uniform(-1.5, 1.5) * target.window.half_along;
    const double abeam = random_.Uniform(-1.5, 1.5) * target.window.half_across;
    const Pose2 pose{target.north - ahead * std::cos(yaw) + abeam * std::sin(yaw),
                     target.east - ahead * std::sin(yaw) - abeam * std::cos(yaw), yaw};
    EXPECT_EQ(target.IsSeenFrom(pose), std::abs(ahead) <= target.window.half_along &&
                                           std::abs(abeam) <= target.window.half_across);
  }
}

TEST_P(ObjectiveProperties, ALookIsWorthLessTheLaterItComesAndNeverLessThanNothing) {
  for (int i = 0; i < 50; ++i) {
    const Target target = DrawTarget(random_);
    const double decay = random_.Uniform(20.0, 300.0), at = random_.Uniform(0.0, 400.0);
    EXPECT_NEAR(target.WorthAt(0.0, Meters(decay)), target.value, 1e-12);
    EXPECT_NEAR(target.WorthAt(0.5 * decay, Meters(decay)), 0.5 * target.value, 1e-12);
    EXPECT_EQ(target.WorthAt(decay, Meters(decay)), 0.0);
    EXPECT_GE(target.WorthAt(at, Meters(decay)), target.WorthAt(at + 1.0, Meters(decay)));
    EXPECT_GE(target.WorthAt(at, Meters(decay)), 0.0);
  }
}

TEST_P(ObjectiveProperties, TheFirstLookIsWhereTheWindowIsEntered) {
  for (int i = 0; i < 50; ++i) {
    Target target = DrawTarget(random_);
    target.north = random_.Uniform(5.0, 15.0);
    target.east = random_.Uniform(-0.9, 0.9) * target.window.half_across;
    const DubinsPath north({0.0, 0.0, 0.0}, {{0.0, 30.0}});
    const auto first = FirstLook(north, target);
    ASSERT_TRUE(first);
    // Sampled every quarter of a metre.
    EXPECT_NEAR(*first, target.north - target.window.half_along, 0.26);
    EXPECT_FALSE(FirstLook(DubinsPath({0.0, 0.0, M_PI}, {{0.0, 30.0}}), target));
  }
}

TEST_P(ObjectiveProperties, TargetsOfAPathAddUp) {
  Objective one, other, both;
  one.targets = {DrawTarget(random_), DrawTarget(random_)};
  other.targets = {DrawTarget(random_)};
  both.targets = {one.targets[0], other.targets[0], one.targets[1]};
  const DubinsPath path({-8.0, -8.0, 0.8}, {{0.0, 12.0}, {1.0 / 3.0, 8.0}, {-1.0 / 3.0, 9.0}});
  EXPECT_NEAR(TargetValueOf(path, both), TargetValueOf(path, one) + TargetValueOf(path, other),
              1e-9);
}

TEST_P(ObjectiveProperties, LengthCostsAMetreForAMetreWhereNothingIsSought) {
  SurveyGrid grid(scene::kArea);
  Ground ground(grid, scene::TableFootprint());
  SeenAlong seen(ground);
  const Objective nothing;
  const double length = random_.Uniform(1.0, 20.0);
  const DubinsPath path({0.0, 0.0, random_.Uniform(-3.0, 3.0)}, {{0.0, length}});
  EXPECT_NEAR(ValueOf(path, nothing, ground, seen), -length, 1e-9);
  EXPECT_FALSE(nothing.SeeksAnything());
}

TEST_P(ObjectiveProperties, NewGroundIsCountedInMetresOfFullyUsefulTrack) {
  GroundRates rates{.cover = random_.Uniform(0.5, 2.0), .frontier = random_.Uniform(0.0, 1.0)};
  const NewlySeen seen{.new_area = random_.Uniform(0.0, 50.0),
                       .frontier_growth = random_.Uniform(-10.0, 10.0)};
  const double swath = random_.Uniform(1.0, 8.0);
  const GroundWorth worth = rates.Of(seen, swath);
  EXPECT_NEAR(worth.useful * swath, rates.cover * seen.new_area, 1e-9);
  EXPECT_NEAR(worth.ragged, rates.frontier * seen.frontier_growth, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Drawn, ObjectiveProperties, ::testing::Range(1, 9));

TEST(Objective, SeeksTargetsOrTermsEvenWhereGroundIsWorthNothing) {
  Objective objective;
  EXPECT_FALSE(objective.SeeksAnything());
  objective.ground.cover = 1.0;
  EXPECT_TRUE(objective.SeeksAnything());
  objective.ground = {};
  objective.targets.push_back({});
  EXPECT_TRUE(objective.SeeksAnything());
}

}  // namespace
}  // namespace limpet
