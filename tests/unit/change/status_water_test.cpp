// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/change/object_statuses.hpp"
#include "limpet/core/random.hpp"
#include "limpet/survey/look.hpp"

namespace limpet {
namespace {

const CameraModel kWaterCamera;

/// Evidence of a place where nothing looks like an object.
PlaceEvidence Clean(const PerVisibility& lambda) { return {.present = lambda, .lookalike = 0.0}; }

TEST(StatusInWater, IsThatOfOneLambdaWhereTheWaterDoesNotMatter) {
  const VisibilityBelief water(Meters(8.0), 2.0);
  for (const double lambda : {-12.0, -1.0, 0.0, 5.0, 20.0}) {
    const StatusPosterior one = ChangeStatus({.former = 8.0, .now = lambda}, {});
    const StatusPosterior all = ChangeStatus(8.0, Clean(lambda), water, {});
    EXPECT_NEAR(one.removed, all.removed, 1e-9);
    EXPECT_NEAR(one.confirmed, all.confirmed, 1e-9);
    EXPECT_NEAR(LambdaIn(water, lambda, {}), lambda, 1e-6);
  }
}

TEST(StatusInWater, ProvesNothingWhereNothingCouldHaveBeenSeen) {
  PerVisibility lambda = -10.0;
  lambda.head<12>() = 0.0;  // not seen, but in murk there is nothing to be seen
  const VisibilityBelief murk(Meters(1.5), 1.2);
  EXPECT_NEAR(ChangeStatus(8.0, Clean(lambda), murk, {}).removed, 0.5, 0.02);
  EXPECT_LT(ChangeStatus(8.0, Clean(lambda), VisibilityBelief(Meters(12.0), 1.2), {}).confirmed,
            0.01);
  EXPECT_GT(LambdaIn(murk, lambda, {}), -0.1);
}

/// An object below the vehicle's lane.
struct Sunk {
  double north = 0.0;
  double below = 3.0;  ///< its centre, below the camera [m]
  bool is_there = true;
  bool is_overgrown = false;  ///< there, but no detector knows it
  [[nodiscard]] ObjectEstimate object(double starboard = 0.0) const {
    return {.p_W = {north, starboard, 3.0 + below},
            .cov_W = 0.04 * Eigen::Matrix3d::Identity(),
            .color = "yellow"};
  }
};

/// A session over objects in water of `visibility` [m]: one pass over each of them.
class Dive {
 public:
  explicit Dive(std::vector<Sunk> objects) : objects_(std::move(objects)) {}

  void Fly(double visibility) {
    std::vector<FormerObject> former;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      former.push_back({.id = static_cast<int>(i) + 1,
                        .object = objects_[i].object(),
                        .log_likelihood_ratio = 8.0,
                        .looks = 5});
    }
    statuses_.SetFormer(former);
    DetectionModel detector;
    detector.visibility = Meters(visibility);
    for (double north = -4.0; north <= 60.0; north += 0.125, time_ += 0.25)
      AddFrame(north, detector);
    std::vector<Landmark> landmarks;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      if (boxes_[i] < 3) continue;
      const int id = static_cast<int>(i) + 1;
      landmarks.push_back({.id = id,
                           .object = objects_[i].object(),
                           .detections = boxes_[i],
                           .former = {.id = id}});
    }
    statuses_.SetLandmarks(landmarks);
  }
  [[nodiscard]] ObjectStatuses& statuses() { return statuses_; }
  [[nodiscard]] Status DecidedOf(int former_id) {
    for (const OpiBelief& belief : statuses_.Assess())
      if (belief.former_id == former_id) return belief.decided;
    return Status::kNothing;
  }
  [[nodiscard]] double RemovedOf(int former_id) {
    for (const OpiBelief& belief : statuses_.Assess())
      if (belief.former_id == former_id) return belief.posterior.removed;
    return -1.0;
  }
  [[nodiscard]] WaterVisibility water() const { return statuses_.Water().estimate(); }

 private:
  void AddFrame(double north, const DetectionModel& detector) {
    ObservedFrame frame{.exposure = Seconds(time_), .X_WB = {{north, 0.0, 3.0}, 0, 0, 0}};
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      const Eigen::Vector3d p_W = objects_[i].object().p_W;
      if (!objects_[i].is_there || objects_[i].is_overgrown) continue;
      const double share = VisibleShare(kWaterCamera, frame.X_WB, p_W, 0.5);
      if (!random_.Chance(
              DetectionChance(detector, {.range = (p_W - frame.X_WB.p_WB).norm(), .share = share})))
        continue;
      const Eigen::Vector2d pixel = *kWaterCamera.Project(kWaterCamera.InCamera(frame.X_WB, p_W));
      const double size = kWaterCamera.fx / objects_[i].below;
      frame.boxes.push_back({.u = pixel.x(),
                             .v = pixel.y(),
                             .w = size,
                             .h = size,
                             .confidence = 0.9,
                             .color = "yellow",
                             .landmark = static_cast<int>(i) + 1});
      ++boxes_[i];
    }
    statuses_.AddFrame(std::move(frame));
  }

  std::vector<Sunk> objects_;
  std::vector<int> boxes_ = std::vector<int>(objects_.size(), 0);
  Random random_{11};
  double time_ = 0.0;
  ObjectStatuses statuses_{StatusParams{}, kWaterCamera};
};

