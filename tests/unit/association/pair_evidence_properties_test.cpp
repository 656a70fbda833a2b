// SPDX-License-Identifier: MIT
// What must hold of the evidence that two rows of boxes show one object, for any two of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/association/pair_evidence.hpp"
#include "tests/unit/association/association_draws.hpp"

namespace limpet {
namespace {

constexpr int kPairCases = 400;
constexpr double kConfusedShare = 0.03;
const std::array<std::string, 3> kThreeClasses{"red", "blue", "green"};

struct SeenBox {
  int frame = 0;
  std::string color;
  double confidence = 0.85;
};
using SeenRow = std::vector<SeenBox>;

TrackedObject ObjectOf(const SeenRow& row) {
  TrackedObject object;
  for (const SeenBox& box : row) {
    Observation one;
    one.frame = box.frame;
    one.color = box.color;
    one.confidence = box.confidence;
    object.observations.Add(one);
  }
  return object;
}

/// Up to ten boxes in rising frames, mostly of one class.
SeenRow DrawRow(Random& random) {
  SeenRow row;
  const std::string& usual = kThreeClasses[random.Index(3)];
  int frame = static_cast<int>(random.Index(8));
  for (std::uint64_t i = random.Index(10) + 1; i > 0; --i) {
    row.push_back({.frame = frame,
                   .color = random.Chance(0.75) ? usual : kThreeClasses[random.Index(3)],
                   .confidence = random.Uniform(0.4, 1.0)});
    frame += 1 + static_cast<int>(random.Index(3));
  }
  return row;
}

TEST(PairEvidenceProperties, ItDoesNotMatterWhichOfTheTwoIsNamedFirst) {
  Random random(21);
  for (int i = 0; i < kPairCases; ++i) {
    const TrackedObject a = ObjectOf(DrawRow(random)), b = ObjectOf(DrawRow(random));
    EXPECT_NEAR(ClassCost(a, b, kConfusedShare), ClassCost(b, a, kConfusedShare), 1e-9);
    EXPECT_EQ(TogetherCost(a, b), TogetherCost(b, a));
    EXPECT_EQ(AreSeenTogether(a, b), AreSeenTogether(b, a));
  }
}

TEST(PairEvidenceProperties, ClassesNeverProveThatTwoAreOneAndNeverSayNonsense) {
  Random random(22);
  for (int i = 0; i < kPairCases; ++i) {
    const TrackedObject a = ObjectOf(DrawRow(random)), b = ObjectOf(DrawRow(random));
    const double cost = ClassCost(a, b, kConfusedShare);
    EXPECT_GE(cost, 0.0);
    EXPECT_TRUE(std::isfinite(cost));
  }
}

TEST(PairEvidenceProperties, ClassesAreJustNames) {
  Random random(23);
  const std::map<std::string, std::string> renamed{
      {"red", "zebra"}, {"blue", "ant"}, {"green", "middle"}};
  for (int i = 0; i < kPairCases; ++i) {
    SeenRow a = DrawRow(random), b = DrawRow(random);
    const double cost = ClassCost(ObjectOf(a), ObjectOf(b), kConfusedShare);
    for (SeenRow* row : {&a, &b}) {
      for (SeenBox& box : *row)
        box.color = renamed.at(box.color);
    }
    EXPECT_NEAR(ClassCost(ObjectOf(a), ObjectOf(b), kConfusedShare), cost, 1e-9);
  }
}

TEST(PairEvidenceProperties, ABoxMoreOfADifferentClassNeverMakesTwoLikelierOne) {
  Random random(24);
  for (int i = 0; i < kPairCases; ++i) {
    SeenRow red(1, {.color = "red"}), blue(1, {.color = "blue"});
    double before = 0.0;
    for (int more = 0; more < 6; ++more) {
      const double cost = ClassCost(ObjectOf(red), ObjectOf(blue), kConfusedShare);
      EXPECT_GE(cost, before - 1e-9);
      before = cost;
      SeenRow& row = random.Chance(0.5) ? red : blue;
      row.push_back(row.back());
    }
  }
}

TEST(PairEvidenceProperties, WhereClassesAreConfusedMoreOftenTheySayLess) {
  const TrackedObject red = ObjectOf(SeenRow(4, {.color = "red"}));
  const TrackedObject blue = ObjectOf(SeenRow(4, {.color = "blue"}));
  double before = 1e9;
  for (const double confused : {0.01, 0.03, 0.1, 0.2, 0.3}) {
    const double cost = ClassCost(red, blue, confused);
    EXPECT_LT(cost, before) << confused;
    before = cost;
  }
}

TEST(PairEvidenceProperties, WhenTheFramesWereTakenDoesNotMatterOnlyWhichAreShared) {
  Random random(25);
  for (int i = 0; i < kPairCases; ++i) {
    SeenRow a = DrawRow(random), b = DrawRow(random);
    const double cost = TogetherCost(ObjectOf(a), ObjectOf(b));
    for (SeenRow* row : {&a, &b}) {
      for (SeenBox& box : *row)
        box.frame = 1000 + 7 * box.frame;
    }
    EXPECT_EQ(TogetherCost(ObjectOf(a), ObjectOf(b)), cost);
  }
}

TEST(PairEvidenceProperties, AFrameMoreThatShowsBothNeverSpeaksForOne) {
  Random random(26);
  for (int i = 0; i < kPairCases; ++i) {
    SeenRow a = DrawRow(random), b = DrawRow(random);
    const double before = TogetherCost(ObjectOf(a), ObjectOf(b));
    const int frame = 1 + std::max(a.back().frame, b.back().frame);
    a.push_back({.frame = frame, .color = "red", .confidence = random.Uniform(0.0, 1.0)});
    b.push_back({.frame = frame, .color = "red", .confidence = random.Uniform(0.0, 1.0)});
    EXPECT_GE(TogetherCost(ObjectOf(a), ObjectOf(b)), std::min(before, kTwoObjectsCost));
  }
}

TEST(PairEvidenceProperties, AFrameThatShowsOnlyOneOfThemSaysNothing) {
  Random random(27);
  for (int i = 0; i < kPairCases; ++i) {
    SeenRow a = DrawRow(random), b = DrawRow(random);
    const double before = TogetherCost(ObjectOf(a), ObjectOf(b));
    const int last = std::max(a.back().frame, b.back().frame);
    a.push_back({.frame = last + 1, .color = "red"});
    b.push_back({.frame = last + 2, .color = "red"});
    EXPECT_EQ(TogetherCost(ObjectOf(a), ObjectOf(b)), before);
  }
}

/// Shared frames of that confidence until two are two.
int FramesToTellApart(double confidence) {
  for (int frames = 1; frames < 20; ++frames) {
    SeenRow row;
    for (int k = 0; k < frames; ++k)
      row.push_back({.frame = k, .color = "red", .confidence = confidence});
    if (AreSeenTogether(ObjectOf(row), ObjectOf(row))) return frames;
  }
  return 20;
}

TEST(PairEvidenceProperties, SoManyFramesTellTwoObjectsApart) {
  EXPECT_EQ(FramesToTellApart(0.95), 3);
  EXPECT_EQ(FramesToTellApart(0.85), 3);
  EXPECT_EQ(FramesToTellApart(0.7), 4);
  EXPECT_EQ(FramesToTellApart(0.5), 5);
  EXPECT_EQ(FramesToTellApart(0.1), 5) << "a box that is used at all is taken for half sure";
  EXPECT_EQ(FramesToTellApart(1.0), 3) << "no box is taken for surer than 0.95";
}

TEST(PairEvidenceProperties, OneSharedFrameCostsWhatItsWeakerBoxSays) {
  Random random(28);
  for (int i = 0; i < kPairCases; ++i) {
    const double c = random.Uniform(0.0, 1.0), d = random.Uniform(0.0, 1.0);
    const double weaker = std::clamp(std::min(c, d), 0.5, 0.95);
    const double expected = 2.0 * std::log(weaker / (1.0 - weaker)) - 2.0 * std::log(0.05);
    EXPECT_NEAR(TogetherCost(ObjectOf({{.frame = 3, .color = "red", .confidence = c}}),
                             ObjectOf({{.frame = 3, .color = "red", .confidence = d}})),
                expected, 1e-9);
  }
}

TEST(OverlapCostProperties, ATurnOfTheWorldAndTheOtherWayRoundChangeNothing) {
  Random random(29);
  for (int i = 0; i < kPairCases; ++i) {
    const Eigen::Vector3d d(random.Normal(0.6), random.Normal(0.6), random.Normal(0.2));
    const Eigen::Matrix3d S = DrawCovariance<3>(random, 0.3);
    const Eigen::Matrix3d R = DrawWorldChange(random).R();
    const double cost = OverlapCost(d, S, 0.5);
    EXPECT_NEAR(OverlapCost(-d, S, 0.5), cost, 1e-9);
    EXPECT_NEAR(OverlapCost(R * d, R * S * R.transpose(), 0.5), cost, 1e-6);
  }
}

TEST(OverlapCostProperties, IsNeverNegativeAndNeverForbidsTwoObjects) {
  Random random(30);
  for (int i = 0; i < kPairCases; ++i) {
    const double reach = std::pow(10.0, random.Uniform(-8.0, 3.0));
    const Eigen::Vector3d d = reach * Eigen::Vector3d(1.0, random.Normal(1.0), random.Normal(1.0));
    const double cost = OverlapCost(d, DrawCovariance<3>(random, random.Uniform(0.001, 9.0)),
                                    random.Uniform(0.0, 2.0));
    EXPECT_GE(cost, 0.0);
    EXPECT_LE(cost, -2.0 * std::log(1e-6) + 1e-9);
  }
  EXPECT_TRUE(std::isfinite(OverlapCost({0, 0, 0}, 0.01 * Eigen::Matrix3d::Identity(), 0.5)));
}

TEST(OverlapCostProperties, FallsWithTheDistanceAndGrowsWithTheRadius) {
  Random random(31);
  for (int i = 0; i < kPairCases; ++i) {
    const double variance = std::pow(random.Uniform(0.05, 0.6), 2);
    const Eigen::Matrix3d S = variance * Eigen::Matrix3d::Identity();
    const double n = random.Uniform(0.05, 2.0), radius = random.Uniform(0.2, 1.0);
    const Eigen::Vector3d u = Eigen::Vector3d(random.Normal(1), random.Normal(1), 0.2).normalized();
    EXPECT_LE(OverlapCost(1.1 * n * u, S, radius), OverlapCost(n * u, S, radius) + 1e-9);
    EXPECT_GE(OverlapCost(n * u, S, 1.1 * radius), OverlapCost(n * u, S, radius) - 1e-9);
  }
}

}  // namespace
}  // namespace limpet
