// SPDX-License-Identifier: MIT
// Two sessions whose frames lie apart, by metres and by degrees, with objects that went and came.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/matching/frame_offset.hpp"
#include "estimation/matching/session_matching.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

FrameOffset DrawOffset(Random& random, double metres, double radians) {
  return {.shift_W = {random.Uniform(-metres, metres), random.Uniform(-metres, metres)},
          .turn = random.Uniform(-radians, radians),
          .pivot_W = {random.Normal(30.0), random.Normal(30.0)},
          .down = random.Uniform(-1.0, 1.0)};
}

Eigen::Vector3d DrawPoint(Random& random) {
  return {random.Normal(40.0), random.Normal(40.0), random.Uniform(0.0, 20.0)};
}

TEST(FrameOffsetMotion, UndoneItIsWhereItWasEitherWayRound) {
  Random random(141);
  for (int i = 0; i < 300; ++i) {
    const FrameOffset offset = DrawOffset(random, 10.0, 3.0);
    const Eigen::Vector3d p = DrawPoint(random);
    EXPECT_LT((offset.Undo(offset.Apply(p)) - p).norm(), 1e-9);
    EXPECT_LT((offset.Apply(offset.Undo(p)) - p).norm(), 1e-9);
  }
}

TEST(FrameOffsetMotion, KeepsEveryDistance) {
  Random random(142);
  for (int i = 0; i < 300; ++i) {
    const FrameOffset offset = DrawOffset(random, 10.0, 3.0);
    const Eigen::Vector3d p = DrawPoint(random), q = DrawPoint(random);
    EXPECT_NEAR((offset.Apply(p) - offset.Apply(q)).norm(), (p - q).norm(), 1e-9);
  }
}

TEST(FrameOffsetMotion, TheShiftIsWhatHappensToThePivot) {
  Random random(143);
  for (int i = 0; i < 300; ++i) {
    const FrameOffset offset = DrawOffset(random, 10.0, 3.0);
    const Eigen::Vector3d pivot(offset.pivot_W.x(), offset.pivot_W.y(), 5.0);
    const Eigen::Vector3d moved = offset.Apply(pivot) - pivot;
    EXPECT_LT((moved - Eigen::Vector3d(offset.shift_W.x(), offset.shift_W.y(), offset.down)).norm(),
              1e-9);
  }
}

TEST(FrameOffsetMotion, MovesByAStepAsItsJacobianSays) {
  Random random(144);
  for (int i = 0; i < 300; ++i) {
    const FrameOffset offset = DrawOffset(random, 10.0, 3.0);
    const Eigen::Vector3d p = DrawPoint(random);
    Eigen::Vector4d step;
    for (int k = 0; k < 4; ++k)
      step(k) = random.Normal(1e-5);
    FrameOffset moved = offset;
    moved.Move(step);
    EXPECT_LT((moved.Apply(p) - offset.Apply(p) - offset.Jacobian(p) * step).norm(), 1e-6);
    EXPECT_LT((moved.vector() - offset.vector() - step).norm(), 1e-12);
  }
}

/// A field of objects metres apart, and what the next session sees of it through an offset.
struct OffsetSessions {
  std::vector<ObjectEstimate> former, now;
  FormerMatches truth;
};

OffsetSessions SeeThrough(const FrameOffset& offset, Random& random, double gone_share) {
  OffsetSessions sessions;
  std::vector<Eigen::Vector3d> places;
  while (places.size() < 9) {
    const Eigen::Vector3d p(random.Uniform(-25, 25), random.Uniform(-25, 25), 6.0);
    const bool is_free = std::ranges::all_of(
        places, [&p](const Eigen::Vector3d& other) { return (other - p).norm() > 6.0; });
    if (is_free) places.push_back(p);
  }
  const auto object = [&random](Eigen::Vector3d p_W, const std::string& color) {
    p_W += Eigen::Vector3d(random.Normal(0.05), random.Normal(0.05), 0.0);
    return ObjectEstimate{.p_W = p_W, .cov_W = 0.01 * Eigen::Matrix3d::Identity(), .color = color};
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string color = i % 2 == 0 ? "yellow" : "red";
    const bool stays = i < 4 || !random.Chance(gone_share);
    sessions.former.push_back(object(places[i], color));
    sessions.truth.push_back(stays ? std::optional(static_cast<int>(sessions.now.size()))
                                   : std::nullopt);
    if (stays) sessions.now.push_back(object(offset.Apply(places[i]), color));
  }
  return sessions;
}

