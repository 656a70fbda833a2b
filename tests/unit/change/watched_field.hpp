// SPDX-License-Identifier: MIT
// A random field of objects with a vehicle that flies lanes over it: what a session is told of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "estimation/change/object_statuses.hpp"
#include "limpet/core/random.hpp"

namespace limpet {

/// An object of the field, and what landmark and former object it is.
struct FieldObject {
  ObjectEstimate object;
  std::optional<int> landmark{};  ///< nothing: it is not there now
  std::optional<int> former{};    ///< nothing: it was not there then
};

struct Field {
  std::vector<FieldObject> objects;
  std::vector<ObservedFrame> frames;
  std::vector<ObservedFrame> former_frames;
  [[nodiscard]] std::vector<Landmark> Landmarks() const {
    std::vector<Landmark> landmarks;
    for (const FieldObject& one : objects) {
      if (!one.landmark) continue;
      landmarks.push_back({.id = *one.landmark,
                           .object = one.object,
                           .detections = 10,
                           .former = {.id = one.former}});
    }
    return landmarks;
  }
  [[nodiscard]] std::vector<FormerObject> Former() const {
    std::vector<FormerObject> former;
    for (const FieldObject& one : objects) {
      if (!one.former) continue;
      former.push_back(
          {.id = *one.former, .object = one.object, .log_likelihood_ratio = 8.0, .looks = 5});
    }
    return former;
  }
};

/// A level pose in a world that was turned and moved.
inline Pose PoseInField(double north, double east, double yaw = 0.0) {
  return {{north, east, 3.0}, 0.0, 0.0, yaw};
}

inline std::vector<Box> BoxesFrom(const Pose& X_WB, const Field& field, double detects,
                                  Random& random) {
  const CameraModel camera;
  std::vector<Box> boxes;
  for (const FieldObject& one : field.objects) {
    if (!one.landmark || VisibleShare(camera, X_WB, one.object.p_W, 0.5) < 0.6) continue;
    if (!random.Chance(detects)) continue;
    const Eigen::Vector2d pixel = *camera.Project(camera.InCamera(X_WB, one.object.p_W));
    boxes.push_back({.u = pixel.x(),
                     .v = pixel.y(),
                     .w = 120,
                     .h = 120,
                     .confidence = 0.9,
                     .color = one.object.color,
                     .landmark = one.landmark});
  }
  return boxes;
}

/// Lanes north over the field, 3 m above the objects, three metres apart.
inline std::vector<ObservedFrame> FlyLanes(const Field& field, double detects, Random& random) {
  std::vector<ObservedFrame> frames;
  double time = 0.0;
  for (const double east : {0.0, 3.0, 6.0}) {
    for (double north = -4.0; north <= 12.0; north += 0.4, time += 0.8) {
      const Pose X_WB = PoseInField(north, east);
      frames.push_back({.exposure = Seconds(time),
                        .X_WB = X_WB,
                        .altitude = 4.0,
                        .boxes = BoxesFrom(X_WB, field, detects, random)});
    }
    time += 30.0;
  }
  return frames;
}

/// Up to six objects, none nearer to another than three metres; each there now, then or both.
inline Field DrawField(std::uint64_t seed, double detects = 0.95) {
  Random random(seed, "field");
  Field field;
  const std::vector<std::string> colors{"yellow", "red"};
  for (int i = 0; i < 30 && field.objects.size() < 6; ++i) {
    const Eigen::Vector3d p_W(random.Uniform(0.0, 8.0), random.Uniform(0.0, 6.0), 6.0);
    const bool is_free = std::ranges::none_of(field.objects, [&](const FieldObject& other) {
      return (other.object.p_W - p_W).norm() < 3.0;
    });
    if (!is_free) continue;
    const int number = static_cast<int>(field.objects.size()) + 1;
    const double fate = random.Uniform(0.0, 1.0);
    field.objects.push_back({.object = {.p_W = p_W,
                                        .cov_W = 0.04 * Eigen::Matrix3d::Identity(),
                                        .color = colors[random.Index(2)]},
                             .landmark = fate < 0.7 ? std::optional(number) : std::nullopt,
                             .former = fate > 0.35 ? std::optional(100 + number) : std::nullopt});
  }
  field.frames = FlyLanes(field, detects, random);
  Field then = field;
  for (FieldObject& one : then.objects)
    one.landmark = one.former;
  field.former_frames = FlyLanes(then, 1.0, random);
  return field;
}

/// A session that has been told all of it: the former session first, then frames, then landmarks.
inline ObjectStatuses StatusesOf(const Field& field, bool with_former = true) {
  ObjectStatuses statuses(StatusParams{}, CameraModel{});
  if (with_former) {
    statuses.SetFormer(field.Former());
    statuses.SetFormerViews({.frames = field.former_frames,
                             .model = {.look = {.camera = CameraModel{}, .detection = {}}},
                             .looks = {}});
  }
  for (const ObservedFrame& frame : field.frames)
    statuses.AddFrame(frame);
  statuses.SetLandmarks(field.Landmarks());
  return statuses;
}

/// The belief in an object of the field; nothing if none is said of it.
inline std::optional<OpiBelief> BeliefOf(const FieldObject& one,
                                         const std::vector<OpiBelief>& all) {
  const auto found = std::ranges::find_if(all, [&](const OpiBelief& belief) {
    return (one.landmark && belief.landmark == one.landmark) ||
           (one.former && belief.former_id == one.former);
  });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

/// Turns a world about the vertical, then moves it.
struct FieldChange {
  double angle = 0.0;
  Eigen::Vector3d shift_W = Eigen::Vector3d::Zero();
  [[nodiscard]] Eigen::Vector3d Apply(const Eigen::Vector3d& p_W) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return Eigen::Vector3d(c * p_W.x() - s * p_W.y(), s * p_W.x() + c * p_W.y(), p_W.z()) + shift_W;
  }
  void ApplyTo(Field& field) const {
    for (FieldObject& one : field.objects)
      one.object.p_W = Apply(one.object.p_W);
    for (std::vector<ObservedFrame>* frames : {&field.frames, &field.former_frames}) {
      for (ObservedFrame& frame : *frames) {
        frame.X_WB.p_WB = Apply(frame.X_WB.p_WB);
        frame.X_WB.yaw = WrapAngle(frame.X_WB.yaw + angle);
      }
    }
  }
};

}  // namespace limpet
