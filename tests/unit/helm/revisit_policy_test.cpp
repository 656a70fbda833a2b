// SPDX-License-Identifier: MIT
// Which objects the helm still wants to look at, and how much such a look is worth.
#include "limpet/helm/revisit_policy.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

StatusPosterior RandomPosterior(Random& random) {
  StatusPosterior posterior{random.Uniform(0.0, 1.0), random.Uniform(0.0, 1.0),
                            random.Uniform(0.0, 1.0), random.Uniform(0.0, 1.0)};
  return posterior.Normalized();
}

TEST(EntropyDrop, IsNeverBelowZeroNorAboveWhatIsUnknown) {
  Random random(1, "drop");
  for (int run = 0; run < 2000; ++run) {
    const StatusPosterior posterior = RandomPosterior(random);
    const double drop = ExpectedEntropyDrop(posterior, {.if_present = random.Uniform(0.5, 0.999),
                                                        .if_absent = random.Uniform(0.0001, 0.5)});
    EXPECT_GE(drop, 0.0);
    EXPECT_LE(drop, posterior.Entropy() + 1e-12);
  }
}

TEST(EntropyDrop, IsThatOfWhetherSomethingIsThere) {
  // A look tells present from absent only: the mutual information of that and of a box.
  Random random(2, "drop");
  const auto h = [](double p) {
    return p <= 0.0 || p >= 1.0 ? 0.0 : -p * std::log(p) - (1 - p) * std::log(1 - p);
  };
  for (int run = 0; run < 500; ++run) {
    const StatusPosterior posterior = RandomPosterior(random);
    const double detection = random.Uniform(0.5, 0.99), false_alarm = random.Uniform(0.001, 0.4);
    const double present = posterior.present();
    const double box = present * detection + (1.0 - present) * false_alarm;
    const double information = h(box) - present * h(detection) - (1.0 - present) * h(false_alarm);
    EXPECT_NEAR(ExpectedEntropyDrop(posterior, {.if_present = detection, .if_absent = false_alarm}),
                information, 1e-9);
  }
}

TEST(EntropyDrop, IsNothingOfADetectorThatGuesses) {
  Random random(3, "drop");
  for (int run = 0; run < 100; ++run) {
    EXPECT_NEAR(ExpectedEntropyDrop(RandomPosterior(random), {.if_present = 0.5, .if_absent = 0.5}),
                0.0, 1e-12);
  }
}

class RevisitPolicyTest : public ::testing::Test {
 protected:
  RevisitPolicyTest() { now_.region = &region_; }
  [[nodiscard]] static WatchedObject Unknown(double north = 0.0) {
    WatchedObject object;
    object.belief.id = 3;
    object.belief.object.p_W = {north, 0.0, 6.0};
    object.belief.posterior = {.confirmed = 0.5, .removed = 0.5};
    object.window = LookWindow{1.0, 1.0};
    return object;
  }
  Region region_{SurveyArea{.north_min = -20, .north_max = 20, .east_min = -20, .east_max = 20}};
  Situation now_;
  RevisitPolicy::Params params_;
};

TEST_F(RevisitPolicyTest, EachFruitlessLookMakesTheNextWorthLessUntilItGivesUp) {
  params_.fruitless_decay = 0.5;
  params_.give_up_looks = 3;
  const RevisitPolicy policy(params_);
  WatchedObject object = Unknown();
  const double first = policy.InterestIn(object, now_).worth;
  EXPECT_NEAR(first,
              params_.metres_per_nat * ExpectedEntropyDrop(object.belief.posterior,
                                                           {.if_present = 0.95, .if_absent = 0.01}),
              1e-9);
  object.fruitless = 2;
  EXPECT_NEAR(policy.InterestIn(object, now_).worth, 0.25 * first, 1e-9);
  object.fruitless = 3;
  EXPECT_EQ(policy.InterestIn(object, now_).state, "given_up");
  EXPECT_EQ(policy.InterestIn(object, now_).worth, 0.0);
}

