// SPDX-License-Identifier: MIT
#include "estimation/navigation/velocity_gate.hpp"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

namespace limpet {
namespace {

using Verdict = VelocityGate::Verdict;

const Eigen::Vector3d kSteady(0.5, 0.0, 0.0), kFalse(0.1, 0.6, 0.0);
constexpr double kPing = 0.2;  // [s] from one velocity to the next

/// A gate that has seen ten seconds of cruise.
class VelocityGateTest : public ::testing::Test {
 protected:
  VelocityGateTest() { EXPECT_EQ(Say(kSteady, 10.0), Verdict::kGood); }
  /// The last verdict about `seconds` of one velocity.
  Verdict Say(const Eigen::Vector3d& v_B, double seconds = kPing) {
    Verdict verdict = Verdict::kRefused;
    for (int i = 0; i < std::lround(seconds / kPing); ++i)
      verdict = gate_.Judge(t_ += kPing, v_B, evidence_);
    return verdict;
  }
  VelocityGate gate_{VelocityGateParams{}};
  VelocityEvidence evidence_;
  double t_ = 0.0;
};

TEST_F(VelocityGateTest, RefusesAJumpThatNoVehicleMakes) {
  EXPECT_EQ(Say(kSteady + Eigen::Vector3d(0.0, 1.0, 0.0)), Verdict::kRefused);
  EXPECT_EQ(Say(kSteady), Verdict::kGood);
}

TEST_F(VelocityGateTest, OneFalseVelocityForSecondsIsNotBelieved) {
  EXPECT_EQ(Say(kFalse, 4.0), Verdict::kContested);
  EXPECT_EQ(Say(kSteady), Verdict::kGood);
}

TEST_F(VelocityGateTest, AFalseVelocityWithinTheAllowanceOfAnOldOneIsStillFalse) {
  const Eigen::Vector3d near = kSteady + Eigen::Vector3d(0.22, 0.0, 0.0);
  EXPECT_EQ(Say(near, 3.0), Verdict::kContested);  // a second later 0.3 m/s would pass
  EXPECT_EQ(Say(kSteady), Verdict::kGood);
}

TEST_F(VelocityGateTest, AnOutlierAmongFalseVelocitiesDoesNotMakeThemTrue) {
  EXPECT_EQ(Say(kFalse, 1.0), Verdict::kContested);
  EXPECT_EQ(Say(Eigen::Vector3d(2.0, -1.0, 0.0)), Verdict::kRefused);
  EXPECT_EQ(Say(kFalse, 1.0), Verdict::kContested);
}

TEST_F(VelocityGateTest, WhatLastsLongerThanAnyFalseVelocityIsTheTruth) {
  EXPECT_EQ(Say(kFalse, 12.0), Verdict::kContested);
  EXPECT_EQ(Say(kFalse), Verdict::kContested);
  EXPECT_EQ(Say(kFalse), Verdict::kBelieved);
  EXPECT_EQ(Say(kFalse), Verdict::kGood);
}

TEST_F(VelocityGateTest, AJumpThatTheAccelerometerFeltIsBelievedAtOnce) {
  evidence_.felt_B = kFalse + Eigen::Vector3d(0.05, -0.05, 0.0);
  EXPECT_EQ(Say(kFalse), Verdict::kGood);
}

TEST_F(VelocityGateTest, AFalseVelocityOfWhichNothingWasFeltIsNotBelievedInHalfAMinute) {
  evidence_.felt_B = kSteady + Eigen::Vector3d(0.05, 0.03, 0.0);
  EXPECT_EQ(Say(kFalse), Verdict::kRefused);
  evidence_.felt_B.reset();  // what was felt is no longer good for anything
  EXPECT_EQ(Say(kFalse, 30.0), Verdict::kContested);
  EXPECT_EQ(Say(kSteady), Verdict::kGood);
}

TEST_F(VelocityGateTest, AnAccelerometerThatFeelsNothingDoesNotLockTheGateForEver) {
  evidence_.felt_B = kSteady;
  EXPECT_EQ(Say(kFalse, 50.0), Verdict::kContested);
  EXPECT_EQ(Say(kFalse, 11.0), Verdict::kGood);
}

TEST_F(VelocityGateTest, APartOfAJumpThatWasFeltLeavesItOpen) {
  evidence_.felt_B = kSteady + 0.5 * (kFalse - kSteady);
  EXPECT_EQ(Say(kFalse, 12.0), Verdict::kContested);
  EXPECT_EQ(Say(kFalse, 0.6), Verdict::kGood);
}

TEST_F(VelocityGateTest, AVehicleThatBeginsToDiveIsBelievedAtTheSecondSample) {
  const Eigen::Vector3d dive = kSteady + Eigen::Vector3d(0.02, 0.0, 0.25);
  EXPECT_EQ(Say(dive), Verdict::kRefused);
  EXPECT_EQ(Say(dive), Verdict::kGood);
}

TEST_F(VelocityGateTest, AfterADropoutWhatIsPredictedIsTakenAtOnce) {
  t_ += 60.0;
  evidence_.predicted_B = -kSteady;
  EXPECT_EQ(Say(-kSteady), Verdict::kGood);
}

TEST_F(VelocityGateTest, AfterADropoutAVehicleMayGoAnotherWay) {
  t_ += 20.0;
  evidence_.predicted_B = kSteady;
  EXPECT_EQ(Say(kFalse, 1.2), Verdict::kContested);
  EXPECT_EQ(Say(kFalse), Verdict::kBelieved);
  EXPECT_TRUE(gate_.alternative_B());
  EXPECT_EQ(Say(kFalse, 12.0), Verdict::kGood);
  EXPECT_FALSE(gate_.alternative_B());
}

TEST_F(VelocityGateTest, WhatWasFalseAfterADropoutIsTakenBackWhenTheOldTruthReturns) {
  t_ += 20.0;
  EXPECT_EQ(Say(kFalse, 1.4), Verdict::kBelieved);
  EXPECT_EQ(Say(kFalse, 2.0), Verdict::kGood);
  EXPECT_EQ(Say(kSteady), Verdict::kBelieved);
  EXPECT_EQ(Say(kSteady), Verdict::kGood);
}

/// In a cross current a turn makes another velocity of the same speed: it is like nothing before.
TEST_F(VelocityGateTest, WhatWasFalseAfterADropoutGivesWayToATruthThatIsNew) {
  const Eigen::Vector3d turned(0.5, 0.4, 0.0);
  t_ += 20.0;
  EXPECT_EQ(Say(kFalse, 3.0), Verdict::kGood);
  evidence_.felt_B = kFalse;  // the accelerometer feels that nothing changed: it tells neither
  EXPECT_EQ(Say(turned, 0.8), Verdict::kContested);
  EXPECT_EQ(Say(turned, 0.6), Verdict::kGood);
  evidence_.felt_B = turned;
  EXPECT_EQ(Say(turned, 20.0), Verdict::kGood);
  // From then on a change of which nothing was felt is a false velocity again.
  EXPECT_EQ(Say(kFalse, 4.0), Verdict::kContested);
}

TEST_F(VelocityGateTest, AnOutlierThatPassedDoesNotMakeTheTruthFalse) {
  const Eigen::Vector3d off(0.1, 0.12, 0.0);
  EXPECT_EQ(Say(kSteady + off), Verdict::kGood);
  EXPECT_EQ(Say(kSteady - Eigen::Vector3d(0.03, 0.05, 0.0)), Verdict::kGood);
}

TEST_F(VelocityGateTest, TakesNoOutlierForTheTruthAtADropoutsEnd) {
  t_ += 60.0;
  EXPECT_EQ(Say(kSteady + Eigen::Vector3d(1.8, 0.0, 0.0)), Verdict::kRefused);
  EXPECT_EQ(Say(kSteady), Verdict::kGood);
}

TEST(VelocityGate, AWrongFirstSampleDoesNotLockIt) {
  VelocityGate gate{VelocityGateParams{}};
  EXPECT_EQ(gate.Judge(0.0, Eigen::Vector3d(3.0, 0.0, 0.0)), Verdict::kGood);
  EXPECT_EQ(gate.Judge(0.2, kSteady), Verdict::kRefused);
  EXPECT_EQ(gate.Judge(0.4, kSteady), Verdict::kGood);
}

TEST(VelocityGate, RefusesWhatIsNoNumberAndWhatNothingUnderWaterReaches) {
  VelocityGate gate{VelocityGateParams{}};
  EXPECT_EQ(gate.Judge(0.0, Eigen::Vector3d(0.5, 0.0, 5.5e80)), Verdict::kRefused);
  EXPECT_EQ(gate.Judge(0.0, Eigen::Vector3d(std::nan(""), 0.0, 0.0)), Verdict::kRefused);
}

}  // namespace
}  // namespace limpet
