// SPDX-License-Identifier: MIT
#include "limpet/replay_output/replay_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Ten minutes northwards, and one object.
ReplayResult ShortReplay() {
  ReplayResult result;
  for (int i = 0; i <= 60; ++i) {
    SmoothedPose pose{.t = 10.0 * i, .X_WB = {}};
    pose.X_WB.p_WB = {0.5 * i, 0.0, 3.0};
    result.smoothed.push_back(pose);
    pose.X_WB.p_WB.y() = 0.1;
    result.online.push_back(pose);
    result.online_covariance_W.emplace_back(0.04 * Eigen::Matrix3d::Identity());
    pose.X_WB.p_WB.y() = 0.01 * i;
    result.reckoned.push_back(pose);
  }
  Landmark landmark;
  landmark.object.p_W = {12.0, 4.0, 7.0};
  landmark.object.cov_W = 0.01 * Eigen::Matrix3d::Identity();
  result.landmarks.push_back(landmark);
  result.landmark_covariance = landmark.object.cov_W;
  return result;
}

TEST(ReplayPlot, ShowsTheErrorsOnEachAxisBesideTheBounds) {
  const std::string svg = NavErrorPlot(ShortReplay(), "session_a");
  EXPECT_THAT(svg, testing::StartsWith("<svg"));
  EXPECT_THAT(svg, HasSubstr("session_a"));
  EXPECT_THAT(svg, HasSubstr("61 poses, 1 objects"));
  for (const char* axis : {"north [m]", "east [m]", "down [m]"}) {
    EXPECT_THAT(svg, HasSubstr(axis));
  }
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(ReplayPlot, ShowsTheMapWithoutANumberThatIsNone) {
  const std::string svg = NavMapPlot(ShortReplay(), "session_a");
  EXPECT_THAT(svg, testing::StartsWith("<svg"));
  EXPECT_THAT(svg, HasSubstr("ellipse"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace limpet
