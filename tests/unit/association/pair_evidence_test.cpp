// SPDX-License-Identifier: MIT
#include "estimation/association/pair_evidence.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr double kConfused = 0.03;

/// An object whose boxes were given these classes, in frames from `first` on.
TrackedObject SeenAs(const std::vector<std::string>& classes, int first = 0,
                     double confidence = 0.85) {
  TrackedObject object;
  for (const std::string& name : classes) {
    Observation one;
    one.frame = first++;
    one.color = name;
    one.confidence = confidence;
    object.observations.Add(one);
  }
  return object;
}
const std::vector<std::string> kRed(8, "red"), kBlue(8, "blue");

TEST(PairEvidence, ObjectsOfOneClassMayBeOne) {
  EXPECT_NEAR(ClassCost(SeenAs(kRed), SeenAs(kRed), kConfused), 0.0, 0.01);
}

TEST(PairEvidence, ObjectsThatAllBoxesTellApartByClassAreOneIfOnePassWasNamedWrongly) {
  // Either of the two passes.
  EXPECT_NEAR(ClassCost(SeenAs(kRed), SeenAs(kBlue), kConfused), -2.0 * std::log(2.0 * kConfused),
              0.5);
}

TEST(PairEvidence, AHundredBoxesOfOnePassAreNoMoreWitnessesOfItsClassThanEight) {
  const std::vector<std::string> many(100, "blue");
  EXPECT_NEAR(ClassCost(SeenAs(kRed), SeenAs(many), kConfused),
              ClassCost(SeenAs(kRed), SeenAs(kBlue), kConfused), 0.1);
}

TEST(PairEvidence, AFewBoxesThatDisagreeOnTheClassSayLittle) {
  const TrackedObject unsure = SeenAs({"blue", "red", "blue", "red", "blue"});
  EXPECT_LT(ClassCost(unsure, SeenAs(kRed), kConfused), 8.0);
  EXPECT_NEAR(ClassCost(unsure, SeenAs(kBlue), kConfused), 0.0, 0.5);
}

TEST(PairEvidence, ObjectsThatManyFramesShowAtOneTimeAreTwo) {
  EXPECT_TRUE(AreSeenTogether(SeenAs(kRed), SeenAs(kRed)));
}

TEST(PairEvidence, ObjectsThatNoFrameShowsAtOneTimeMayBeOne) {
  EXPECT_EQ(TogetherCost(SeenAs(kRed), SeenAs(kRed, 100)), 0.0);
}

TEST(PairEvidence, OneFrameMayShowAFalseBoxBesideTheTrueOne) {
  const TrackedObject late = SeenAs(kRed, 7), early = SeenAs(kRed, 0);
  EXPECT_GT(TogetherCost(early, late), 5.0);
  EXPECT_FALSE(AreSeenTogether(early, late));
}

TEST(PairEvidence, ADoubtfulBoxIsWeakerProofOfTwoObjects) {
  const TrackedObject early = SeenAs(kRed);
  EXPECT_LT(TogetherCost(early, SeenAs(kRed, 7, 0.5)), TogetherCost(early, SeenAs(kRed, 7)));
}

TEST(PairEvidence, PlacesWellInsideOneRadiusAreNotOfTwoObjects) {
  const Eigen::Matrix3d covariance = 0.01 * Eigen::Matrix3d::Identity();
  EXPECT_GT(OverlapCost({0.1, 0.0, 0.0}, covariance, 0.5), 10.0);
  EXPECT_LT(OverlapCost({1.1, 0.0, 0.0}, covariance, 0.5), 0.01);
}

}  // namespace
}  // namespace limpet
