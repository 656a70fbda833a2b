// SPDX-License-Identifier: MIT
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"
#include "limpet/scoring/pose_track.hpp"

namespace limpet {
namespace {

PoseTrack RandomTrack(Random& random, std::vector<std::pair<double, Pose>>& poses) {
  PoseTrack track;
  double time = 1767225600.0;
  for (std::uint64_t i = 2 + random.Index(20); i > 0; --i) {
    const Pose pose{
        {random.Uniform(-9.0, 9.0), random.Uniform(-9.0, 9.0), random.Uniform(0.0, 9.0)},
        random.Uniform(-0.3, 0.3),
        random.Uniform(-0.3, 0.3),
        random.Uniform(-3.14, 3.14)};
    track.Add(Seconds(time), pose);
    poses.emplace_back(time, pose);
    time += random.Uniform(0.02, 2.0);
  }
  return track;
}

TEST(PoseTrackProperties, GivesBackThePosesThatItWasGiven) {
  Random random(1, "track");
  for (int run = 0; run < 60; ++run) {
    std::vector<std::pair<double, Pose>> poses;
    const PoseTrack track = RandomTrack(random, poses);
    for (const auto& [time, pose] : poses) {
      const auto back = track.At(time);
      ASSERT_TRUE(back);
      EXPECT_LT((back->p_WB - pose.p_WB).norm(), 1e-6);
      EXPECT_NEAR(WrapAngle(back->yaw - pose.yaw), 0.0, 1e-6);
    }
  }
}

TEST(PoseTrackProperties, LiesOnTheLineBetweenTwoPosesAndTurnsTheShortWay) {
  Random random(2, "track");
  for (int run = 0; run < 60; ++run) {
    std::vector<std::pair<double, Pose>> poses;
    const PoseTrack track = RandomTrack(random, poses);
    const std::size_t i = random.Index(poses.size() - 1);
    const auto &a = poses[i], &b = poses[i + 1];
    const double share = random.Uniform(0.01, 0.99);
    const auto pose = track.At(a.first + share * (b.first - a.first));
    ASSERT_TRUE(pose);
    const Eigen::Vector3d expected = (1.0 - share) * a.second.p_WB + share * b.second.p_WB;
    EXPECT_LT((pose->p_WB - expected).norm(), 1e-4);
    const double whole = WrapAngle(b.second.yaw - a.second.yaw);
    EXPECT_NEAR(WrapAngle(pose->yaw - a.second.yaw), share * whole, 1e-4);
  }
}

TEST(PoseTrackProperties, CountsAWayThatNeverShrinksAndIsNoShorterThanTheLine) {
  Random random(3, "track");
  for (int run = 0; run < 60; ++run) {
    std::vector<std::pair<double, Pose>> poses;
    const PoseTrack track = RandomTrack(random, poses);
    double before = 0.0;
    const double first = poses.front().first, last = poses.back().first;
    for (double time = first - 1.0; time < last + 1.0; time += 0.1) {
      const double way = track.PathAt(time);
      EXPECT_GE(way, before);
      before = way;
    }
    EXPECT_NEAR(before, track.path(track.size() - 1), 1e-9);
    EXPECT_GE(before, (poses.back().second.p_WB - poses.front().second.p_WB).norm() - 1e-9);
  }
}

TEST(PoseTrackProperties, PassesOverPosesThatComeTooLate) {
  PoseTrack track;
  track.Add(Seconds(10.0), {{1.0, 0.0, 0.0}, 0.0, 0.0, 0.0});
  track.Add(Seconds(10.0), {{2.0, 0.0, 0.0}, 0.0, 0.0, 0.0});
  track.Add(Seconds(9.0), {{3.0, 0.0, 0.0}, 0.0, 0.0, 0.0});
  track.Add(Seconds(11.0), {{4.0, 0.0, 0.0}, 0.0, 0.0, 0.0});
  EXPECT_EQ(track.size(), 2U);
  EXPECT_EQ(track.PathAt(11.0), 3.0);
}

}  // namespace
}  // namespace limpet
