// SPDX-License-Identifier: MIT
#include "estimation/association/object_sizes.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

class ObjectSizesTest : public ::testing::Test {
 protected:
  ObjectSizesTest() {
    smoother_.AddNode(NavVector::Zero(), std::nullopt);
    smoother_.AddTerm(0,
                      Term::OnPose(PosePriorFactor(NavVector::Zero(), NavVector::Constant(0.1))));
  }
  /// As if boxes had shown these logarithms, to within `sigma`.
  void Show(int slot, const Eigen::Vector3d& log_sizes, double sigma) {
    smoother_.AddBorderTerm(
        slot, Term::OnBorder(
                  BorderPriorFactor(log_sizes, sigma * sigma * Eigen::Matrix3d::Identity()), slot));
  }
  ArrowSmoother smoother_;
};

TEST_F(ObjectSizesTest, AreNoneWhereAllObjectsAreAlike) {
  ObjectSizes sizes(0.0, smoother_);
  EXPECT_FALSE(sizes.Take(0.0));
  EXPECT_EQ(smoother_.graph().slot_count(), 0);
}

TEST_F(ObjectSizesTest, ShareAVariableByThreesAndKeepTheirBelievedShare) {
  ObjectSizes sizes(0.2, smoother_);
  std::vector<SizeSlot> taken;
  for (int i = 0; i < 7; ++i)
    taken.push_back(*sizes.Take(0.1 * i));
  smoother_.Update();
  EXPECT_EQ(smoother_.graph().slot_count(), 3);
  for (int i = 0; i < 7; ++i) {
    const SizeSlot& size = taken[static_cast<std::size_t>(i)];
    EXPECT_EQ(size.index, i % 3);
    EXPECT_EQ(size.slot, taken[static_cast<std::size_t>(i - i % 3)].slot);
    EXPECT_NEAR(sizes.LogSizeAt(size), 0.1 * i, 1e-9) << "nothing was seen of it yet";
    EXPECT_NEAR(std::sqrt(sizes.VarianceOf(size)), 0.2, 1e-6);
  }
}

TEST_F(ObjectSizesTest, WhatIsSeenOfOneIsNotTakenForAnother) {
  ObjectSizes sizes(0.2, smoother_);
  const SizeSlot a = *sizes.Take(0.0), b = *sizes.Take(0.0);
  smoother_.AddBorderTerm(
      a.slot, Term::OnBorder(
                  BorderPriorFactor({0.1, 0.0, 0.0}, Eigen::Vector3d(1e-6, 1e6, 1e6).asDiagonal()),
                  a.slot));
  smoother_.Update();
  EXPECT_NEAR(sizes.LogSizeAt(a), 0.1, 1e-3);
  EXPECT_NEAR(sizes.LogSizeAt(b), 0.0, 1e-6);
  EXPECT_LT(sizes.VarianceOf(a), 1e-4);
  EXPECT_NEAR(sizes.VarianceOf(b), 0.04, 1e-4);
}

TEST_F(ObjectSizesTest, AManyTimesLargerOneIsBelievedWhenItIsSeen) {
  ObjectSizes sizes(0.2, smoother_);
  const SizeSlot size = *sizes.Take(0.0);
  Show(size.slot, {1.2, 0.0, 0.0}, 0.05);
  smoother_.Converge();
  EXPECT_GT(sizes.LogSizeAt(size), 1.1) << "six sigmas of what was believed";
}

TEST_F(ObjectSizesTest, TheSpreadIsLearntFromThoseSeen) {
  Random random(5);
  for (const double truth : {0.03, 0.5}) {
    ArrowSmoother smoother;
    smoother.AddNode(NavVector::Zero(), std::nullopt);
    smoother.AddTerm(0, Term::OnPose(PosePriorFactor(NavVector::Zero(), NavVector::Constant(0.1))));
    ObjectSizes sizes(0.2, smoother);
    std::vector<SizeSlot> seen;
    for (int i = 0; i < 30; ++i) {
      seen.push_back(*sizes.Take(0.0));
      if (i % 3 != 2) continue;
      const Eigen::Vector3d shown(random.Normal(truth), random.Normal(truth), random.Normal(truth));
      smoother.AddBorderTerm(
          seen.back().slot,
          Term::OnBorder(BorderPriorFactor(shown, 1e-6 * Eigen::Matrix3d::Identity()),
                         seen.back().slot));
    }
    smoother.Converge();
    sizes.Learn(seen);
    // Four objects' worth of the stated spread stay.
    const double expected = std::sqrt((4.0 * 0.04 + 30.0 * truth * truth) / 34.0);
    EXPECT_NEAR(sizes.spread() / expected, 1.0, 0.25) << truth;
  }
}

TEST_F(ObjectSizesTest, AsManyAsBeforeTeachNothingNew) {
  ObjectSizes sizes(0.2, smoother_);
  const std::vector<SizeSlot> seen{*sizes.Take(0.0)};
  Show(seen[0].slot, {0.6, 0.0, 0.0}, 0.01);
  smoother_.Converge();
  sizes.Learn(seen);
  const double once = sizes.spread();
  EXPECT_GT(once, 0.2);
  sizes.Learn(seen);
  EXPECT_EQ(sizes.spread(), once);
}

}  // namespace
}  // namespace limpet