TEST_F(RevisitPolicyTest, ASettledObjectIsSettledHoweverManyLooksWereFruitless) {
  const RevisitPolicy policy(params_);
  WatchedObject object = Unknown();
  object.fruitless = 99;
  object.belief.posterior = {.confirmed = 0.99, .removed = 0.01};
  EXPECT_EQ(policy.InterestIn(object, now_).state, "settled");
  object.belief.posterior = {.confirmed = 0.5, .removed = 0.5};
  object.belief.looks = params_.settled_looks;
  EXPECT_EQ(policy.InterestIn(object, now_).state, "settled");
}

TEST_F(RevisitPolicyTest, TwoLooksThatLeaveInDoubtWhetherItIsGoneDoNotSettleIt) {
  const RevisitPolicy policy(params_);
  WatchedObject object = Unknown();
  object.belief.posterior = {.confirmed = 0.26, .removed = 0.74};
  object.belief.looks = 2;
  EXPECT_EQ(policy.InterestIn(object, now_).state, "open");
}

TEST_F(RevisitPolicyTest, WantsNoLookAtWhatCannotBeReachedAndLeftAgain) {
  const RevisitPolicy policy(params_);
  EXPECT_EQ(policy.InterestIn(Unknown(0.0), now_).state, "open");
  EXPECT_EQ(policy.InterestIn(Unknown(40.0), now_).state, "out_of_reach");
  WatchedObject unseen = Unknown();
  unseen.window.reset();
  EXPECT_EQ(policy.InterestIn(unseen, now_).state, "out_of_reach");
}

TEST_F(RevisitPolicyTest, TargetsAreTheOpenObjectsWorthTheirInterestTimesTheWeight) {
  const RevisitPolicy policy(params_);
  now_.objects = {Unknown(1.0), Unknown(40.0), Unknown(-5.0)};
  now_.objects[2].belief.posterior = {.confirmed = 0.8, .removed = 0.2};
  const auto interests = policy.Interests(now_);
  const auto targets = policy.OpenTargets(now_, 2.5);
  ASSERT_EQ(interests.size(), 3U);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[0].north, 1.0);
  EXPECT_NEAR(targets[0].value, 2.5 * interests[0].worth, 1e-12);
  EXPECT_EQ(targets[1].north, -5.0);
  EXPECT_NEAR(targets[1].value, 2.5 * interests[2].worth, 1e-12);
  EXPECT_GT(targets[0].value, targets[1].value) << "what is less known is worth more";
}

constexpr PresenceLikelihood kOnePass{.if_present = 0.95, .if_absent = 0.01};

TEST(ValueOfALook, IsNothingWhenTheStatusIsKnown) {
  EXPECT_DOUBLE_EQ(ExpectedEntropyDrop({.confirmed = 1.0}, kOnePass), 0.0);
}

TEST(ValueOfALook, IsGreatestWhenConfirmedAndRemovedAreEquallyLikely) {
  const double even = ExpectedEntropyDrop({.confirmed = 0.5, .removed = 0.5}, kOnePass);
  const double skewed = ExpectedEntropyDrop({.confirmed = 0.9, .removed = 0.1}, kOnePass);
  EXPECT_GT(even, skewed);
  EXPECT_GT(even, 0.5);  // a good detector resolves most of ln 2
}

TEST(ValueOfALook, CannotTellNewFromConfirmed) {
  EXPECT_NEAR(ExpectedEntropyDrop({.confirmed = 0.5, .appeared = 0.5}, kOnePass), 0.0, 1e-12);
}

TEST(ValueOfALook, IsLessWithAWorseDetector) {
  const StatusPosterior even{.confirmed = 0.5, .removed = 0.5};
  EXPECT_GT(ExpectedEntropyDrop(even, {.if_present = 0.95, .if_absent = 0.01}),
            ExpectedEntropyDrop(even, {.if_present = 0.7, .if_absent = 0.2}));
}

}  // namespace
}  // namespace limpet
