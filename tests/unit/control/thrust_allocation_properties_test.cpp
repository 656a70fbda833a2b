// SPDX-License-Identifier: MIT
// What an allocation obeys for any layout, prices and wish.
#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "limpet/control/thrust_allocation.hpp"
#include "limpet/core/random.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {
namespace {

/// Vectored thrusters that stand and point a little elsewhere than as built.
ThrusterLayout DrawLayout(Random& random) {
  ThrusterLayout layout;
  for (Thruster& thruster : layout.thrusters) {
    for (int i = 0; i < 3; ++i)
      thruster.p_B(i) += random.Uniform(-0.03, 0.03);
    for (int i = 0; i < 3; ++i)
      thruster.axis_B(i) += random.Uniform(-0.1, 0.1);
    thruster.axis_B.normalize();
  }
  layout.max_thrust_n = random.Uniform(5.0, 40.0);
  return layout;
}

Wrench DrawWish(Random& random, double scale) {
  Wrench wish;
  wish << random.Normal(scale), random.Normal(scale), random.Normal(scale), 0.0,
      random.Normal(0.1 * scale), random.Normal(0.1 * scale);
  return wish;
}

class ThrustAllocationProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "allocation"};
  const ThrusterLayout layout_ = DrawLayout(random_);
  const ThrustAllocation allocation_{layout_};
};

TEST_P(ThrustAllocationProperties, WhatItSaysItAchievesIsWhatTheThrustersMake) {
  for (int i = 0; i < 100; ++i) {
    const auto result = allocation_.Allocate(DrawWish(random_, random_.Uniform(1.0, 200.0)));
    const Wrench made = layout_.WrenchPerThrust() * (layout_.max_thrust_n * result.command);
    EXPECT_LT((made - result.achieved).norm(), 1e-9 * (1.0 + made.norm()));
    EXPECT_LE(result.command.cwiseAbs().maxCoeff(), 1.0 + 1e-12);
  }
}

TEST_P(ThrustAllocationProperties, SmallWishesAreMetButForRollAndGreatOnesSaidToBeCut) {
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    const Wrench wish = DrawWish(random_, random_.Uniform(0.1, 200.0));
    const auto result = allocation_.Allocate(wish);
    Wrench off = result.achieved - wish;
    off(kRoll) = 0.0;
    EXPECT_EQ(result.is_saturated, off.norm() > 1e-9 * (1.0 + wish.norm()));
    met += result.is_saturated ? 0 : 1;
  }
  EXPECT_GT(met, 5);
  EXPECT_LT(met, 195);
}

TEST_P(ThrustAllocationProperties, YawIsServedAsIfItWereAlone) {
  for (int i = 0; i < 100; ++i) {
    const Wrench wish = DrawWish(random_, 100.0);
    Wrench alone = Wrench::Zero();
    alone(kYaw) = wish(kYaw);
    EXPECT_NEAR(allocation_.Allocate(wish).achieved(kYaw),
                allocation_.Allocate(alone).achieved(kYaw), 1e-9 * (1.0 + std::abs(wish(kYaw))));
  }
}

TEST_P(ThrustAllocationProperties, NothingIsGivenAgainstOrBeyondTheWish) {
  for (int i = 0; i < 100; ++i) {
    const Wrench wish = DrawWish(random_, 100.0);
    const Wrench made = allocation_.Allocate(wish).achieved;
    for (const int axis : {kSurge, kSway, kHeave, kPitch, kYaw}) {
      EXPECT_GE(made(axis) * wish(axis), -1e-6);
      EXPECT_LE(std::abs(made(axis)), std::abs(wish(axis)) + 1e-6);
    }
  }
}

TEST_P(ThrustAllocationProperties, TheDirectionOfTheHorizontalForceIsKept) {
  for (int i = 0; i < 100; ++i) {
    const Wrench wish = DrawWish(random_, 150.0);
    const Wrench made = allocation_.Allocate(wish).achieved;
    const double cross = made(kSurge) * wish(kSway) - made(kSway) * wish(kSurge);
    EXPECT_NEAR(cross, 0.0, 1e-6 * wish.head<2>().squaredNorm());
  }
}

TEST_P(ThrustAllocationProperties, TheOppositeWishIsTheOppositeCommand) {
  for (int i = 0; i < 100; ++i) {
    const Wrench wish = DrawWish(random_, random_.Uniform(1.0, 150.0));
    EXPECT_LT((allocation_.Allocate(wish).command + allocation_.Allocate(-wish).command).norm(),
              1e-9);
  }
}

TEST_P(ThrustAllocationProperties, NoOtherCommandMakesTheSameWithLess) {
  // Add what makes no wrench on the controlled axes: the load can only grow.
  const ThrusterWrenches B = layout_.WrenchPerThrust();
  const std::vector<int> axes{kSurge, kSway, kHeave, kPitch, kYaw};
  const Eigen::MatrixXd rows = B(axes, Eigen::all);
  const Eigen::MatrixXd idle = Eigen::FullPivLU<Eigen::MatrixXd>(rows).kernel();
  for (int i = 0; i < 50; ++i) {
    const auto result = allocation_.Allocate(DrawWish(random_, 1.0));
    for (Eigen::Index k = 0; k < idle.cols(); ++k) {
      const ThrusterVector other = result.command + random_.Normal(0.1) * idle.col(k);
      EXPECT_GE(other.squaredNorm(), result.command.squaredNorm() - 1e-9);
    }
  }
}

TEST_P(ThrustAllocationProperties, ADearThrusterIsNeverUsedMoreForIt) {
  for (int thruster = 0; thruster < kMostThrusters; ++thruster) {
    ThrusterVector price = ThrusterVector::Ones();
    price(thruster) = 20.0;
    const ThrustAllocation sparing(layout_, price);
    const Wrench wish = DrawWish(random_, 1.0);
    EXPECT_LE(std::abs(sparing.Allocate(wish).command(thruster)),
              std::abs(allocation_.Allocate(wish).command(thruster)) + 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Layouts, ThrustAllocationProperties, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet
