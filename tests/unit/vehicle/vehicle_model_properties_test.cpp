// SPDX-License-Identifier: MIT
// What the equations of motion obey in any state: energy, symmetry, and the same water everywhere.
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/vehicle/vehicle_model.hpp"

namespace limpet {
namespace {

using state_index::kPosition;
using state_index::kQuaternion;
using state_index::kRate;
using state_index::kThrust;
using state_index::kVelocity;

VehicleParams DrawHull(Random& random) {
  VehicleParams params;
  params.mass = random.Uniform(8.0, 80.0);
  params.net_buoyancy_n = random.Uniform(0.5, 10.0);
  params.length_m = random.Uniform(0.7, 1.5);
  params.width_m = random.Uniform(0.3, 0.5);
  params.cg_below_cb_m = random.Uniform(0.01, 0.1);
  params.drag_coefficient = {random.Uniform(0.3, 1.2), random.Uniform(0.5, 1.5),
                             random.Uniform(0.5, 1.5)};
  return params;
}

StateVector DrawSubmerged(Random& random) {
  StateVector x = StateVector::Zero();
  x.segment<3>(kPosition) << random.Normal(50.0), random.Normal(50.0), random.Uniform(5.0, 12.0);
  const Eigen::Vector4d q(random.Normal(1.0), random.Normal(1.0), random.Normal(1.0),
                          random.Normal(1.0));
  x.segment<4>(kQuaternion) = q.normalized();
  for (int i = 0; i < 3; ++i) {
    x(kVelocity + i) = random.Normal(0.6);
    x(kRate + i) = random.Normal(0.6);
  }
  for (int i = 0; i < kMostThrusters; ++i)
    x(kThrust + i) = random.Uniform(-12.0, 12.0);
  return x;
}

Eigen::Matrix3d AttitudeOf(const StateVector& x) {
  return Eigen::Quaterniond(x(kQuaternion), x(kQuaternion + 1), x(kQuaternion + 2),
                            x(kQuaternion + 3))
      .toRotationMatrix();
}

class VehicleModelProperties : public ::testing::TestWithParam<int> {
 protected:
  [[nodiscard]] VehicleModel In(const Eigen::Vector3d& current_W) const {
    return {params_, current_W, [](const Eigen::Vector2d&) { return 60.0; }};
  }
  /// Power of what is neither kinetic energy nor weight and buoyancy [W].
  [[nodiscard]] static double PowerFromOutside(const VehicleModel& model, const StateVector& x) {
    const Hydrodynamics& hydro = model.hydrodynamics();
    const StateVector rate = model.Derivative(x, x.segment<kMostThrusters>(kThrust), false);
    const Vector6 nu = x.segment<6>(kVelocity);
    const double kinetic = nu.dot(hydro.mass_matrix * rate.segment<6>(kVelocity));
    const Eigen::Vector3d down_B = AttitudeOf(x).row(2).transpose();
    const double rising = (hydro.buoyancy_n - hydro.weight_n) * down_B.dot(nu.head<3>());
    // The centre of gravity hangs below: turning away from upright lifts it.
    const Eigen::Vector3d righting =
        Eigen::Vector3d(0.0, 0.0, model.params().cg_below_cb_m).cross(hydro.weight_n * down_B);
    return kinetic + rising - righting.dot(nu.tail<3>());
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "vehicle"};
  const VehicleParams params_ = DrawHull(random_);
};

TEST_P(VehicleModelProperties, EnergyComesFromThrustAndGoesIntoDragAndNothingElse) {
  const VehicleModel model = In(Eigen::Vector3d::Zero());
  for (int i = 0; i < 50; ++i) {
    const StateVector x = DrawSubmerged(random_);
    const Vector6 nu = x.segment<6>(kVelocity);
    const double thrust =
        nu.dot(params_.thrusters.WrenchPerThrust() * x.segment<kMostThrusters>(kThrust));
    const Hydrodynamics& hydro = model.hydrodynamics();
    const double drag =
        ((hydro.linear_drag.array() + hydro.quadratic_drag.array() * nu.array().abs()) *
         nu.array().square())
            .sum();
    EXPECT_NEAR(PowerFromOutside(model, x), thrust - drag, 1e-8 * (1.0 + std::abs(thrust) + drag));
    EXPECT_GE(drag, 0.0);
  }
}

TEST_P(VehicleModelProperties, TheWaterIsTheSameEverywhereAndInEveryDirection) {
  const VehicleModel model = In(Eigen::Vector3d::Zero());
  for (int i = 0; i < 30; ++i) {
    const StateVector x = DrawSubmerged(random_);
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(random_.Uniform(-3.0, 3.0), Eigen::Vector3d::UnitZ()));
    StateVector other = x;
    other.segment<2>(kPosition) += Eigen::Vector2d(random_.Normal(100.0), random_.Normal(100.0));
    const Eigen::Quaterniond q(x(kQuaternion), x(kQuaternion + 1), x(kQuaternion + 2),
                               x(kQuaternion + 3));
    const Eigen::Quaterniond turned = turn * q;
    other.segment<4>(kQuaternion) << turned.w(), turned.x(), turned.y(), turned.z();
    const ThrusterVector wanted = ThrusterVector::Constant(3.0);
    const StateVector here = model.Derivative(x, wanted, false);
    const StateVector there = model.Derivative(other, wanted, false);
    EXPECT_LT((here.segment<6>(kVelocity) - there.segment<6>(kVelocity)).norm(), 1e-9);
    EXPECT_LT((turn * here.segment<3>(kPosition) - there.segment<3>(kPosition)).norm(), 1e-9);
  }
}

TEST_P(VehicleModelProperties, PortIsStarboardInAMirror) {
  const VehicleModel model = In(Eigen::Vector3d::Zero());
  const ThrusterVector wanted = ThrusterVector::Zero();
  // Across the plane of x and z: sway, roll and yaw change sign, and pairs of thrusters places.
  Vector6 sign;
  sign << 1.0, -1.0, 1.0, -1.0, 1.0, -1.0;
  constexpr std::array<int, kMostThrusters> kPartner{1, 0, 3, 2, 4, 5, 6, 7};
  for (int i = 0; i < 30; ++i) {
    const StateVector x = DrawSubmerged(random_);
    StateVector mirrored = x;
    mirrored(kPosition + 1) = -x(kPosition + 1);
    mirrored(kQuaternion + 1) = -x(kQuaternion + 1);
    mirrored(kQuaternion + 3) = -x(kQuaternion + 3);
    mirrored.segment<6>(kVelocity) = sign.cwiseProduct(x.segment<6>(kVelocity));
    for (int k = 0; k < kMostThrusters; ++k)
      mirrored(kThrust + k) = x(kThrust + kPartner[static_cast<std::size_t>(k)]);
    const Vector6 here = model.Derivative(x, wanted, false).segment<6>(kVelocity);
    const Vector6 there = model.Derivative(mirrored, wanted, false).segment<6>(kVelocity);
    EXPECT_LT((sign.cwiseProduct(here) - there).norm(), 1e-9 * (1.0 + here.norm()));
  }
}

TEST_P(VehicleModelProperties, AConstantCurrentCarriesTheVehicleAndDoesNothingElse) {
  const Eigen::Vector3d current_W(random_.Normal(0.3), random_.Normal(0.3), 0.0);
  const VehicleModel still = In(Eigen::Vector3d::Zero()), moving = In(current_W);
  for (int i = 0; i < 30; ++i) {
    const StateVector x = DrawSubmerged(random_);
    const ThrusterVector wanted = ThrusterVector::Constant(random_.Normal(4.0));
    StateVector rate = moving.Derivative(x, wanted, false);
    rate.segment<3>(kPosition) -= current_W;
    EXPECT_LT((rate - still.Derivative(x, wanted, false)).norm(), 1e-9);
  }
}

TEST_P(VehicleModelProperties, AThrusterFollowsItsCommandWithItsLag) {
  const VehicleModel model = In(Eigen::Vector3d::Zero());
  const StateVector x = DrawSubmerged(random_);
  ThrusterVector wanted;
  for (int i = 0; i < kMostThrusters; ++i)
    wanted(i) = random_.Uniform(-12.0, 12.0);
  const ThrusterVector rate = model.Derivative(x, wanted, false).segment<kMostThrusters>(kThrust);
  EXPECT_LT((rate * params_.thrusters.lag_s + x.segment<kMostThrusters>(kThrust) - wanted).norm(),
            1e-9);
}

TEST_P(VehicleModelProperties, AttitudeTurnsAsTheRatesSay) {
  const VehicleModel model = In(Eigen::Vector3d::Zero());
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 20; ++i) {
    const StateVector x = DrawSubmerged(random_);
    const Eigen::Vector4d q_rate =
        model.Derivative(x, ThrusterVector::Zero(), false).segment<4>(kQuaternion);
    StateVector later = x;
    later.segment<4>(kQuaternion) += kStep * q_rate;
    const Eigen::Matrix3d turn = AttitudeOf(x).transpose() * AttitudeOf(later);
    const Eigen::AngleAxisd by(turn);
    EXPECT_LT((by.angle() / kStep * by.axis() - x.segment<3>(kRate)).norm(), 1e-3);
  }
}

