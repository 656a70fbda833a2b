// SPDX-License-Identifier: MIT
// What the estimator says of its own error holds.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/simulated_stream.hpp"

namespace limpet {
namespace {

TEST(Honesty, ObjectsDoNotMakeTheStartSurerThanItsFixes) {
  const SimulatedStream session = SimulateStream({.duration_s = 400.0, .objects = 14});
  NavCovariance start = NavCovariance::Zero();
  std::size_t objects = 0;
  static_cast<void>(Replay(
      session.stream, ParamsForStream(session.stream.meta), [] { return 0.0; },
      [&](const Navigator& n) {
        start = n.smoother().PoseCovariance(0);
        objects = n.Landmarks().size();
      }));
  ASSERT_GE(objects, 5U);
  // Of a fix of 0.58 m so much wanders, and 44 more are worth 44 / 240 of it.
  const double sd = 0.5 / std::sqrt(1.0 + 44.0 / 240.0);
  EXPECT_GT(std::sqrt(start(kNavX, kNavX)), 0.98 * sd);
  EXPECT_GT(std::sqrt(start(kNavY, kNavY)), 0.98 * sd);
}

TEST(Honesty, NavigatorsCovarianceOfTwoObjectsTogetherKnowsWhatTheyShare) {
  const SimulatedStream session = SimulateStream({.duration_s = 400.0});
  static_cast<void>(Replay(
      session.stream, ParamsForStream(session.stream.meta), [] { return 0.0; },
      [&](const Navigator& n) {
        std::vector<int> slots;
        for (const TrackedObject& object : n.tracker().objects()) {
          if (object.is_landmark()) slots.push_back(object.slot());
        }
        ASSERT_GE(slots.size(), 2U);
        const Eigen::MatrixXd joint = n.smoother().CovarianceOf({}, {slots[0], slots[1]});
        // GPS puts them half a metre off together, not one against the other.
        EXPECT_GT(std::sqrt(joint(0, 0)), 0.4);
        EXPECT_LT(std::sqrt(joint(0, 0) + joint(3, 3) - 2.0 * joint(0, 3)), 0.35);
      }));
}

}  // namespace
}  // namespace limpet
