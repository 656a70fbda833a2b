// SPDX-License-Identifier: MIT
#include "estimation/navigation/water_model.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kPingPeriod = 0.2;  // [s] of the DVL
constexpr double kArm = -0.2;        // [m]
constexpr double kSway = -0.35;      // [m/s per rad/s] arm and slip

/// A survey in water that moves: legs of a minute, then half a turn in 15 s, to and fro.
class WaterModelTest : public ::testing::Test {
 protected:
  void Survey(double seconds, bool has_velocity = true) {
    for (const double end = t_ + seconds; t_ < end; t_ += kPingPeriod) {
      if (std::fmod(t_, kLeg + kTurn) < kPingPeriod) way_ = -way_;
      const bool turns = std::fmod(t_, kLeg + kTurn) > kLeg;
      conduct_.rate = turns ? way_ * M_PI / kTurn : 0.0;
      conduct_.yaw += kPingPeriod * conduct_.rate;
      current_W_ += Eigen::Vector2d(random_.Normal(walk_), random_.Normal(walk_));
      const Eigen::Vector2d noise(random_.Normal(0.01), random_.Normal(0.01));
      if (has_velocity) model_.Add(t_, HeadingFrame(Velocity()) + noise, conduct_);
    }
  }
  [[nodiscard]] Eigen::Vector2d Velocity() const {
    return Eigen::Rotation2Dd(conduct_.yaw) * Eigen::Vector2d(speed_, kSway * conduct_.rate) +
           current_W_;
  }
  [[nodiscard]] Eigen::Vector2d HeadingFrame(const Eigen::Vector2d& v_W) const {
    return Eigen::Rotation2Dd(-conduct_.yaw) * v_W;
  }
  [[nodiscard]] double CurrentError() const {
    return (model_.StateAt(t_, conduct_).current_W - current_W_).norm();
  }

  static constexpr double kLeg = 60.0, kTurn = 15.0;  // [s]
  Random random_{7};
  WaterModel model_{WaterParams{}, kArm};
  Conduct conduct_{.yaw = 0.6, .rate = 0.0};
  Eigen::Vector2d current_W_{0.08, -0.1};
  double speed_ = 0.5, walk_ = 0.0, way_ = 1.0, t_ = 0.0;
};

TEST_F(WaterModelTest, FindsAConstantCurrentOnceTheVehicleHasTurned) {
  Survey(400.0);
  EXPECT_LT(CurrentError(), 0.01);
  const WaterState state = model_.StateAt(t_, conduct_);
  EXPECT_NEAR(state.speed, 0.5, 0.01);
  EXPECT_LT(state.sd_current_W.norm(), 0.02);
  EXPECT_LT(CurrentError(), 3.0 * state.sd_current_W.norm());
}

TEST_F(WaterModelTest, BeforeAnyTurnItDoesNotClaimToKnowTheCurrentAlongTheWay) {
  Survey(55.0);
  const Eigen::Vector2d ahead = Eigen::Rotation2Dd(conduct_.yaw) * Eigen::Vector2d::UnitX();
  const Eigen::Matrix2d covariance = model_.BridgeCovariance(t_, conduct_).topLeftCorner<2, 2>();
  EXPECT_GT(std::sqrt(ahead.dot(covariance * ahead)), 0.1);
  const double off = ahead.dot(model_.StateAt(t_, conduct_).current_W - current_W_);
  EXPECT_LT(std::abs(off), 3.0 * std::sqrt(ahead.dot(covariance * ahead)));
}

TEST_F(WaterModelTest, StraightOnItIsSureOfTheVelocityAllTheSame) {
  Survey(55.0);
  EXPECT_LT((model_.VelocityAt(t_, conduct_) - Velocity()).norm(), 0.01);
  EXPECT_LT(model_.VarianceAt(t_, conduct_), 0.02 * 0.02);
  const Conduct back{.yaw = conduct_.yaw + M_PI, .rate = 0.0};
  EXPECT_GT(model_.VarianceAt(t_, back), 0.1 * 0.1) << "but not of the way back";
}

TEST_F(WaterModelTest, CarriesTheVehicleThroughATurnWithoutVelocity) {
  Survey(410.0);
  Eigen::Vector2d off = Eigen::Vector2d::Zero();
  for (int i = 0; i < 200; ++i) {
    Survey(kPingPeriod, false);
    off += kPingPeriod * (model_.VelocityAt(t_, conduct_) - Velocity());
  }
  EXPECT_LT(off.norm(), 0.3) << "of 20 m, in a current that would have added 5";
}

