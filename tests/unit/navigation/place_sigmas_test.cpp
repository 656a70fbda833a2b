// SPDX-License-Identifier: MIT
#include "estimation/navigation/place_sigmas.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"

namespace limpet {
namespace {

constexpr double kStartSigma = 0.5, kStepSigma = 0.02;  // [m]

/// A chain of steps of half a metre whose errors add up, 5 s apart.
struct Walk {
  ArrowSmoother smoother;
  PlaceSigmas places;

  void GoTo(double north, double east) {
    NavVector x = NavVector::Zero();
    x.head<2>() << north, east;
    NavVector sigma = NavVector::Constant(1e-3);
    sigma.head<3>().setConstant(kStartSigma);
    const int node = places.noted();
    if (node == 0) {
      smoother.AddNode(x, std::nullopt);
      smoother.AddTerm(0, Term::OnPose(PosePriorFactor(x, sigma)));
    } else {
      const NavVector before = smoother.PoseAt(node - 1);
      const Eigen::Vector4d step(x(0) - before(0), x(1) - before(1), 0.0, 0.0);
      const Eigen::Vector4d variance(kStepSigma * kStepSigma, kStepSigma * kStepSigma, 1e-6, 1e-10);
      smoother.AddNode(x, Term::OnStep(XyzYawFactor(step, variance)));
      NavVector level = NavVector::Constant(1e3);
      level.tail<2>().setConstant(1e-3);
      smoother.AddTerm(node, Term::OnPose(PosePriorFactor(x, level)));
    }
    smoother.Update();
    places.Note(5.0 * node, x.head<2>());
  }
  /// Out along one lane and back along the next.
  void GoOutAndBack(int steps) {
    for (int i = 0; i < steps; ++i)
      GoTo(0.5 * i, 0.0);
    for (int i = steps; i-- > 0;)
      GoTo(0.5 * i, 3.0);
  }
  [[nodiscard]] PlaceSigma OfNewest() const { return places.Of(places.noted() - 1, smoother); }
};

TEST(PlaceSigmas, FindsThePlaceOfTheOtherPassThatIsNearest) {
  Walk walk;
  walk.GoOutAndBack(20);
  EXPECT_EQ(walk.places.NodeBeside(39), 0);
  EXPECT_EQ(walk.places.NodeBeside(30), 9);
}

TEST(PlaceSigmas, OnAFirstPassThereIsNoPlaceBeside) {
  Walk walk;
  for (int i = 0; i < 30; ++i)
    walk.GoTo(10.0 * i, 0.0);
  EXPECT_FALSE(walk.places.NodeBeside(29));
  EXPECT_EQ(walk.OfNewest().beside, 0.0);
}

TEST(PlaceSigmas, AgainstThePassBesideOnlyWhatWasWalkedSinceIsInDoubt) {
  Walk walk;
  walk.GoOutAndBack(20);
  const PlaceSigma sigma = walk.OfNewest();
  const double walked = kStepSigma * std::sqrt(39.0);
  EXPECT_NEAR(sigma.beside, walked, 0.02 * walked);
  EXPECT_NEAR(sigma.absolute, std::hypot(kStartSigma, walked), 0.02);
}

}  // namespace
}  // namespace limpet
