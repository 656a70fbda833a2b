// SPDX-License-Identifier: MIT
// Two sessions of one random field: what is found must not depend on how objects are listed or
// where the origin lies, and must be what a plain search over all matchings finds best.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "estimation/matching/own_covariance.hpp"
#include "estimation/matching/session_matching.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kMatchSigma = 0.1;

/// Objects at least 4 m apart, and the same ones as a second session sees them: shifted, a little
/// off each; some gone, some new.
struct TwoSessions {
  std::vector<ObjectEstimate> former, now;
  FormerMatches truth;
  Eigen::Vector2d shift;
};

ObjectEstimate Known(const Eigen::Vector3d& place, const std::string& color) {
  return {.p_W = place,
          .cov_W = kMatchSigma * kMatchSigma * Eigen::Matrix3d::Identity(),
          .color = color};
}

std::vector<Eigen::Vector3d> Field(Random& random, std::size_t count) {
  std::vector<Eigen::Vector3d> places;
  while (places.size() < count) {
    const Eigen::Vector3d place(random.Uniform(-20.0, 20.0), random.Uniform(-20.0, 20.0), 6.0);
    const bool is_free = std::ranges::all_of(
        places, [&place](const Eigen::Vector3d& other) { return (place - other).norm() > 4.0; });
    if (is_free) places.push_back(place);
  }
  return places;
}

TwoSessions MakeSessions(std::uint64_t seed) {
  Random random(seed, "sessions");
  TwoSessions made;
  made.shift = {random.Uniform(-0.8, 0.8), random.Uniform(-0.8, 0.8)};
  const std::vector<Eigen::Vector3d> places = Field(random, 10);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string color = random.Chance(0.5) ? "yellow" : "orange";
    const auto noise = [&random] {
      return Eigen::Vector3d(random.Normal(kMatchSigma), random.Normal(kMatchSigma), 0.0);
    };
    const bool is_former = i < 8, is_now = i < 6 || i >= 8;  // 6 stay, 2 go, 2 come
    if (is_former) made.former.push_back(Known(places[i] + noise(), color));
    if (is_former) {
      made.truth.push_back(is_now ? std::optional(static_cast<int>(made.now.size()))
                                  : std::nullopt);
    }
    const Eigen::Vector3d shift(made.shift.x(), made.shift.y(), 0.0);
    if (is_now) made.now.push_back(Known(places[i] + shift + noise(), color));
  }
  return made;
}

class RandomSessions : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  const TwoSessions made_ = MakeSessions(GetParam());
};

TEST_P(RandomSessions, MatchWhatIsThereInBothAndNothingElse) {
  EXPECT_EQ(MatchSessions(made_.former, made_.now, {}).now_of_former, made_.truth);
}

TEST_P(RandomSessions, FindTheShiftWithinWhatTheySayOfIt) {
  const SessionMatch match = MatchSessions(made_.former, made_.now, {});
  // The turn about the former objects' mean leaves the shift as that of the mean.
  for (int axis = 0; axis < 2; ++axis) {
    const double sigma = std::sqrt(match.offset_cov(axis, axis));
    EXPECT_LT(std::abs(match.offset.shift_W(axis) - made_.shift(axis)), 4.0 * sigma + 0.02);
    EXPECT_LT(sigma, 0.2) << "six matches tell more than the prior";
  }
}

