// SPDX-License-Identifier: MIT
// The estimator on simulated sessions that are harder than the recorded ones.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "estimation/smoothing/camera_errors.hpp"
#include "limpet/objects/lens_box.hpp"
#include "tests/support/batch_solver.hpp"
#include "tests/support/simulated_stream.hpp"

namespace limpet {
namespace {

double NoClock() { return 0.0; }

StreamScene RoughHour(std::uint64_t seed) {
  return {.seed = seed,
          .duration_s = 3600.0,
          .half_size_m = 30.0,
          .objects = 14,
          .classes = 2,
          .is_rough = true,
          .tilt_deg = 0.0,
          .altitude_m = 3.5,
          .false_share = 0.6,
          .yaw_bias_degph = 4.0,
          .long_dropouts = 5,
          .has_turns_in_dropouts = true,
          .current_mps = 0.15,
          .leg_speed_sd_mps = 0.003};
}

TEST(SimulatedStream, IsTheSameForTheSameSeed) {
  const SimulatedStream a = SimulateStream({.seed = 4, .duration_s = 60.0});
  const SimulatedStream b = SimulateStream({.seed = 4, .duration_s = 60.0});
  ASSERT_EQ(a.stream.rows.size(), b.stream.rows.size());
  EXPECT_EQ(a.truth.p.back(), b.truth.p.back());
}

class HardHour : public ::testing::TestWithParam<int> {};

TEST_P(HardHour, DropoutsInACurrentAndFalseBoxesNeitherDoubleNorInventAnObject) {
  const SimulatedStream session = SimulateStream(RoughHour(static_cast<unsigned>(GetParam())));
  const ReplayResult result = Replay(session.stream, ParamsForStream(session.stream.meta), NoClock);
  const auto error = ErrorOf(result.smoothed, session.truth);
  const auto objects = ErrorsOf(result.landmarks, error.alignment, session.truth);
  EXPECT_EQ(objects.duplicates, 0);
  EXPECT_EQ(objects.false_ones, 0);
  EXPECT_LT(error.aligned, 0.25);
}

INSTANTIATE_TEST_SUITE_P(Seeds, HardHour, ::testing::Range(1, 5));

/// How far off the smoothed track is [m], once no object is doubled or invented.
double AlignedErrorOf(const StreamScene& scene) {
  const SimulatedStream session = SimulateStream(scene);
  const ReplayResult result = Replay(session.stream, ParamsForStream(session.stream.meta), NoClock);
  const auto error = ErrorOf(result.smoothed, session.truth);
  const auto objects = ErrorsOf(result.landmarks, error.alignment, session.truth);
  EXPECT_EQ(objects.duplicates + objects.false_ones, 0);
  return error.aligned;
}

TEST_P(HardHour, BurstsOfFalseVelocityDoNotCarryTheVehicleOff) {
  StreamScene scene = RoughHour(static_cast<unsigned>(GetParam()));
  scene.long_dropouts = 1;
  const double without = AlignedErrorOf(scene);
  scene.velocity_bursts = 20;
  EXPECT_LT(AlignedErrorOf(scene), without + 0.05);
}

TEST_P(HardHour, ADvlOfOneHertzIsAsGoodAsThereIsLockForIt) {
  StreamScene scene = RoughHour(static_cast<unsigned>(GetParam()));
  scene.long_dropouts = 1;
  scene.dvl_period_s = 1.0;
  EXPECT_LT(AlignedErrorOf(scene), 0.3);
}

/// The session as one hears it whose camera is mounted 2 degrees off about two axes and 5 cm off
/// along two, and whose clock is 0.2 s late.
SensorStream Mismounted(SensorStream stream) {
  constexpr double kTilt = 0.035, kLever = 0.05, kDelay = 0.2;
  stream.meta.camera =
      WithErrors(stream.meta.camera,
                 {.tilt_B = {kTilt, -kTilt, 0.0}, .lever_and_delay = {kLever, -kLever, 0.0}}, {});
  for (StreamRow& row : stream.rows) {
    if (auto* frame = std::get_if<FrameRow>(&row)) frame->frame.exposure += Seconds(kDelay);
  }
  return stream;
}

/// The session as it comes through a lens that draws what is afar from the image's middle further
/// away, so that all that it shows was in the pinhole's image; its meta data say so.
SensorStream Distorted(SensorStream stream) {
  StreamMeta& meta = stream.meta;
  meta.distortion = {.k1 = 0.25, .k2 = 0.05, .p1 = 0.002, .p2 = -0.002};
  const LensModel lens(meta.camera, meta.distortion);
  for (StreamRow& row : stream.rows) {
    auto* frame = std::get_if<FrameRow>(&row);
    if (frame == nullptr) continue;
    std::vector<Box> boxes;
    for (Box box : frame->frame.boxes) {
      box.u += lens.enclosing().cx - meta.camera.cx;
      box.v += lens.enclosing().cy - meta.camera.cy;
      if (auto seen = Distorted(lens, box)) boxes.push_back(*seen);
    }
    frame->frame.boxes = std::move(boxes);
  }
  return stream;
}

TEST(SimulatedStream, ThroughALensThatIsKnownGivesTheSameMap) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const SimulatedStream session = SimulateStream({.seed = seed});
    const auto map_of = [](const SensorStream& stream) {
      return Replay(stream, ParamsForStream(stream.meta), NoClock, {}, {},
                    SensorsForStream(stream.meta))
          .landmarks;
    };
    const auto pinhole = map_of(session.stream), through = map_of(Distorted(session.stream));
    ASSERT_EQ(pinhole.size(), through.size()) << "seed " << seed;
    for (const Landmark& one : pinhole) {
      double nearest = 1e9;
      for (const Landmark& other : through)
        nearest = std::min(nearest, (one.object.p_W - other.object.p_W).norm());
      EXPECT_LT(nearest, 0.15) << "seed " << seed << ", object " << one.id;
    }
  }
}

TEST(SimulatedStream, ThroughALensThatNobodyTellsGivesAWorseOne) {
  double told = 0.0, untold = 0.0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const SimulatedStream session = SimulateStream({.seed = seed});
    SensorStream stream = Distorted(session.stream);
    const auto error_of = [&] {
      const ReplayResult result = Replay(stream, ParamsForStream(stream.meta), NoClock, {}, {},
                                         SensorsForStream(stream.meta));
      const auto error = ErrorOf(result.smoothed, session.truth);
      return ErrorsOf(result.landmarks, error.alignment, session.truth).aligned_mean;
    };
    told += error_of();
    stream.meta.distortion = {};
    untold += error_of();
  }
  EXPECT_LT(told, 0.75 * untold) << "sums over seeds [m]";
}

/// Of what is estimated of the camera of such a session, in units of it.
double TruthOf(const std::string& state) {
  if (state == "camera_tilt_roll") return -0.035;
  if (state == "camera_tilt_pitch") return 0.035;
  if (state == "camera_lever_ahead") return -0.05;
  if (state == "camera_lever_starboard") return 0.05;
  return state == "delay" ? 0.2 : 0.0;
}

TEST(SimulatedStream, ACameraMountedAmissIsFoundAndCostsLittle) {
  double as_said = 0.0, amiss = 0.0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const SimulatedStream session = SimulateStream({.seed = seed, .duration_s = 1200.0});
    const auto replay = [&session](const SensorStream& stream, double& sum) {
      const ReplayResult result = Replay(stream, ParamsForStream(stream.meta), NoClock);
      const auto error = ErrorOf(result.smoothed, session.truth);
      const auto objects = ErrorsOf(result.landmarks, error.alignment, session.truth);
      EXPECT_EQ(objects.duplicates + objects.false_ones, 0);
      sum += error.aligned;
      return result.states.back().states;
    };
    static_cast<void>(replay(session.stream, as_said));
    for (const NamedState& state : replay(Mismounted(session.stream), amiss)) {
      const std::string name = state.name;
      if (!name.starts_with("camera_")) continue;
      EXPECT_LT(std::abs(state.value - TruthOf(name)), 3.0 * state.sd) << name << ", " << seed;
    }
  }
  EXPECT_LT(amiss, 1.5 * as_said);
}

TEST_P(HardHour, ObjectsOfHalfToTwiceTheSizeAreNeitherDoubledNorInvented) {
  StreamScene scene = RoughHour(static_cast<unsigned>(GetParam()));
  scene.size_spread = 2.0;
  const SimulatedStream session = SimulateStream(scene);
  const ReplayResult result = Replay(session.stream, ParamsForStream(session.stream.meta), NoClock);
  const TrajectoryError error = ErrorOf(result.smoothed, session.truth);
  EXPECT_LT(error.aligned, 0.3);
  const LandmarkErrors landmarks = ErrorsOf(result.landmarks, error.alignment, session.truth);
  EXPECT_EQ(landmarks.duplicates, 0);
  EXPECT_EQ(landmarks.false_ones, 0);
  // What it says of their sizes: not all alike; each with its 1-sigma.
  double smallest = 1e9, largest = 0.0;
  for (const NamedState& size : result.states.back().states) {
    EXPECT_TRUE(size.name.starts_with("radius_"));
    EXPECT_GT(size.sd, 0.0);
    smallest = std::min(smallest, size.value), largest = std::max(largest, size.value);
  }
  EXPECT_GT(largest, 1.5 * smallest);
}

