// SPDX-License-Identifier: MIT
// What must hold of the statuses of any field of objects: random ones, with fixed seeds.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "tests/unit/change/watched_field.hpp"

namespace limpet {
namespace {

void ExpectSamePosterior(const StatusPosterior& a, const StatusPosterior& b, double within) {
  EXPECT_NEAR(a.confirmed, b.confirmed, within);
  EXPECT_NEAR(a.removed, b.removed, within);
  EXPECT_NEAR(a.appeared, b.appeared, within);
  EXPECT_NEAR(a.nothing, b.nothing, within);
}

/// Both say the same of every object of the field.
void ExpectSameBeliefs(const Field& field, const std::vector<OpiBelief>& a,
                       const std::vector<OpiBelief>& b, double within) {
  EXPECT_EQ(a.size(), b.size());
  for (const FieldObject& one : field.objects) {
    const std::optional<OpiBelief> in_a = BeliefOf(one, a), in_b = BeliefOf(one, b);
    ASSERT_EQ(in_a.has_value(), in_b.has_value())
        << one.landmark.value_or(-1) << "/" << one.former.value_or(-1);
    if (!in_a) continue;
    EXPECT_EQ(in_a->decided, in_b->decided)
        << one.landmark.value_or(-1) << "/" << one.former.value_or(-1);
    EXPECT_EQ(in_a->looks, in_b->looks);
    EXPECT_NEAR(in_a->log_likelihood_ratio, in_b->log_likelihood_ratio, within);
    ExpectSamePosterior(in_a->posterior, in_b->posterior, within);
  }
}

class RandomField : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  const Field field_ = DrawField(GetParam());
};

TEST_P(RandomField, EveryPosteriorIsOne) {
  for (const bool with_former : {true, false}) {
    for (const OpiBelief& belief : StatusesOf(field_, with_former).Assess()) {
      const StatusPosterior& p = belief.posterior;
      EXPECT_NEAR(p.sum(), 1.0, 1e-9);
      for (const double share : {p.confirmed, p.removed, p.appeared, p.nothing}) {
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
      }
      EXPECT_TRUE(std::isfinite(belief.log_likelihood_ratio));
      EXPECT_LE(belief.looks_with_box, belief.looks);
    }
  }
}

TEST_P(RandomField, NoIdIsGivenTwiceAndNoLandmarkNorFormerObjectIsListedTwice) {
  const std::vector<OpiBelief> all = StatusesOf(field_).Assess();
  std::set<int> ids, landmarks, former;
  for (const OpiBelief& belief : all) {
    EXPECT_TRUE(ids.insert(belief.id).second) << "id " << belief.id;
    EXPECT_GT(belief.id, 0);
    if (belief.landmark.has_value()) {
      EXPECT_TRUE(landmarks.insert(*belief.landmark).second) << "landmark " << *belief.landmark;
    }
    if (belief.former_id.has_value()) {
      EXPECT_TRUE(former.insert(*belief.former_id).second) << "former " << *belief.former_id;
    }
  }
}

TEST_P(RandomField, SaysOfEveryObjectWhatBecameOfIt) {
  const std::vector<OpiBelief> all = StatusesOf(field_).Assess();
  for (const FieldObject& one : field_.objects) {
    const std::optional<OpiBelief> belief = BeliefOf(one, all);
    ASSERT_TRUE(belief) << one.landmark.value_or(-1) << "/" << one.former.value_or(-1);
    const StatusPosterior& p = belief->posterior;
    const double truth = !one.landmark ? p.removed : (!one.former ? p.appeared : p.confirmed);
    EXPECT_GT(truth, 0.5) << one.landmark.value_or(-1) << "/" << one.former.value_or(-1);
  }
}

TEST_P(RandomField, TheOrderOfLandmarksFormerObjectsAndBoxesDoesNotMatter) {
  Field shuffled = field_;
  Random random(GetParam(), "order");
  std::ranges::shuffle(shuffled.objects, random.engine());
  for (ObservedFrame& frame : shuffled.frames)
    std::ranges::shuffle(frame.boxes, random.engine());
  ExpectSameBeliefs(field_, StatusesOf(field_).Assess(), StatusesOf(shuffled).Assess(), 1e-9);
}

TEST_P(RandomField, WhereTheWorldLiesAndHowItIsTurnedDoesNotMatter) {
  // A place's spots lie north and east of it; by whole quarters they turn into themselves.
  Random random(GetParam(), "world");
  for (int quarter = 0; quarter < 4; ++quarter) {
    Field there = field_;
    FieldChange{.angle = quarter * 0.5 * std::numbers::pi,
                .shift_W = {random.Normal(200.0), random.Normal(200.0), random.Normal(20.0)}}
        .ApplyTo(there);
    ExpectSameBeliefs(field_, StatusesOf(field_).Assess(), StatusesOf(there).Assess(), 1e-6);
  }
}

TEST_P(RandomField, ATurnByAnyAngleChangesNoDecision) {
  Random random(GetParam(), "turn");
  Field there = field_;
  FieldChange{.angle = random.Uniform(-3.0, 3.0)}.ApplyTo(there);
  const std::vector<OpiBelief> here = StatusesOf(field_).Assess();
  const std::vector<OpiBelief> turned = StatusesOf(there).Assess();
  for (const FieldObject& one : field_.objects) {
    const std::optional<OpiBelief> a = BeliefOf(one, here), b = BeliefOf(one, turned);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->decided, b->decided)
        << one.landmark.value_or(-1) << "/" << one.former.value_or(-1);
  }
}