TEST_P(RandomSessions, MatchTheSameHoweverTheyAreListed) {
  Random random(GetParam(), "order");
  std::vector<std::size_t> order(made_.now.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::shuffle(order, random.engine());
  std::vector<ObjectEstimate> shuffled;
  for (const std::size_t i : order)
    shuffled.push_back(made_.now[i]);
  const SessionMatch plain = MatchSessions(made_.former, made_.now, {});
  const SessionMatch other = MatchSessions(made_.former, shuffled, {});
  for (std::size_t i = 0; i < made_.former.size(); ++i) {
    std::optional<int> match = other.now_of_former[i];
    if (match) match = static_cast<int>(order[static_cast<std::size_t>(*match)]);
    EXPECT_EQ(match, plain.now_of_former[i]);
  }
  EXPECT_LT((plain.offset.shift_W - other.offset.shift_W).norm(), 1e-6);
}

TEST_P(RandomSessions, MatchTheSameWhereverTheOriginLies) {
  const Eigen::Vector3d away(300.0, -150.0, 2.0);
  std::vector<ObjectEstimate> former = made_.former, now = made_.now;
  for (auto* list : {&former, &now}) {
    for (ObjectEstimate& object : *list)
      object.p_W += away;
  }
  const SessionMatch plain = MatchSessions(made_.former, made_.now, {});
  const SessionMatch moved = MatchSessions(former, now, {});
  EXPECT_EQ(moved.now_of_former, plain.now_of_former);
  EXPECT_LT((moved.offset.vector() - plain.offset.vector()).norm(), 1e-6);
}

TEST_P(RandomSessions, MatchBackwardsAsTheyMatchForwards) {
  const SessionMatch there = MatchSessions(made_.former, made_.now, {});
  const SessionMatch back = MatchSessions(made_.now, made_.former, {});
  for (std::size_t i = 0; i < made_.former.size(); ++i) {
    if (const std::optional<int> match = there.now_of_former[i]) {
      EXPECT_EQ(back.now_of_former[static_cast<std::size_t>(*match)], static_cast<int>(i));
    }
  }
  EXPECT_LT((there.offset.shift_W + back.offset.shift_W).norm(), 0.1);
}

TEST_P(RandomSessions, GiveChancesThatAreOnes) {
  const SessionMatch match = MatchSessions(made_.former, made_.now, {});
  ASSERT_EQ(match.chance.rows(), static_cast<Eigen::Index>(made_.former.size()));
  ASSERT_EQ(match.chance.cols(), static_cast<Eigen::Index>(made_.now.size()));
  EXPECT_GE(match.chance.minCoeff(), 0.0);
  EXPECT_LE(match.chance.rowwise().sum().maxCoeff(), 1.0 + 1e-9) << "one object, one match";
  EXPECT_LE(match.chance.colwise().sum().maxCoeff(), 1.0 + 1e-9);
  for (std::size_t i = 0; i < made_.truth.size(); ++i) {
    if (made_.truth[i]) {
      EXPECT_GT(match.chance(static_cast<Eigen::Index>(i), *made_.truth[i]), 0.9);
    }
  }
}

TEST_P(RandomSessions, AreNotLedAstrayByAnObjectFarFromAll) {
  std::vector<ObjectEstimate> former = made_.former, now = made_.now;
  former.push_back(Known({500.0, 500.0, 6.0}, "yellow"));
  now.push_back(Known({-500.0, 500.0, 6.0}, "yellow"));
  FormerMatches expected = made_.truth;
  expected.push_back(std::nullopt);
  EXPECT_EQ(MatchSessions(former, now, {}).now_of_former, expected);
}

INSTANTIATE_TEST_SUITE_P(Fields, RandomSessions,
                         ::testing::Range(std::uint64_t{1}, std::uint64_t{13}));

TEST(FitSessionsProperties, IsTheWeightedMeanWithAWideOpenPrior) {
  Random random(5, "fit");
  MatchingParams params;
  params.offset_sigma = Meters(50.0);
  params.position_floor = Meters(0.0);
  params.turn_sigma = Radians::FromTextUnit(0.01);  // as good as none
  for (int run = 0; run < 20; ++run) {
    std::vector<ObjectEstimate> former, now;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weights = 0.0;
    FormerMatches matches;
    for (int i = 0; i < 5; ++i) {
      const double sigma = random.Uniform(0.05, 0.5);
      ObjectEstimate a{.p_W = {random.Uniform(-9.0, 9.0), random.Uniform(-9.0, 9.0), 6.0},
                       .cov_W = sigma * sigma * Eigen::Matrix3d::Identity(),
                       .color = "yellow"};
      ObjectEstimate b = a;
      const Eigen::Vector2d apart(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
      b.p_W.head<2>() += apart;
      sum += apart / (2.0 * sigma * sigma);
      weights += 1.0 / (2.0 * sigma * sigma);
      former.push_back(a);
      now.push_back(b);
      matches.emplace_back(i);
    }
    // The mean of the former objects is the pivot: a tiny turn moves single ones, not the shift.
    const SessionMatch fit = FitSessions(former, now, matches, params);
    EXPECT_LT((fit.offset.shift_W - sum / weights).norm(), 2e-3);
    EXPECT_NEAR(fit.offset_cov(0, 0), 1.0 / weights, 0.02 / weights);
  }
}

TEST(FrameOffsetProperties, HasTheJacobianOfItsApply) {
  Random random(6, "jacobian");
  for (int run = 0; run < 50; ++run) {
    const FrameOffset offset{.shift_W = {random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0)},
                             .turn = random.Uniform(-3.0, 3.0),
                             .pivot_W = {random.Uniform(-9.0, 9.0), random.Uniform(-9.0, 9.0)},
                             .down = random.Uniform(-1.0, 1.0)};
    const Eigen::Vector3d point(random.Uniform(-9.0, 9.0), random.Uniform(-9.0, 9.0), 5.0);
    const auto jacobian = offset.Jacobian(point);
    for (int column = 0; column < 4; ++column) {
      constexpr double kStep = 1e-6;
      FrameOffset up = offset, low = offset;
      up.Move(kStep * Eigen::Vector4d::Unit(column));
      low.Move(-kStep * Eigen::Vector4d::Unit(column));
      const Eigen::Vector3d numeric = (up.Apply(point) - low.Apply(point)) / (2.0 * kStep);
      EXPECT_LT((jacobian.col(column) - numeric).norm(), 1e-7) << column;
    }
    EXPECT_LT((offset.Undo(offset.Apply(point)) - point).norm(), 1e-9);
  }
}

TEST(SplitCovariance, IsTheJointAgainWhenPutTogether) {
  Random random(7, "split");
  for (int run = 0; run < 20; ++run) {
    const std::vector<Eigen::Vector3d> places = Field(random, 5);
    const Eigen::Vector2d pivot(1.0, -2.0);
    const Eigen::Index size = 15;
    Eigen::MatrixXd root =
        Eigen::MatrixXd::NullaryExpr(size, size, [&random] { return random.Uniform(-0.2, 0.2); });
    Eigen::MatrixXd J(size, 4);
    const FrameOffset rest{.pivot_W = pivot};
    for (Eigen::Index i = 0; i < 5; ++i) {
      J.middleRows<3>(3 * i) = rest.Jacobian(places[static_cast<std::size_t>(i)]);
    }
    const Eigen::MatrixXd joint = root * root.transpose() +
                                  0.01 * Eigen::MatrixXd::Identity(size, size) +
                                  0.5 * J.leftCols<3>() * J.leftCols<3>().transpose();
    const SplitCovariance split = SplitFrom(places, joint, pivot);
    EXPECT_LT((J * split.frame * J.transpose() + split.own - joint).norm(), 1e-9 * joint.norm());
    const auto least = [](const Eigen::MatrixXd& matrix) {
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().minCoeff();
    };
    EXPECT_GT(least(split.own), -1e-9) << "a covariance";
    EXPECT_GT(least(split.frame), -1e-9);
    EXPECT_LT(split.own.trace(), joint.trace()) << "what is common is not each object's own";
  }
}

TEST(OwnCovariance, LeavesNoObjectSurerThanItsShareAndNoneSurerThanTheModelSays) {
  Random random(8, "own");
  std::vector<ObjectEstimate> objects;
  for (int i = 0; i < 6; ++i) {
    const double sigma = random.Uniform(0.3, 1.0);
    objects.push_back({.p_W = {2.0 * i, 0.0, 6.0},
                       .cov_W = sigma * sigma * Eigen::Matrix3d::Identity(),
                       .color = "yellow"});
  }
  const std::vector<ObjectEstimate> own = WithOwnCovariance(objects);
  ASSERT_EQ(own.size(), objects.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(own[i].p_W, objects[i].p_W);
    EXPECT_LE(own[i].cov_W.trace(), objects[i].cov_W.trace() + 1e-12);
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(own[i].cov_W).eigenvalues().minCoeff(),
              -1e-12);
  }
  const Eigen::MatrixXd joint = JointOfSingles(objects);
  for (Eigen::Index i = 0; i < 6; ++i) {
    EXPECT_LT((joint.block<3, 3>(3 * i, 3 * i) - objects[static_cast<std::size_t>(i)].cov_W).norm(),
              1e-9)
        << "each object alone is known as well as it was";
  }
}

}  // namespace
}  // namespace limpet
