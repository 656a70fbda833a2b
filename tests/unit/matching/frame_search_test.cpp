// SPDX-License-Identifier: MIT
#include "estimation/matching/frame_search.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// Two sessions over one place, each with objects that the other never saw.
struct FarSessions {
  std::vector<ObjectEstimate> former, now;
  FrameOffset truth;
};

ObjectEstimate ObjectAt(const Eigen::Vector3d& p_W, int kind) {
  ObjectEstimate object{.p_W = p_W, .color = kind == 0 ? "yellow" : "orange"};
  object.cov_W = 0.01 * Eigen::Matrix3d::Identity();
  return object;
}

/// `stayed` objects of both, `others` of each alone, in 60 x 60 m; each a decimetre off.
FarSessions Draw(Random& random, int stayed, int others) {
  FarSessions sessions;
  const double way = random.Uniform(0.0, 2.0 * std::numbers::pi);
  sessions.truth.shift_W = 20.0 * Eigen::Vector2d(std::cos(way), std::sin(way));
  sessions.truth.turn = random.Uniform(-0.78, 0.78);
  const auto place = [&] {
    return Eigen::Vector3d(random.Uniform(-30.0, 30.0), random.Uniform(-30.0, 30.0),
                           random.Uniform(6.0, 7.0));
  };
  const auto noise = [&] {
    return Eigen::Vector3d(random.Normal(0.1), random.Normal(0.1), random.Normal(0.03));
  };
  for (int i = 0; i < stayed + others; ++i) {
    const Eigen::Vector3d p = place();
    const int kind = i % 2;
    sessions.former.push_back(ObjectAt(p + noise(), kind));
    const Eigen::Vector3d seen = sessions.truth.Apply(i < stayed ? p : place());
    sessions.now.push_back(ObjectAt(seen + noise(), kind));
  }
  return sessions;
}

class FarFrame : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  Random random_{GetParam(), "frame search"};
};

TEST_P(FarFrame, FindsAFrame20mAndUpTo45DegreesOffWithHalfTheObjectsChanged) {
  const FarSessions sessions = Draw(random_, 7, 7);
  const auto found = SearchFrame(sessions.former, sessions.now, {});
  ASSERT_TRUE(found);
  for (const ObjectEstimate& object : sessions.former) {
    const Eigen::Vector3d off = found->offset.Apply(object.p_W) - sessions.truth.Apply(object.p_W);
    EXPECT_LT(off.head<2>().norm(), 0.5);
  }
}

TEST_P(FarFrame, FindsNothingBetweenPlacesThatHaveNothingInCommon) {
  const FarSessions sessions = Draw(random_, 0, 14);
  EXPECT_FALSE(SearchFrame(sessions.former, sessions.now, {}));
}

TEST_P(FarFrame, IsSilentWhereALineOfLikeObjectsFitsTwice) {
  std::vector<ObjectEstimate> former, now;
  for (int i = 0; i < 8; ++i) {
    former.push_back(ObjectAt({6.0 * i, 0.0, 7.0}, 0));
    if (i < 7) now.push_back(ObjectAt({6.0 * i + 13.0, 4.0, 7.0}, 0));
  }
  EXPECT_FALSE(SearchFrame(former, now, {}));
}

TEST_P(FarFrame, LooksNoFartherThanItIsTold) {
  const FarSessions sessions = Draw(random_, 10, 2);
  EXPECT_FALSE(SearchFrame(sessions.former, sessions.now, {}, {.radius_m = 5.0}));
}

INSTANTIATE_TEST_SUITE_P(Seeds, FarFrame, ::testing::Range<std::uint64_t>(1, 9));

TEST(FrameOffset, TogetherIsOneAfterTheOther) {
  const FrameOffset first{.shift_W = {3.0, -2.0}, .turn = 0.4, .pivot_W = {5.0, 1.0}, .down = 0.1};
  const FrameOffset second{
      .shift_W = {-1.0, 0.5}, .turn = -0.9, .pivot_W = {8.0, -1.0}, .down = 0.2};
  const Eigen::Vector3d p(12.0, 7.0, 6.0);
  EXPECT_LT((Together(first, second).Apply(p) - second.Apply(first.Apply(p))).norm(), 1e-12);
}

}  // namespace
}  // namespace limpet
