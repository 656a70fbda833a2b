// SPDX-License-Identifier: MIT
// What follows from any hull's constants.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"

namespace limpet {
namespace {

class HydrodynamicsProperties : public ::testing::TestWithParam<int> {
 protected:
  static VehicleParams Draw(Random& random) {
    VehicleParams params;
    params.mass = random.Uniform(5.0, 300.0);
    params.net_buoyancy_n = random.Uniform(0.5, 20.0);
    const double scale = std::cbrt(params.mass / 35.0);
    params.length_m = scale * random.Uniform(0.7, 1.6);
    params.width_m = scale * random.Uniform(0.25, 0.4);
    params.cg_below_cb_m = random.Uniform(0.005, 0.1);
    params.frame_added_mass = random.Uniform(0.0, 0.5);
    return params;
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "hull"};
  const VehicleParams params_ = Draw(random_);
  const Hydrodynamics hydro_ = DeriveHydrodynamics(params_);
};

TEST_P(HydrodynamicsProperties, TheMassMatrixIsSymmetricAndPositive) {
  EXPECT_TRUE(hydro_.mass_matrix.isApprox(hydro_.mass_matrix.transpose(), 1e-12));
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(hydro_.mass_matrix);
  EXPECT_GT(solver.eigenvalues().minCoeff(), 0.0);
}

TEST_P(HydrodynamicsProperties, WaterAddsMassMoreAcrossThanAlong) {
  const double along = hydro_.mass_matrix(0, 0), across = hydro_.mass_matrix(1, 1);
  EXPECT_GT(along, params_.mass);
  EXPECT_GT(across, along);
  EXPECT_NEAR(hydro_.mass_matrix(2, 2), across, 1e-9);
}

TEST_P(HydrodynamicsProperties, BuoyancyIsThatOfTheDisplacedEllipsoid) {
  const double volume = 4.0 / 3.0 * std::numbers::pi * 0.5 * params_.length_m * 0.5 *
                        params_.width_m * hydro_.half_height_m;
  EXPECT_NEAR(volume * params_.water_density * params_.gravity, hydro_.buoyancy_n, 1e-6);
  EXPECT_NEAR(hydro_.buoyancy_n - hydro_.weight_n, params_.net_buoyancy_n, 1e-9);
}

TEST_P(HydrodynamicsProperties, ItFloatsPartlyOutOfTheWater) {
  const double depth = FloatingDepth(hydro_);
  EXPECT_LT(depth, hydro_.half_height_m);
  EXPECT_GT(depth, -hydro_.half_height_m);
  EXPECT_NEAR(
      hydro_.buoyancy_n * SubmergedShare({.depth = depth, .half_height = hydro_.half_height_m}),
      hydro_.weight_n, 1e-6 * hydro_.weight_n);
}

TEST_P(HydrodynamicsProperties, DragIsOddAndGrowsFasterThanSpeed) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 20; ++i) {
      const double speed = random_.Uniform(0.05, 2.0);
      EXPECT_NEAR(DragForce(hydro_, axis, -speed), -DragForce(hydro_, axis, speed), 1e-12);
      EXPECT_GT(DragForce(hydro_, axis, 2.0 * speed), 2.0 * DragForce(hydro_, axis, speed));
      EXPECT_LT(DragForce(hydro_, axis, 2.0 * speed), 4.0 * DragForce(hydro_, axis, speed));
    }
    const double even = params_.linear_drag_speed_mps;
    EXPECT_NEAR(hydro_.linear_drag(axis) * even, hydro_.quadratic_drag(axis) * even * even, 1e-9);
  }
}

TEST_P(HydrodynamicsProperties, TurningDragIsThatOfTheHullsStrips) {
  // Strips of the ellipse that the hull shows from the side, each across its own flow.
  const double arm = 0.5 * params_.length_m, breadth = hydro_.half_height_m;
  constexpr int kStrips = 20000;
  double sum = 0.0;
  for (int i = 0; i < kStrips; ++i) {
    const double x = arm * (2.0 * (i + 0.5) / kStrips - 1.0);
    const double height = 2.0 * breadth * std::sqrt(1.0 - x * x / (arm * arm));
    sum += height * std::pow(std::abs(x), 3) * 2.0 * arm / kStrips;
  }
  const double expected = 0.5 * params_.water_density * params_.rotation_drag_factor *
                          params_.drag_coefficient.y() * sum;
  EXPECT_NEAR(hydro_.quadratic_drag(kYaw) / expected, 1.0, 1e-3);
}

