// SPDX-License-Identifier: MIT
#include "limpet/vehicle/vehicle_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/vehicle/rk4_integrator.hpp"

namespace limpet {
namespace {

constexpr double kSeabed = 20.0;

VehicleModel StillWater() {
  return {VehicleParams{}, Eigen::Vector3d::Zero(), [](const Eigen::Vector2d&) { return kSeabed; }};
}

StateVector Submerged(const VehicleModel& model, double depth) {
  StateVector x = model.Afloat({0.0, 0.0}, 0.3);
  x(state_index::kPosition + 2) = depth;
  return x;
}

StateVector After(const VehicleModel& model, const StateVector& start, const ThrusterVector& thrust,
                  double duration) {
  Rk4Integrator integrator(model, start);
  std::vector<TimedEvent> events;
  integrator.Advance(thrust, duration, events);
  return integrator.state();
}

/// Kinetic energy of body and added mass, and potential energy of weight and buoyancy, submerged.
double Energy(const VehicleModel& model, const StateVector& x) {
  const Vector6 nu = x.segment<6>(state_index::kVelocity);
  const Hydrodynamics& hydro = model.hydrodynamics();
  const double down_z = 1.0 - 2.0 * x.segment<2>(state_index::kQuaternion + 1).squaredNorm();
  return 0.5 * nu.dot(hydro.mass_matrix * nu) +
         (hydro.buoyancy_n - hydro.weight_n) * x(state_index::kPosition + 2) -
         hydro.weight_n * model.params().cg_below_cb_m * down_z;
}

TEST(VehicleModel, FloatsStillAtTheSurfaceWithItsAntennaInTheAir) {
  const VehicleModel model = StillWater();
  const StateVector x = After(model, model.Afloat({1.0, 2.0}, 0.5), ThrusterVector::Zero(), 30.0);
  EXPECT_LT((x - model.Afloat({1.0, 2.0}, 0.5)).norm(), 1e-6);
  EXPECT_LT(x(2) + model.params().antenna_B.z(), -0.05);
}

TEST(VehicleModel, RunsAtAboutOneMetrePerSecondAtFullThrust) {
  const VehicleModel model = StillWater();
  ThrusterVector full = ThrusterVector::Zero();
  full.head<4>().setConstant(model.params().thrusters.max_thrust_n);
  const StateVector x = After(model, Submerged(model, 5.0), full, 8.0);
  EXPECT_NEAR(x(state_index::kVelocity), 1.0, 0.1);
}

TEST(VehicleModel, SurfacesByItselfWhenItsThrustersAreDead) {
  const VehicleModel model = StillWater();
  const StateVector x = After(model, Submerged(model, 5.0), ThrusterVector::Zero(), 90.0);
  EXPECT_NEAR(x(state_index::kPosition + 2), FloatingDepth(model.hydrodynamics()), 0.02);
}

TEST(VehicleModel, RightsItselfFromARoll) {
  const VehicleModel model = StillWater();
  StateVector x = Submerged(model, 8.0);
  x.segment<4>(state_index::kQuaternion) << std::cos(0.4), std::sin(0.4), 0.0, 0.0;
  x = After(model, x, ThrusterVector::Zero(), 20.0);
  EXPECT_LT(x.segment<2>(state_index::kQuaternion + 1).norm(), 0.01);
}

TEST(VehicleModel, NeverGainsEnergyWithoutThrust) {
  const VehicleModel model = StillWater();
  StateVector x = Submerged(model, 8.0);
  x.segment<6>(state_index::kVelocity) << 0.8, -0.4, 0.3, 0.5, -0.4, 0.8;
  double energy = Energy(model, x);
  for (int i = 0; i < 400; ++i) {
    x = After(model, x, ThrusterVector::Zero(), 0.05);
    const double next = Energy(model, x);
    ASSERT_LT(next, energy) << "after " << 0.05 * i << " s";
    energy = next;
  }
}

TEST(VehicleModel, KeepsTheQuaternionUnit) {
  const VehicleModel model = StillWater();
  ThrusterVector spin = ThrusterVector::Zero();
  spin(0) = -12.0;
  spin(1) = 12.0;
  const StateVector x = After(model, Submerged(model, 5.0), spin, 600.0);
  EXPECT_NEAR(x.segment<4>(state_index::kQuaternion).norm(), 1.0, 1e-6);
}

TEST(VehicleModel, DriftsWithTheCurrentAtNoRelativeSpeed) {
  const VehicleModel model{VehicleParams{}, Eigen::Vector3d(0.2, -0.1, 0.0),
                           [](const Eigen::Vector2d&) { return kSeabed; }};
  const StateVector x = After(model, model.Afloat({0.0, 0.0}, 1.0), ThrusterVector::Zero(), 100.0);
  EXPECT_NEAR(x(0), 20.0, 1e-6);
  EXPECT_NEAR(x(1), -10.0, 1e-6);
}

TEST(VehicleModel, GivesVelocityOverGroundInTheBodyFrame) {
  const VehicleModel model{VehicleParams{}, Eigen::Vector3d(0.2, 0.0, 0.0),
                           [](const Eigen::Vector2d&) { return kSeabed; }};
  const VehicleMotion motion =
      model.Motion(model.Afloat({0.0, 0.0}, M_PI / 2.0), ThrusterVector::Zero());
  EXPECT_TRUE(motion.v_WB_B.isApprox(Eigen::Vector3d(0.0, -0.2, 0.0), 1e-9));
}

TEST(VehicleModel, FeelsGravityUpwardsAtRest) {
  const VehicleModel model = StillWater();
  const VehicleMotion motion = model.Motion(model.Afloat({0.0, 0.0}, 0.0), ThrusterVector::Zero());
  EXPECT_NEAR(motion.specific_force_B.z(), -9.81, 1e-6);
}

TEST(VehicleModel, SpecificForceIntegratesToTheVelocityOverGround) {
  const VehicleModel model = StillWater();
  ThrusterVector push = ThrusterVector::Zero();
  push.head<4>() << 4.0, 8.0, 4.0, 8.0;
  StateVector x = Submerged(model, 5.0);
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();
  constexpr double kStep = 0.002;
  for (int i = 0; i < 1000; ++i) {
    const VehicleMotion a = model.Motion(x, push);
    x = After(model, x, push, kStep);
    const VehicleMotion b = model.Motion(x, push);
    v_W += 0.5 * kStep *
           (RotationOf(a.X_WB) * a.specific_force_B + RotationOf(b.X_WB) * b.specific_force_B);
    v_W.z() += kStep * model.params().gravity;
  }
  const VehicleMotion end = model.Motion(x, push);
  EXPECT_LT((v_W - RotationOf(end.X_WB) * end.v_WB_B).norm(), 1e-4);
}

}  // namespace
}  // namespace limpet