TEST(SimulatedStream, ANoisierVehicleIsBelievedLess) {
  constexpr int kSessions = 10;
  double nees = 0.0;
  for (unsigned seed = 1; seed <= kSessions; ++seed) {
    const SimulatedStream session = SimulateStream({.seed = seed, .noise = 5.0});
    const ReplayResult result =
        Replay(session.stream, ParamsForStream(session.stream.meta), NoClock);
    const Eigen::Vector3d error =
        result.online.back().X_WB.p_WB - session.truth.At(result.online.back().t);
    nees += error.dot(result.online_covariance_W.back().llt().solve(error)) / kSessions;
  }
  EXPECT_LT(nees, 5.0);
}

StreamScene TwinHour(std::uint64_t seed) {
  StreamScene scene = RoughHour(seed);
  scene.has_twins = true;
  scene.yaw_bias_degph = 2.0;
  scene.false_share = 0.5;
  scene.look_alikes = 6;
  scene.long_dropouts = 1;
  return scene;
}

/// Pairs of identical objects 1.1 m apart, first seen again after most of an hour.
class TwinHourTest : public ::testing::TestWithParam<int> {};

TEST_P(TwinHourTest, TwinsAreNeverTakenForEachOtherForGood) {
  const SimulatedStream session = SimulateStream(TwinHour(static_cast<unsigned>(GetParam())));
  const ReplayResult result = Replay(session.stream, ParamsForStream(session.stream.meta), NoClock);
  const auto error = ErrorOf(result.smoothed, session.truth);
  EXPECT_EQ(ErrorsOf(result.landmarks, error.alignment, session.truth).duplicates, 0);
  EXPECT_LT(error.aligned, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Seeds, TwinHourTest, ::testing::Values(3, 9, 10, 12, 15));

TEST(SimulatedStream, CovariancesAreHonestOverManySessions) {
  constexpr int kSessions = 20;
  double pose = 0.0, landmark = 0.0;
  for (int seed = 1; seed <= kSessions; ++seed) {
    const SimulatedStream session = SimulateStream({.seed = static_cast<unsigned>(seed)});
    const ReplayResult result =
        Replay(session.stream, ParamsForStream(session.stream.meta), NoClock);
    const Eigen::Vector3d error =
        result.online.back().X_WB.p_WB - session.truth.At(result.online.back().t);
    pose += error.dot(result.online_covariance_W.back().llt().solve(error)) / kSessions;
    double sum = 0.0;
    for (const Landmark& l : result.landmarks) {
      double nearest = std::numeric_limits<double>::infinity();
      Eigen::Vector3d off = Eigen::Vector3d::Zero();
      for (const TrueLandmark& truth : session.truth.landmarks) {
        if ((truth.p - l.object.p_W).norm() < nearest)
          nearest = (truth.p - l.object.p_W).norm(), off = truth.p - l.object.p_W;
      }
      sum += off.dot(l.object.cov_W.llt().solve(off));
    }
    landmark += sum / static_cast<double>(result.landmarks.size()) / kSessions;
  }
  // 95 % band of the mean of twenty squared errors with three degrees of freedom: 3 +- 1.07.
  EXPECT_NEAR(pose, 3.0, 1.07);
  EXPECT_NEAR(landmark, 3.0, 1.07);
}

/// Two sessions over one place: in the second, two of six objects are gone and one came.
class LaterSession : public ::testing::TestWithParam<int> {
 protected:
  static StreamScene Scene(int seed) {
    return {.seed = static_cast<unsigned>(seed), .objects = 6, .place = 77};
  }
  LaterSession() {
    StreamScene scene = Scene(GetParam());
    const SimulatedStream first = SimulateStream(scene);
    scene.seed += 1000;
    scene.gone = 2;
    scene.came = 1;
    now_ = SimulateStream(scene);
    const ReplayResult before = Replay(first.stream, ParamsForStream(first.stream.meta), NoClock);
    for (const Landmark& l : before.landmarks) {
      former_.objects.push_back(
          {.id = TrueIdOf(l, before, first.truth),
           .object = {.p_W = l.object.p_W, .cov_W = l.object.cov_W, .color = l.object.color}});
    }
    former_.joint_cov_W = before.landmark_covariance;
  }
  /// The true object nearest to an estimate.
  static int TrueIdOf(const Landmark& l, const ReplayResult& result, const StreamTruth& truth) {
    const Alignment alignment = ErrorOf(result.smoothed, truth).alignment;
    const auto distance = [&](const TrueLandmark& t) {
      return (t.p - alignment.Apply(l.object.p_W)).norm();
    };
    return std::ranges::min_element(truth.landmarks, {}, distance)->id;
  }
  [[nodiscard]] ReplayResult Survey(const FormerSession& former) const {
    return Replay(now_.stream, ParamsForStream(now_.stream.meta), NoClock, {}, former);
  }

  SimulatedStream now_;
  FormerSession former_;
};

TEST_P(LaterSession, KnowsEveryObjectThatStayedAgainAndNoOther) {
  const ReplayResult result = Survey(former_);
  ASSERT_GE(result.landmarks.size(), 4U);
  for (const Landmark& l : result.landmarks) {
    const int truth = TrueIdOf(l, result, now_.truth);
    const bool was_known = std::ranges::count(former_.objects, truth, &FormerObject::id) > 0;
    EXPECT_EQ(l.former.id, was_known ? std::optional(truth) : std::nullopt);
  }
}

TEST_P(LaterSession, FindsAFrameThatLiesMetresOffAndTurned) {
  const FrameOffset shifted{.shift_W = {-4.0, 2.5}, .turn = 0.1, .pivot_W = {}};
  FormerSession moved = former_;
  for (FormerObject& former : moved.objects)
    former.object.p_W = shifted.Undo(former.object.p_W);
  NavigatorParams params = ParamsForStream(now_.stream.meta);
  params.session.datum_sigma = Meters(5.0);
  params.session.datum_turn_sigma = Radians(0.2);
  const ReplayResult here = Survey(former_);
  const ReplayResult there = Replay(now_.stream, params, NoClock, {}, moved);
  ASSERT_EQ(there.landmarks.size(), here.landmarks.size());
  for (std::size_t i = 0; i < here.landmarks.size(); ++i) {
    EXPECT_EQ(there.landmarks[i].former.id, here.landmarks[i].former.id);
  }
  const double alone = ErrorOf(Survey({}).smoothed, now_.truth).absolute;
  EXPECT_LT(ErrorOf(there.smoothed, now_.truth).absolute, alone + 0.1);
}

INSTANTIATE_TEST_SUITE_P(Seeds, LaterSession, ::testing::Range(1, 4));

TEST(SimulatedStream, AFormerSessionMakesALaterOneBetter) {
  double alone = 0.0, tied = 0.0;
  constexpr int kPairs = 8;
  for (unsigned pair = 1; pair <= kPairs; ++pair) {
    const SimulatedStream first = SimulateStream({.seed = pair, .objects = 6, .place = 77});
    const SimulatedStream now =
        SimulateStream({.seed = 1000 + pair, .objects = 6, .place = 77, .gone = 2, .came = 1});
    const ReplayResult before = Replay(first.stream, ParamsForStream(first.stream.meta), NoClock);
    FormerSession former{.objects = {}, .joint_cov_W = before.landmark_covariance};
    for (const Landmark& l : before.landmarks) {
      former.objects.push_back(
          {.id = l.id,
           .object = {.p_W = l.object.p_W, .cov_W = l.object.cov_W, .color = l.object.color}});
    }
    const NavigatorParams params = ParamsForStream(now.stream.meta);
    const auto error = [&](const FormerSession& known) {
      const ReplayResult result = Replay(now.stream, params, NoClock, {}, known);
      return ErrorOf(result.smoothed, now.truth).absolute / kPairs;
    };
    alone += error({});
    tied += error(former);
  }
  EXPECT_LT(tied, 0.9 * alone);
}

TEST(SimulatedStream, EndsWithinHalfAPercentOfTheBatchOptimum) {
  const SimulatedStream session = SimulateStream(RoughHour(3));
  double best = 0.0;
  const ReplayResult result = Replay(session.stream, ParamsForStream(session.stream.meta), NoClock,
                                     [&best](const Navigator& navigator) {
                                       ChainGraph graph = navigator.graph();
                                       best = SolveBatch(graph).cost;
                                     });
  EXPECT_TRUE(result.finish.has_converged);
  EXPECT_LE(result.finish.cost, 1.005 * best);
}

}  // namespace
}  // namespace limpet