TEST_F(WaterModelTest, ItsBridgesAreAsFarOffAsItSays) {
  walk_ = 0.0007 * std::sqrt(kPingPeriod);
  Survey(300.0);
  double nees = 0.0;
  constexpr int kWindows = 60;
  constexpr double kEddy = 0.006;  // [m/s] of water that is here and not there
  for (int window = 0; window < kWindows; ++window) {
    Survey(random_.Uniform(60.0, 200.0));
    const Eigen::Matrix3d error = model_.BridgeCovariance(t_, conduct_);
    const double length = random_.Uniform(25.0, 60.0);
    const Eigen::Vector2d eddy(random_.Normal(kEddy), random_.Normal(kEddy));
    current_W_ += eddy;
    Eigen::Vector2d off = Eigen::Vector2d::Zero();
    Eigen::Matrix<double, 2, 3> per_error = Eigen::Matrix<double, 2, 3>::Zero();
    for (double gone = 0.0; gone < length; gone += kPingPeriod) {
      Survey(kPingPeriod, false);
      off += kPingPeriod * (model_.VelocityAt(t_, conduct_) - Velocity());
      per_error.leftCols<2>() += kPingPeriod * Eigen::Matrix2d::Identity();
      per_error(0, 2) += kPingPeriod * std::cos(conduct_.yaw);
      per_error(1, 2) += kPingPeriod * std::sin(conduct_.yaw);
    }
    current_W_ -= eddy;
    const Eigen::Matrix2d covariance = per_error * error * per_error.transpose();
    nees += off.dot(covariance.inverse() * off) / kWindows;
  }
  EXPECT_GT(nees, 0.3) << "2 if it said exactly what it is; it has a margin";
  EXPECT_LT(nees, 2.5);
}

TEST_F(WaterModelTest, AChangeOfSpeedIsTheVehiclesNotTheWaters) {
  Survey(400.0);
  const Eigen::Vector2d before = model_.StateAt(t_, conduct_).current_W;
  speed_ = 0.2;
  Survey(10.0);
  EXPECT_NEAR(model_.StateAt(t_, conduct_).speed, 0.2, 0.1) << "it is near the usual one";
  EXPECT_NEAR(model_.state()(0), 0.2, 0.02);
  EXPECT_LT((model_.StateAt(t_, conduct_).current_W - before).norm(), 0.02);
}

TEST_F(WaterModelTest, ASpeedFarFromTheUsualOneIsNotHeldForLong) {
  Survey(400.0);
  speed_ = 0.0;
  Survey(2.0);
  EXPECT_GT(HeadingFrame(model_.VelocityAt(t_ + 20.0, conduct_) - current_W_).x(), 0.3);
  EXPECT_GT(model_.VarianceAt(t_ + 20.0, conduct_), 0.1 * 0.1);
}

TEST_F(WaterModelTest, TurningBringsTheLeverArmsSwayUntilTurnsTeachIt) {
  EXPECT_DOUBLE_EQ(model_.state()(2), kArm);
  Survey(300.0);
  EXPECT_NEAR(model_.state()(2), kSway, 0.02);
}

TEST_F(WaterModelTest, ItsCovarianceGrowsInADropout) {
  Survey(400.0);
  const double sure = model_.StateAt(t_, conduct_).sd_current_W.x();
  EXPECT_GT(model_.StateAt(t_ + 3600.0, conduct_).sd_current_W.x(), sure + 0.03);
  EXPECT_GT(model_.BridgeCovariance(t_ + 180.0, conduct_).eigenvalues().real().minCoeff(), 0.0);
}

TEST_F(WaterModelTest, AVehicleThatStandsAtTheSurfaceMayGoAnyTimeAtAnySpeed) {
  speed_ = 0.0, current_W_.setZero();
  Survey(60.0);
  model_.NoteSurface(t_);
  EXPECT_GT(model_.BridgeCovariance(t_, conduct_)(2, 2), 0.4 * 0.4);
  const BridgeDrift drift = model_.BridgeChange(30.0, conduct_, conduct_);
  EXPECT_LT(drift.speed_kept, 0.5) << "and stop again";
  EXPECT_GT(drift.speed_change, 0.3);
}

TEST_F(WaterModelTest, AVehicleThatStandsAmidItsWayMayGoOn) {
  Survey(400.0);
  EXPECT_LT(model_.BridgeCovariance(t_, conduct_)(2, 2), 0.1 * 0.1) << "on its way";
  speed_ = 0.0;
  Survey(120.0);
  EXPECT_GT(model_.BridgeCovariance(t_, conduct_)(2, 2), 0.3 * 0.3);
}

TEST_F(WaterModelTest, AVehicleThatStopsNowAndThenIsExpectedToStopAgain) {
  speed_ = 0.5;
  Survey(300.0);
  const double before = model_.StopRate();
  EXPECT_LT(before, 1.0 / 7000.0) << "it never has";
  for (int i = 0; i < 3; ++i) {
    speed_ = 0.0;
    Survey(20.0);
    speed_ = 0.5;
    Survey(60.0);
  }
  EXPECT_GT(model_.StopRate(), 5.0 * before);
}

TEST_F(WaterModelTest, WhatTheVehicleDidAtTheSurfaceIsNoHabitOfItsDive) {
  speed_ = 0.1;
  Survey(60.0);
  model_.NoteSurface(t_);
  speed_ = 0.5;
  Survey(20.0);
  EXPECT_NEAR(model_.StateAt(t_ + 20.0, conduct_).speed, model_.state()(0), 0.05);
}

TEST_F(WaterModelTest, WithoutAnyVelocityItKnowsNothingOfTheSpeed) {
  EXPECT_GT(model_.BridgeCovariance(t_, conduct_)(2, 2), 0.4 * 0.4);
  EXPECT_GT(model_.BridgeChange(60.0, conduct_, conduct_).speed_change, 0.4);
}

