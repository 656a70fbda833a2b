// SPDX-License-Identifier: MIT
// A field of objects, a vehicle that flies over it, and the statuses that come of it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/change/object_statuses.hpp"
#include "limpet/core/random.hpp"

namespace limpet {

inline const CameraModel kCamera;

inline ObjectEstimate At(double north, double east, const std::string& color = "yellow") {
  return {.p_W = {north, east, 6.0}, .cov_W = 0.04 * Eigen::Matrix3d::Identity(), .color = color};
}

/// Statuses and a vehicle that flies north over the field at 3 m above the objects.
class ObjectStatusesTest : public ::testing::Test {
 protected:
  struct Real {
    ObjectEstimate object;
    std::optional<int> landmark{};
    FormerIdentity former = {};
  };
  void Fly(double east, const std::vector<Real>& objects, double detects = 1.0) {
    for (double north = -4.0; north <= 12.0; north += 0.125, time_ += 0.25) {
      ObservedFrame frame{.exposure = Seconds(time_), .X_WB = {{north, east, 3.0}, 0, 0, 0}};
      for (const Real& real : objects) {
        const Eigen::Vector3d p_C = kCamera.InCamera(frame.X_WB, real.object.p_W);
        const Eigen::Vector2d pixel = *kCamera.Project(p_C);
        if (VisibleShare(kCamera, frame.X_WB, real.object.p_W, 0.5) < 0.5) continue;
        if (!random_.Chance(detects)) continue;
        frame.boxes.push_back({.u = pixel.x(),
                               .v = pixel.y(),
                               .w = 120,
                               .h = 120,
                               .confidence = 0.9,
                               .color = real.object.color,
                               .landmark = real.landmark});
      }
      statuses_.AddFrame(std::move(frame));
    }
    time_ += 30.0;
  }
  /// The former session flew north over the field and saw what its list has.
  void FormerLookedEverywhere(const WaterVisibility& water = {Meters(10.0), Meters(4.0)}) {
    FormerViews views{.frames = {},
                      .model = {.look = {.camera = kCamera, .detection = {}}},
                      .looks = {},
                      .water = VisibilityBelief::Of(water)};
    for (double north = -4.0; north <= 12.0; north += 0.5) {
      views.frames.push_back(
          {.exposure = Seconds(north + 4.0), .X_WB = {{north, 0.0, 3.0}, 0, 0, 0}});
    }
    statuses_.SetFormerViews(std::move(views));
  }
  void Landmarks(const std::vector<Real>& objects) {
    std::vector<Landmark> known;
    for (const Real& real : objects) {
      known.push_back({.id = *real.landmark,
                       .object = real.object,
                       .detections = 10 - *real.landmark,
                       .former = real.former});
    }
    statuses_.SetLandmarks(known);
  }
  std::vector<Status> Decided() {
    std::vector<Status> decided;
    for (const OpiBelief& object : statuses_.Assess())
      decided.push_back(object.decided);
    return decided;
  }
  static FormerObject Former(int id, const ObjectEstimate& object) {
    return {.id = id, .object = object, .log_likelihood_ratio = 8.0, .looks = 5};
  }

  Random random_{7};
  double time_ = 0.0;
  ObjectStatuses statuses_{StatusParams{}, kCamera};
};

}  // namespace limpet
