// SPDX-License-Identifier: MIT
#include "limpet/vehicle/hydrodynamics.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(LambFactors, ApproachASphereWhoseAddedMassIsHalfItsDisplacement) {
  const SpheroidAddedMass k = LambFactors({.length = 1.0, .diameter = 0.999});
  EXPECT_NEAR(k.axial, 0.5, 1e-3);
  EXPECT_NEAR(k.transverse, 0.5, 1e-3);
}

TEST(LambFactors, MatchTheTableForASpheroidTwiceAsLongAsThick) {
  const SpheroidAddedMass k =
      LambFactors({.length = 2.0, .diameter = 1.0});  // Lamb 1932, article 115
  EXPECT_NEAR(k.axial, 0.209, 3e-3);
  EXPECT_NEAR(k.transverse, 0.702, 3e-3);
  EXPECT_NEAR(k.rotation, 0.240, 3e-3);
}

TEST(SubmergedShare, GoesFromNothingToAllWithoutAKink) {
  EXPECT_DOUBLE_EQ(SubmergedShare({.depth = -0.2, .half_height = 0.15}), 0.0);
  EXPECT_DOUBLE_EQ(SubmergedShare({.depth = 0.0, .half_height = 0.15}), 0.5);
  EXPECT_DOUBLE_EQ(SubmergedShare({.depth = 0.2, .half_height = 0.15}), 1.0);
  EXPECT_NEAR(SubmergedShare({.depth = 0.15 - 1e-4, .half_height = 0.15}), 1.0, 1e-6);
}

TEST(FloatingDepth, BalancesWeightAndBuoyancy) {
  const Hydrodynamics hydro = DeriveHydrodynamics(VehicleParams{});
  const double share =
      SubmergedShare({.depth = FloatingDepth(hydro), .half_height = hydro.half_height_m});
  EXPECT_NEAR(hydro.buoyancy_n * share, hydro.weight_n, 1e-6);
}

TEST(DeriveHydrodynamics, GivesASymmetricPositiveMassMatrix) {
  const Hydrodynamics hydro = DeriveHydrodynamics(VehicleParams{});
  EXPECT_TRUE(hydro.mass_matrix.isApprox(hydro.mass_matrix.transpose()));
  for (int i = 0; i < 20; ++i) {
    const Vector6 v = Vector6::Random();
    EXPECT_GT(v.dot(hydro.mass_matrix * v), 0.0);
  }
}

TEST(DeriveHydrodynamics, IsABodyAboutThirtyCentimetresHigh) {
  EXPECT_NEAR(2.0 * DeriveHydrodynamics(VehicleParams{}).half_height_m, 0.30, 0.02);
}

}  // namespace
}  // namespace limpet