/// Stems a current so that it keeps its way over ground, as the pilot does: 0.5 m/s ahead, none
/// abeam. The sheet of hull and thrusters says `sheet` times the speed that they really make.
class DrivenWaterModelTest : public ::testing::Test {
 protected:
  void Survey(double seconds, double speed, bool has_velocity = true) {
    for (const double end = t_ + seconds; t_ < end; t_ += kPingPeriod) {
      ground_ += std::clamp(speed - ground_, -0.05 * kPingPeriod, 0.05 * kPingPeriod);
      const bool turns = std::fmod(t_, 75.0) > 60.0;
      conduct_.rate = turns ? M_PI / 15.0 : 0.0;
      conduct_.yaw += kPingPeriod * conduct_.rate;
      const Eigen::Vector2d over_ground(ground_, kArm * conduct_.rate);
      const Eigen::Vector2d water =
          Eigen::Vector2d(ground_, 0.0) - Eigen::Rotation2Dd(-conduct_.yaw) * current_W_;
      conduct_.driven_B = sheet_ * water;
      const Eigen::Vector2d noise(random_.Normal(0.01), random_.Normal(0.01));
      if (has_velocity) model_.Add(t_, over_ground + noise, conduct_);
    }
  }
  [[nodiscard]] Eigen::Vector2d BridgeError() const {
    const Eigen::Vector2d truth_W =
        Eigen::Rotation2Dd(conduct_.yaw) * Eigen::Vector2d(ground_, kArm * conduct_.rate);
    return model_.VelocityAt(t_, conduct_) - truth_W;
  }

  Random random_{3};
  WaterModel model_{WaterParams{}, kArm};
  Conduct conduct_{.yaw = 0.6, .rate = 0.0};
  Eigen::Vector2d current_W_{0.12, 0.2};
  double sheet_ = 1.0, ground_ = 0.0, t_ = 0.0;
};

TEST_F(DrivenWaterModelTest, FindsTheCurrentThatTheVehicleStems) {
  for (const double sheet : {0.75, 1.0, 1.4}) {
    sheet_ = sheet;
    model_ = WaterModel(WaterParams{}, kArm);
    Survey(60.0, 0.0);
    Survey(500.0, 0.5);
    const WaterState water = model_.StateAt(t_, conduct_);
    EXPECT_LT((water.current_W - current_W_).norm(), 0.03) << sheet;
    EXPECT_LT((water.current_W - current_W_).norm(), 4.0 * water.sd_current_W.norm()) << sheet;
  }
}

TEST_F(DrivenWaterModelTest, FollowsAChangeOfSpeedInADropout) {
  Survey(60.0, 0.0);
  Survey(300.0, 0.5);
  Survey(20.0, 0.2, false);  // slows down while nothing measures it
  EXPECT_LT(BridgeError().norm(), 0.05);
  EXPECT_LT(BridgeError().norm(), 3.0 * std::sqrt(2.0 * model_.VarianceAt(t_, conduct_)));
}

TEST_F(DrivenWaterModelTest, DoubtsAChangeOfTheCommandsByAShare) {
  Survey(60.0, 0.0);
  const Conduct before = conduct_;
  Survey(20.0, 0.5, false);
  const double change = model_.BridgeChange(10.0, before, conduct_).speed_change;
  EXPECT_GT(change, 0.05);
  EXPECT_LT(change, 0.4);
  EXPECT_LT(model_.BridgeChange(10.0, conduct_, conduct_).speed_change, 0.01) << "none, no doubt";
  EXPECT_LT(model_.BridgeStretch(before, conduct_), model_.BridgeStretch(conduct_, conduct_));
}

TEST_F(DrivenWaterModelTest, AVehicleThatStartsAsADropoutEndsTellsLittleOfIt) {
  Survey(60.0, 0.0);
  EXPECT_LT(model_.EndVariance(40.0, conduct_).x(), 0.01 * 0.01);
  Survey(12.0, 0.5, false);
  EXPECT_GT(model_.EndVariance(40.0, conduct_).x(), 0.1 * 0.1);
}

TEST_F(DrivenWaterModelTest, CommandsTellTheSpeedBeforeAnyVelocity) {
  Survey(30.0, 0.5, false);
  EXPECT_LT(BridgeError().norm(), 0.5);
  EXPECT_NEAR(model_.StateAt(t_, conduct_).speed, conduct_.driven_B->x(), 0.01);
  EXPECT_LT(model_.BridgeCovariance(t_, conduct_)(2, 2), 0.4 * 0.4) << "not that of any speed";
}

TEST_F(DrivenWaterModelTest, BridgesTheFirstAccelerationOfTheDive) {
  Survey(60.0, 0.0);
  Survey(10.0, 0.5, false);
  EXPECT_LT(BridgeError().norm(), 0.1);
  EXPECT_LT(BridgeError().norm(), 3.0 * std::sqrt(2.0 * model_.VarianceAt(t_, conduct_)));
}

}  // namespace
}  // namespace limpet