TEST_P(HydrodynamicsProperties, TurningMovesTheWaterThatTheSpheroidMoves) {
  VehicleParams bare = params_;
  bare.frame_added_mass = 0.0, bare.inertia_factor = 1.0;
  const Hydrodynamics hydro = DeriveHydrodynamics(bare);
  const double a = 0.5 * bare.length_m, b = 0.5 * bare.width_m;
  const SpheroidAddedMass k =
      LambFactors({.length = 2.0 * a, .diameter = 2.0 * std::sqrt(b * hydro.half_height_m)});
  const double displaced = hydro.buoyancy_n / bare.gravity;
  const double shape = (a * a + b * b) / 5.0;
  EXPECT_NEAR(hydro.mass_matrix(kYaw, kYaw), shape * (bare.mass + k.rotation * displaced), 1e-9);
  const double upright = (a * a + hydro.half_height_m * hydro.half_height_m) / 5.0;
  EXPECT_NEAR(hydro.mass_matrix(kPitch, kPitch),
              upright * (bare.mass + k.rotation * displaced) +
                  bare.mass * bare.cg_below_cb_m * bare.cg_below_cb_m,
              1e-9);
}

TEST_P(HydrodynamicsProperties, AnEverywhereTwiceAsLargeHullHasFourTimesTheDrag) {
  VehicleParams large = params_;
  large.mass *= 8.0, large.net_buoyancy_n *= 8.0;
  large.length_m *= 2.0, large.width_m *= 2.0;
  const Hydrodynamics scaled = DeriveHydrodynamics(large);
  EXPECT_NEAR(scaled.half_height_m, 2.0 * hydro_.half_height_m, 1e-9);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(scaled.quadratic_drag(axis), 4.0 * hydro_.quadratic_drag(axis),
                1e-9 * scaled.quadratic_drag(axis));
    // Moments: a fifth power of the length.
    EXPECT_NEAR(scaled.quadratic_drag(axis + 3), 32.0 * hydro_.quadratic_drag(axis + 3),
                1e-9 * scaled.quadratic_drag(axis + 3));
  }
}

INSTANTIATE_TEST_SUITE_P(Hulls, HydrodynamicsProperties, ::testing::Range(1, 11));

TEST(LambFactors, OfEverMoreSlenderBodiesGoToThoseOfACylinder) {
  SpheroidAddedMass before = LambFactors({.length = 1.01, .diameter = 1.0});
  for (const double length : {1.5, 2.0, 4.0, 8.0, 30.0}) {
    const SpheroidAddedMass now = LambFactors({.length = length, .diameter = 1.0});
    EXPECT_LT(now.axial, before.axial);
    EXPECT_GT(now.transverse, before.transverse);
    EXPECT_GT(now.rotation, before.rotation);
    before = now;
  }
  EXPECT_NEAR(before.transverse, 1.0, 0.01);
  EXPECT_NEAR(before.axial, 0.0, 0.01);
}

TEST(LambFactors, DependOnTheShapeAlone) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const double diameter = random.Uniform(0.1, 2.0), length = diameter * random.Uniform(1.05, 6.0);
    const double scale = random.Uniform(0.1, 10.0);
    const SpheroidAddedMass one = LambFactors({.length = length, .diameter = diameter});
    const SpheroidAddedMass other =
        LambFactors({.length = scale * length, .diameter = scale * diameter});
    EXPECT_NEAR(one.axial, other.axial, 1e-9);
    EXPECT_NEAR(one.transverse, other.transverse, 1e-9);
    EXPECT_NEAR(one.rotation, other.rotation, 1e-9);
  }
}

TEST(SubmergedShare, IsSymmetricMonotonicAndSmooth) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const double half = random.Uniform(0.05, 1.0), depth = random.Uniform(-1.5, 1.5) * half;
    EXPECT_NEAR(SubmergedShare({.depth = depth, .half_height = half}) +
                    SubmergedShare({.depth = -depth, .half_height = half}),
                1.0, 1e-12);
    EXPECT_LE(SubmergedShare({.depth = depth, .half_height = half}),
              SubmergedShare({.depth = depth + 0.1 * half, .half_height = half}));
    // Its slope is the cross-section there: nothing at the poles.
    constexpr double kStep = 1e-6;
    const double slope = (SubmergedShare({.depth = depth + kStep, .half_height = half}) -
                          SubmergedShare({.depth = depth - kStep, .half_height = half})) /
                         (2.0 * kStep);
    const double z = std::clamp(depth / half, -1.0, 1.0);
    EXPECT_NEAR(slope, 0.75 * (1.0 - z * z) / half, 1e-4 / half);
  }
}

}  // namespace
}  // namespace limpet
