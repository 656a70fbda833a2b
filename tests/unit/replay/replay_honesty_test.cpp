// SPDX-License-Identifier: MIT
// What the estimator says of its own error holds.
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/support/dropout.hpp"
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

/// Dropouts of the DVL over seeds that nothing was chosen on: means of what was told at a time.
PlaceError MeanPlaceError(const StreamScene& like, const Interval& silent, double at) {
  constexpr int kSeeds = 12;
  PlaceError mean;
  for (int i = 0; i < kSeeds; ++i) {
    StreamScene scene = like;
    scene.seed = static_cast<std::uint64_t>(701 + i);
    const SimulatedStream session = SimulateStream(scene);
    const ReplayResult result = Replay(WithoutVelocity(session.stream, silent),
                                       ParamsForStream(session.stream.meta), [] { return 0.0; });
    const PlaceError error = PlaceErrorAt(at, result, session.truth);
    mean.off += error.off / kSeeds, mean.sigma += error.sigma / kSeeds;
    mean.nees += error.nees / kSeeds;
  }
  return mean;
}

/// Ten minutes in a current; the vehicle leaves the surface 45 s after the start.
StreamScene DiveInACurrent(double seconds) {
  return {.duration_s = seconds, .current_mps = 0.15, .leg_speed_sd_mps = 0.003};
}

TEST(Honesty, ADropoutInWhichTheVehicleStartsIsAsFarOffAsItSays) {
  for (const double end : {65.0, 105.0}) {
    const PlaceError at_end = MeanPlaceError(DiveInACurrent(150.0), {45.0, end}, end);
    EXPECT_GT(at_end.nees, 0.5) << end << " s: two axes";
    EXPECT_LT(at_end.nees, 4.0) << end;
    const PlaceError later = MeanPlaceError(DiveInACurrent(150.0), {45.0, end}, end + 30.0);
    EXPECT_LT(later.nees, 4.0) << end;
    EXPECT_LT(later.off, 0.8 * at_end.off) << end << ": velocities tell how it had gone";
  }
}

TEST(Honesty, ADiveWithoutBottomLockIsAsFarOffAsItSays) {
  const PlaceError error = MeanPlaceError(DiveInACurrent(150.0), {0.0, 100.0}, 100.0);
  EXPECT_GT(error.nees, 0.5);
  EXPECT_LT(error.nees, 4.0);
}

TEST(Honesty, AStopThatADropoutHidIsBelievedAtItsEnd) {
  StreamScene scene = DiveInACurrent(400.0);
  scene.standing = Interval{320.0, 365.0};
  const PlaceError error = MeanPlaceError(scene, {300.0, 340.0}, 370.0);
  EXPECT_LT(error.nees, 5.0);
  EXPECT_LT(error.off, 4.5) << "of 10 m that it was off";
}

TEST(Honesty, ADropoutOfAVehicleOnItsWayIsHardlyDoubted) {
  const PlaceError error = MeanPlaceError(DiveInACurrent(400.0), {300.0, 340.0}, 340.0);
  EXPECT_LT(error.off, 1.1) << "fixes and heading alone make most of it";
  EXPECT_LT(error.sigma, 1.3);
  EXPECT_GT(error.nees, 0.5);
  EXPECT_LT(error.nees, 4.0);
}

}  // namespace
}  // namespace limpet