TEST_P(RandomField, WhenItWasFlownDoesNotMatter) {
  Field later = field_;
  for (ObservedFrame& frame : later.frames)
    frame.exposure = frame.exposure + Seconds(1e6);
  ExpectSameBeliefs(field_, StatusesOf(field_).Assess(), StatusesOf(later).Assess(), 1e-6);
}

TEST_P(RandomField, AskingTwiceGivesOneAnswer) {
  ObjectStatuses statuses = StatusesOf(field_);
  const std::vector<OpiBelief> once = statuses.Assess();
  ExpectSameBeliefs(field_, once, statuses.Assess(), 0.0);
  statuses.SetLandmarks(field_.Landmarks());
  ExpectSameBeliefs(field_, once, statuses.Assess(), 0.0);
}

TEST_P(RandomField, IdsLastAsLandmarksComeOneByOne) {
  ObjectStatuses statuses(StatusParams{}, CameraModel{});
  statuses.SetFormer(field_.Former());
  for (const ObservedFrame& frame : field_.frames)
    statuses.AddFrame(frame);
  const std::vector<Landmark> all = field_.Landmarks();
  std::map<int, int> id_of_landmark;
  for (std::size_t count = 1; count <= all.size(); ++count) {
    statuses.SetLandmarks({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)});
    for (const OpiBelief& belief : statuses.Assess()) {
      if (!belief.landmark) continue;
      const auto known = id_of_landmark.try_emplace(*belief.landmark, belief.id).first;
      EXPECT_EQ(known->second, belief.id) << "landmark " << *belief.landmark;
    }
  }
}

TEST_P(RandomField, JudgedAgainAtOnceItSaysWhatItSaidButForTheRateOfGhosts) {
  ObjectStatuses statuses = StatusesOf(field_);
  const std::vector<OpiBelief> before = statuses.Assess();
  statuses.Rejudge();
  EXPECT_LT(statuses.false_per_image(), DetectionModel{}.false_per_image)
      << "no frame showed a ghost";
  const std::vector<OpiBelief> after = statuses.Assess();
  for (const FieldObject& one : field_.objects) {
    const std::optional<OpiBelief> a = BeliefOf(one, before), b = BeliefOf(one, after);
    ASSERT_TRUE(a && b);
    EXPECT_NEAR(a->posterior.present(), b->posterior.present(), 0.05);
  }
}

TEST_P(RandomField, AnObjectFarAwayChangesNothingOfTheOthers) {
  Field more = field_;
  more.objects.push_back({.object = {.p_W = {500.0, 500.0, 6.0},
                                     .cov_W = 0.04 * Eigen::Matrix3d::Identity(),
                                     .color = "yellow"},
                          .landmark = 77});
  std::vector<OpiBelief> with = StatusesOf(more).Assess();
  std::erase_if(with, [](const OpiBelief& belief) { return belief.landmark == 77; });
  ExpectSameBeliefs(field_, StatusesOf(field_).Assess(), with, 1e-9);
}

TEST_P(RandomField, MovingAllFramesAndLandmarksByOneShiftChangesNothing) {
  const Eigen::Vector3d shift(3.0, -7.0, 0.0);
  ObjectStatuses moved = StatusesOf(field_, false);
  const std::vector<OpiBelief> before = moved.Assess();
  moved.MoveFrames([&shift](double, Pose X_WB) {
    X_WB.p_WB += shift;
    return X_WB;
  });
  std::vector<Landmark> landmarks = field_.Landmarks();
  for (Landmark& landmark : landmarks)
    landmark.object.p_W += shift;
  moved.SetLandmarks(landmarks);
  for (const OpiBelief& now : moved.Assess()) {
    const auto then = std::ranges::find(before, now.landmark, &OpiBelief::landmark);
    ASSERT_NE(then, before.end());
    EXPECT_EQ(now.id, then->id);
    ExpectSamePosterior(now.posterior, then->posterior, 1e-6);
  }
}

TEST_P(RandomField, EveryBoxOfALandmarkIsFoundAndNoOtherIs) {
  ObjectStatuses statuses = StatusesOf(field_);
  for (const OpiBelief& belief : statuses.Assess()) {
    for (const ObservedFrame& frame : statuses.frames()) {
      const Box* box = statuses.BoxOf(belief, frame);
      const auto own = std::ranges::find(frame.boxes, belief.landmark, &Box::landmark);
      const bool has_own = belief.landmark.has_value() && own != frame.boxes.end();
      ASSERT_EQ(box != nullptr, has_own);
      if (box != nullptr) {
        EXPECT_EQ(box->landmark, belief.landmark);
      }
    }
  }
}

TEST_P(RandomField, ADetectorThatMissesMoreLeavesNoObjectSurer) {
  const Field poor = DrawField(GetParam(), 0.35);
  const std::vector<OpiBelief> by_good = StatusesOf(field_, false).Assess();
  const std::vector<OpiBelief> by_poor = StatusesOf(poor, false).Assess();
  // As probabilities: of what both are sure, evidence beyond that counts nothing.
  const auto present = [](const std::vector<OpiBelief>& beliefs, bool is_found) {
    double sum = 0.0;
    for (const OpiBelief& belief : beliefs)
      sum += (belief.landmark.has_value()) == is_found ? belief.posterior.present() : 0.0;
    return sum;
  };
  constexpr double kExcused = 0.02;  // what misses more may as well be in murkier water
  EXPECT_LE(present(by_poor, true), present(by_good, true) + kExcused);
  EXPECT_GE(present(by_poor, false), present(by_good, false) - kExcused);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomField, ::testing::Range<std::uint64_t>(1, 13));

}  // namespace
}  // namespace limpet