/// Where the fixes of both sessions may be metres and degrees apart.
MatchingParams WideOpen() {
  MatchingParams params;
  params.offset_sigma = Meters(3.0);
  params.down_sigma = Meters(1.0);
  params.turn_sigma = Radians(0.1);
  return params;
}

class OffsetField : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  Random random_{GetParam(), "offsets"};
};

TEST_P(OffsetField, IsFoundAgainThroughMetresAndDegrees) {
  FrameOffset offset = DrawOffset(random_, 4.0, 0.12);
  offset.pivot_W.setZero();
  const OffsetSessions sessions = SeeThrough(offset, random_, 0.3);
  const SessionMatch match = MatchSessions(sessions.former, sessions.now, WideOpen());
  EXPECT_EQ(match.now_of_former, sessions.truth);
  EXPECT_NEAR(match.offset.turn, offset.turn, 0.02);
  EXPECT_NEAR(match.offset.down, offset.down, 0.1);
  for (const ObjectEstimate& object : sessions.former)
    EXPECT_LT((match.offset.Apply(object.p_W) - offset.Apply(object.p_W)).norm(), 0.4);
}

TEST_P(OffsetField, TheOffsetIsAtItsPriorsMeanWithoutAMatch) {
  const OffsetSessions sessions = SeeThrough({}, random_, 0.0);
  const SessionMatch nothing = MatchSessions(sessions.former, {}, {});
  EXPECT_EQ(nothing.now_of_former, FormerMatches(sessions.former.size()));
  EXPECT_LT(nothing.offset.vector().norm(), 1e-12);
}

TEST_P(OffsetField, ATurnOfBothFramesTurnsTheShiftAndNothingElse) {
  const OffsetSessions sessions = SeeThrough({.shift_W = {0.5, -0.3}}, random_, 0.3);
  OffsetSessions turned = sessions;
  const FrameOffset turn{.turn = random_.Uniform(-3.0, 3.0)};
  for (auto* list : {&turned.former, &turned.now}) {
    for (ObjectEstimate& object : *list)
      object.p_W = turn.Apply(object.p_W);
  }
  const SessionMatch before = MatchSessions(sessions.former, sessions.now, {});
  const SessionMatch after = MatchSessions(turned.former, turned.now, {});
  EXPECT_EQ(after.now_of_former, before.now_of_former);
  EXPECT_NEAR(after.offset.turn, before.offset.turn, 1e-5);
  const Eigen::Vector3d shift(before.offset.shift_W.x(), before.offset.shift_W.y(), 0.0);
  EXPECT_LT((turn.Apply(shift).head<2>() - after.offset.shift_W).norm(), 1e-4);
}

TEST_P(OffsetField, AMatchMoreNeverLeavesTheOffsetLessCertain) {
  const OffsetSessions sessions = SeeThrough({}, random_, 0.0);
  FormerMatches matches(sessions.former.size());
  double before = 1e9;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    matches[i] = sessions.truth[i];
    const SessionMatch fit = FitSessions(sessions.former, sessions.now, matches, {});
    const double now = fit.offset_cov.topLeftCorner<2, 2>().trace();
    // The second match is the first that asks about the turn.
    if (i != 1) {
      EXPECT_LE(now, before * (1.0 + 1e-9)) << i + 1 << " matches";
    }
    before = now;
  }
}

TEST_P(OffsetField, NoObjectOfThisSessionIsTwoOfTheFormerOne) {
  // Twice as crowded, and off by half the distance between objects: hard to tell.
  OffsetSessions sessions = SeeThrough({.shift_W = {0.7, 0.7}}, random_, 0.4);
  const std::size_t count = sessions.former.size();
  for (std::size_t i = 0; i < count; ++i) {
    ObjectEstimate twin = sessions.former[i];
    twin.p_W.x() += 1.0;
    sessions.former.push_back(twin);
  }
  std::vector<int> used;
  const SessionMatch match = MatchSessions(sessions.former, sessions.now, WideOpen());
  for (const std::optional<int>& now : match.now_of_former) {
    if (!now) continue;
    EXPECT_EQ(std::ranges::count(used, *now), 0);
    EXPECT_LT(*now, static_cast<int>(sessions.now.size()));
    used.push_back(*now);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, OffsetField, ::testing::Range<std::uint64_t>(1, 16));

}  // namespace
}  // namespace limpet
