// SPDX-License-Identifier: MIT
#include "limpet/objects/status_posterior.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(StatusPosterior, IsLeastCertainWhereAllFourAreEquallyLikely) {
  const StatusPosterior even{0.25, 0.25, 0.25, 0.25};
  EXPECT_NEAR(even.Entropy(), std::log(4.0), 1e-12);
  EXPECT_EQ((StatusPosterior{.removed = 1.0}).Entropy(), 0.0);
  EXPECT_LT((StatusPosterior{0.7, 0.1, 0.1, 0.1}).Entropy(), even.Entropy());
}

TEST(StatusPosterior, HoldsConfirmedAndNewForPresent) {
  EXPECT_DOUBLE_EQ((StatusPosterior{0.5, 0.2, 0.25, 0.05}).present(), 0.75);
}

TEST(StatusPosterior, FollowsBayesRule) {
  const StatusPosterior prior{.confirmed = 0.5, .removed = 0.5};
  const StatusPosterior joint = prior.Times({.if_present = 0.9, .if_absent = 0.1});
  EXPECT_DOUBLE_EQ(joint.sum(), 0.5);
  EXPECT_DOUBLE_EQ(joint.Normalized().confirmed, 0.9);
  EXPECT_DOUBLE_EQ(joint.Normalized().sum(), 1.0);
}

TEST(StatusPosterior, OfTheImpossibleStaysZero) {
  const PresenceLikelihood sure{.if_present = 1.0, .if_absent = 0.0};
  EXPECT_EQ((StatusPosterior{.removed = 1.0}).Times(sure).Normalized().sum(), 0.0);
}

TEST(StatusPosterior, SaysOfWhichStatusEachOfItsSharesIs) {
  const StatusPosterior posterior{
      .confirmed = 0.4, .removed = 0.3, .appeared = 0.2, .nothing = 0.1};
  std::map<Status, double> told;
  double sum = 0.0;
  for (const auto& [status, probability] : posterior.shares()) {
    told[status] = probability;
    sum += probability;
  }
  EXPECT_EQ(told.at(Status::kConfirmed), 0.4);
  EXPECT_EQ(told.at(Status::kRemoved), 0.3);
  EXPECT_EQ(told.at(Status::kNew), 0.2);
  EXPECT_EQ(told.at(Status::kNothing), 0.1);
  EXPECT_EQ(sum, posterior.sum());
}

TEST(Status, IsOpenWhereLooksSayTooLittleOrThereWereNone) {
  EXPECT_TRUE(IsOpen(Status::kUncertain) && IsOpen(Status::kNotInspected));
  for (const Status decided :
       {Status::kConfirmed, Status::kRemoved, Status::kNew, Status::kMoved, Status::kNothing}) {
    EXPECT_FALSE(IsOpen(decided)) << NameOf(decided);
  }
}

TEST(Status, HasANameThatLeadsBack) {
  for (const Status status : {Status::kUncertain, Status::kNotInspected, Status::kConfirmed,
                              Status::kRemoved, Status::kNew, Status::kMoved, Status::kNothing}) {
    EXPECT_EQ(StatusFromName(NameOf(status)), status);
  }
  EXPECT_FALSE(StatusFromName("gone").has_value());
}

}  // namespace
}  // namespace limpet