TEST_P(VehicleModelProperties, FloatsWhereWeightAndBuoyancyAreEqualAndStaysThere) {
  const VehicleModel model = In(Eigen::Vector3d::Zero());
  const StateVector x =
      model.Afloat({random_.Normal(10.0), random_.Normal(10.0)}, random_.Normal(1.0));
  EXPECT_LT(model.Derivative(x, ThrusterVector::Zero(), true).norm(), 1e-6);
  StateVector deeper = x, higher = x;
  deeper(kPosition + 2) += 0.02, higher(kPosition + 2) -= 0.02;
  EXPECT_LT(model.Derivative(deeper, ThrusterVector::Zero(), true)(kVelocity + 2), 0.0);
  EXPECT_GT(model.Derivative(higher, ThrusterVector::Zero(), true)(kVelocity + 2), 0.0);
}

TEST_P(VehicleModelProperties, MotionSaysHowTheStateMovesOverGround) {
  const Eigen::Vector3d current_W(random_.Normal(0.3), random_.Normal(0.3), 0.0);
  const VehicleModel model = In(current_W);
  for (int i = 0; i < 20; ++i) {
    const StateVector x = DrawSubmerged(random_);
    const VehicleMotion motion = model.Motion(x, ThrusterVector::Zero());
    const StateVector rate = model.Derivative(x, ThrusterVector::Zero(), false);
    EXPECT_LT((RotationOf(motion.X_WB) * motion.v_WB_B - rate.segment<3>(kPosition)).norm(), 1e-9);
    EXPECT_EQ(motion.omega_B, Eigen::Vector3d(x.segment<3>(kRate)));
    EXPECT_LT((RotationOf(motion.X_WB) - AttitudeOf(x)).norm(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Hulls, VehicleModelProperties, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet
