// SPDX-License-Identifier: MIT
// What a look is worth, over random beliefs.
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/helm/revisit_policy.hpp"

namespace limpet {
namespace {

StatusPosterior DrawPosterior(Random& random) {
  StatusPosterior posterior{.confirmed = random.Uniform(0.0, 1.0),
                            .removed = random.Uniform(0.0, 1.0),
                            .appeared = random.Uniform(0.0, 1.0),
                            .nothing = random.Uniform(0.0, 1.0)};
  return posterior.Normalized();
}

class RevisitPolicyProperties : public ::testing::TestWithParam<int> {
 protected:
  RevisitPolicyProperties() { now_.region = &region_; }
  [[nodiscard]] WatchedObject Open() {
    WatchedObject object;
    object.belief.id = 3;
    object.window = LookWindow{.half_along = 1.0, .half_across = 1.0};
    object.belief.posterior = {.confirmed = 0.3, .removed = 0.3, .appeared = 0.2, .nothing = 0.2};
    object.belief.object.p_W = {random_.Uniform(-5.0, 5.0), random_.Uniform(-5.0, 5.0), 7.0};
    return object;
  }
  SurveyArea area_{.north_min = -15, .north_max = 15, .east_min = -15, .east_max = 15};
  Region region_{area_};
  Situation now_;
  Random random_{static_cast<std::uint64_t>(GetParam()), "revisit"};
};

TEST_P(RevisitPolicyProperties, ALookIsExpectedToTellNoLessThanNothingAndNoMoreThanAll) {
  for (int i = 0; i < 200; ++i) {
    const StatusPosterior posterior = DrawPosterior(random_);
    const double drop = ExpectedEntropyDrop(posterior, {.if_present = random_.Uniform(0.5, 0.999),
                                                        .if_absent = random_.Uniform(0.0001, 0.5)});
    EXPECT_GE(drop, 0.0);
    EXPECT_LE(drop, posterior.Entropy() + 1e-12);
    EXPECT_LE(drop, std::log(2.0) + 1e-12) << "one look has two outcomes";
  }
}

TEST_P(RevisitPolicyProperties, ALookThatSeesTheSameEitherWayTellsNothing) {
  for (int i = 0; i < 50; ++i) {
    const double rate = random_.Uniform(0.05, 0.95);
    EXPECT_NEAR(
        ExpectedEntropyDrop(DrawPosterior(random_), {.if_present = rate, .if_absent = rate}), 0.0,
        1e-12);
  }
}

TEST_P(RevisitPolicyProperties, ABetterDetectorTellsMore) {
  for (int i = 0; i < 50; ++i) {
    const StatusPosterior posterior = DrawPosterior(random_);
    double before = 0.0;
    for (const double detection : {0.5, 0.7, 0.9, 0.99}) {
      const double drop =
          ExpectedEntropyDrop(posterior, {.if_present = detection, .if_absent = 0.01});
      EXPECT_GE(drop, before - 1e-12);
      before = drop;
    }
  }
}

TEST_P(RevisitPolicyProperties, APerfectDetectorTellsAllThatIsInDoubtOfPresence) {
  for (int i = 0; i < 50; ++i) {
    const StatusPosterior posterior = DrawPosterior(random_);
    const double present = posterior.present();
    const double of_presence =
        -present * std::log(present) - (1.0 - present) * std::log(1.0 - present);
    EXPECT_NEAR(ExpectedEntropyDrop(posterior, {.if_present = 1.0 - 1e-12, .if_absent = 1e-12}),
                of_presence, 1e-6);
  }
}

TEST_P(RevisitPolicyProperties, EachFruitlessLookTakesItsShareUntilTheObjectIsGivenUp) {
  RevisitPolicy::Params params;
  params.fruitless_decay = random_.Uniform(0.1, 0.9);
  params.give_up_looks = 2 + static_cast<int>(random_.Index(4));
  const RevisitPolicy policy(params);
  WatchedObject object = Open();
  const double fresh = policy.InterestIn(object, now_).worth;
  EXPECT_GT(fresh, 0.0);
  for (object.fruitless = 1; object.fruitless < params.give_up_looks; ++object.fruitless) {
    const RevisitInterest interest = policy.InterestIn(object, now_);
    EXPECT_EQ(interest.state, "open");
    EXPECT_NEAR(interest.worth, fresh * std::pow(params.fruitless_decay, object.fruitless), 1e-9);
  }
  EXPECT_EQ(policy.InterestIn(object, now_).state, "given_up");
  EXPECT_EQ(policy.InterestIn(object, now_).worth, 0.0);
}

TEST_P(RevisitPolicyProperties, WhatIsKnownWellEnoughOrSeenOftenEnoughIsSettled) {
  const RevisitPolicy policy(RevisitPolicy::Params{});
  WatchedObject sure = Open();
  sure.belief.posterior = {.confirmed = 0.99, .removed = 0.01, .appeared = 0.0, .nothing = 0.0};
  EXPECT_EQ(policy.InterestIn(sure, now_).state, "settled");
  WatchedObject seen = Open();
  seen.belief.looks = RevisitPolicy::Params{}.settled_looks;
  EXPECT_EQ(policy.InterestIn(seen, now_).state, "settled");
  seen.belief.looks -= 1;
  EXPECT_EQ(policy.InterestIn(seen, now_).state, "open");
}

TEST_P(RevisitPolicyProperties, WhatNoPassCanShowIsOutOfReach) {
  const RevisitPolicy policy(RevisitPolicy::Params{});
  WatchedObject unseen = Open();
  unseen.window.reset();
  EXPECT_EQ(policy.InterestIn(unseen, now_).state, "out_of_reach");
  WatchedObject outside = Open();
  outside.belief.object.p_W.x() = 60.0;
  EXPECT_EQ(policy.InterestIn(outside, now_).state, "out_of_reach");
}

TEST_P(RevisitPolicyProperties, OnlyOpenObjectsAreTargetsAndTheirWorthIsWeighted) {
  const RevisitPolicy policy(RevisitPolicy::Params{});
  for (int i = 0; i < 4; ++i)
    now_.objects.push_back(Open());
  now_.objects[1].belief.looks = 50;
  now_.objects[3].window.reset();
  const double weight = random_.Uniform(0.1, 5.0);
  const std::vector<Target> targets = policy.OpenTargets(now_, weight);
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[0].north, now_.objects[0].belief.object.p_W.x());
  EXPECT_EQ(targets[1].east, now_.objects[2].belief.object.p_W.y());
  EXPECT_NEAR(targets[0].value, weight * policy.InterestIn(now_.objects[0], now_).worth, 1e-9);
  EXPECT_EQ(policy.Interests(now_).size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(Drawn, RevisitPolicyProperties, ::testing::Range(1, 7));

}  // namespace
}  // namespace limpet