TEST(StatusWater, IsAsExpectedBeforeAnythingWasSeen) {
  Dive dive({});
  dive.Fly(2.0);  // over bare seabed
  EXPECT_NEAR(dive.water().visibility.value(), 8.0, 0.6);
}

TEST(StatusWater, ObjectsSeenFromNearByOnlyAreMurk) {
  Dive dive({{.north = 0, .below = 1.9},
             {.north = 9, .below = 3.2},
             {.north = 18, .below = 2.0},
             {.north = 27, .below = 2.1},
             {.north = 36, .below = 3.4}});
  dive.Fly(2.0);
  const WaterVisibility water = dive.water();
  EXPECT_NEAR(water.visibility.value(), 2.0, water.sd.value());
  EXPECT_LT(water.visibility.value(), 4.0);
}

TEST(StatusWater, ObjectsSeenFromAfarAreClearWater) {
  Dive dive({{.north = 0}, {.north = 9, .below = 3.5}, {.north = 18}});
  dive.Fly(8.0);
  const WaterVisibility water = dive.water();
  EXPECT_GT(water.visibility.value(), 6.0);
  EXPECT_GT(water.sd.value(), 2.0) << "how clear cannot be known from so near";
}

TEST(StatusWater, OneObjectThatNoDetectorKnowsDoesNotProveMurk) {
  const std::vector<Sunk> seen{{.north = 0}, {.north = 9}, {.north = 18}, {.north = 27}};
  std::vector<Sunk> with_blind = seen;
  with_blind.push_back({.north = 36, .is_overgrown = true});
  Dive all(seen), one_blind(with_blind);
  all.Fly(8.0);
  one_blind.Fly(8.0);
  EXPECT_NEAR(one_blind.water().visibility.value(), all.water().visibility.value(), 0.7);
}

TEST(StatusWater, RemovedObjectsDoNotMakeMurkOfWaterThatShowsOthers) {
  Dive dive({{.north = 0},
             {.north = 9},
             {.north = 18},
             {.north = 27, .is_there = false},
             {.north = 36, .is_there = false},
             {.north = 45, .is_there = false}});
  dive.Fly(8.0);
  EXPECT_GT(dive.water().visibility.value(), 6.0);
}

TEST(StatusWater, WhatMurkHidesIsNotRemoved) {
  Dive dive({{.north = 0, .below = 1.9},
             {.north = 9, .below = 3.4},
             {.north = 18, .below = 2.0},
             {.north = 27, .below = 2.1},
             {.north = 36, .below = 3.4, .is_there = false},
             {.north = 45, .below = 1.5, .is_there = false}});
  dive.Fly(2.0);
  for (const int hidden : {2, 5}) {
    EXPECT_EQ(dive.DecidedOf(hidden), Status::kUncertain) << "there or not, nobody can tell";
    EXPECT_NEAR(dive.RemovedOf(hidden), 0.5, 0.25);
  }
  EXPECT_EQ(dive.DecidedOf(6), Status::kRemoved) << "murk does not hide what would be so near";
  EXPECT_EQ(dive.DecidedOf(1), Status::kConfirmed);
}

TEST(StatusWater, WhatIsGoneFromClearWaterIsRemoved) {
  Dive dive({{.north = 0},
             {.north = 9},
             {.north = 18},
             {.north = 27, .is_there = false},
             {.north = 36, .is_there = false},
             {.north = 45, .is_there = false}});
  dive.Fly(8.0);
  for (const int gone : {4, 5, 6})
    EXPECT_GT(dive.RemovedOf(gone), 0.95);
}

TEST(StatusWater, WhereNothingIsSeenNobodyIsSureThatAllIsGone) {
  Dive dive({{.north = 0, .is_there = false},
             {.north = 9, .is_there = false},
             {.north = 18, .is_there = false},
             {.north = 27, .is_there = false}});
  dive.Fly(8.0);
  EXPECT_LT(dive.RemovedOf(1), 0.9);
  EXPECT_GT(dive.RemovedOf(1), 0.5);
}

}  // namespace
}  // namespace limpet
