// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "estimation/association/object_tracker.hpp"
#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/camera_point.hpp"
#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"
#include "limpet/core/random.hpp"
#include "tests/support/sphere_box.hpp"

namespace limpet {

/// A vehicle flies straight lines at 0.5 m/s, 4 m above the seabed at 7.5 m, four frames a second,
/// always with one heading; spheres hang below it.
class ObjectFlight {
 public:
  explicit ObjectFlight(std::uint64_t seed = 3, double heading = 0.0,
                        const ObjectTrackerParams& params = {})
      : random_(seed), tracker_(smoother_, camera_, params) {
    truth_(kNavYaw) = heading;
  }
  /// Flies to (north, east); `drift` is added to what odometry says of the whole leg [m].
  void FlyTo(const Eigen::Vector2d& to, const Eigen::Vector2d& drift = {0.0, 0.0}) {
    const Eigen::Vector2d way = to - truth_.head<2>();
    const int steps = std::max(1, static_cast<int>(way.norm() / 0.125));
    for (int i = 0; i < steps; ++i) {
      truth_.head<2>() += way / steps;
      Step((way + drift) / steps);
      TakeFrame();
    }
  }
  [[nodiscard]] std::vector<TrackedObject> Found() const {
    std::vector<TrackedObject> found;
    for (const TrackedObject& object : tracker_.objects()) {
      if (object.is_landmark()) found.push_back(object);
    }
    return found;
  }

  std::vector<Eigen::Vector3d> objects_;
  double radius_ = 0.5;           ///< of all objects [m]
  std::string color_ = "yellow";  ///< that all boxes name
  /// Of the last frame: per box the landmark that it shows, and the object (index) that it is of;
  /// none of a false box.
  std::vector<std::optional<int>> shown_;
  std::vector<std::optional<std::size_t>> truth_of_box_;
  Eigen::Vector3d sway_W_ = Eigen::Vector3d::Zero();  ///< of all objects, every eight seconds [m]
  /// Puts the boxes of a frame into another order, if set.
  std::function<void(std::vector<std::size_t>&)> reorder_;
  double hit_share_ = 1.0, confidence_ = 0.85, noise_px_ = 2.0;
  double false_share_ = 0.0, step_sigma_ = 0.003, time_ = 0.0, path_ = 0.0;
  int frame_ = 0;

 protected:
  void Step(const Eigen::Vector2d& moved) {
    const int count = smoother_.graph().node_count();
    NavVector x = count == 0 ? truth_ : smoother_.PoseAt(count - 1);
    if (count == 0) {
      smoother_.AddNode(x, std::nullopt);
      smoother_.AddTerm(0, Term::OnPose(PosePriorFactor(x, NavVector::Constant(0.05))));
    } else {
      x.head<2>() += moved;
      const double variance = step_sigma_ * step_sigma_;
      const double c = std::cos(truth_(kNavYaw)), s = std::sin(truth_(kNavYaw));
      const Eigen::Vector4d motion(c * moved.x() + s * moved.y(), c * moved.y() - s * moved.x(),
                                   0.0, 0.0);
      smoother_.AddNode(
          x, Term::OnStep(XyzYawFactor(motion, Eigen::Vector4d(variance, variance, 1e-4, 1e-8))));
    }
    using namespace literals;
    smoother_.AddTerm(count, Term::OnPose(DepthFactor(Meters(truth_(kNavZ)), 0.02_m)));
    smoother_.AddTerm(count,
                      Term::OnPose(RollPitchFactor(Radians(0.0), Radians(0.0), Radians(0.005))));
    smoother_.Update();
    path_ += moved.norm();
  }
  void TakeFrame() {
    Detections frame{.frame = frame_++, .exposure = Seconds(time_ += 0.25), .boxes = {}};
    DrawBoxes(frame);
    const int node = smoother_.graph().node_count() - 1;
    shown_ = tracker_.Process(
        frame, {.x = smoother_.PoseAt(node), .node = node, .path = path_, .altitude = 4.0});
    smoother_.Update();
    tracker_.Refresh();
    if (tracker_.Review()) {
      smoother_.Update();
      tracker_.Refresh();
    }
    OnFrame();
  }
  /// Called after each frame.
  virtual void OnFrame() {}
  virtual ~ObjectFlight() = default;

  Random random_;
  const CameraModel camera_;
  ArrowSmoother smoother_;
  ObjectTracker tracker_;
  NavVector truth_ = (NavVector() << 0.0, 0.0, 3.5, 0.0, 0.0, 0.0).finished();

 private:
  void DrawBoxes(Detections& frame) {
    std::vector<Box> boxes;
    std::vector<std::optional<std::size_t>> of_box;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      const Eigen::Vector3d p_W = objects_[i] + std::sin(2.0 * M_PI * time_ / 8.0) * sway_W_;
      const auto box = BoxOfSphere(CameraPointOf(camera_, truth_, p_W).p_C, radius_, camera_);
      if (!box || box->w < 20.0 || box->h < 20.0) continue;
      Box seen = *box;
      if (!random_.Chance(hit_share_)) continue;
      seen.confidence = confidence_, seen.color = color_;
      if (!ExtentAcross(seen, camera_).is_cut()) {
        seen.u += noise_px_ * random_.Normal(1.0);
      }
      boxes.push_back(seen);
      of_box.emplace_back(i);
    }
    if (random_.Chance(false_share_)) {
      boxes.push_back({.u = random_.Uniform(50.0, 590.0),
                       .v = random_.Uniform(50.0, 430.0),
                       .w = random_.Uniform(40.0, 140.0),
                       .h = random_.Uniform(40.0, 140.0),
                       .confidence = random_.Uniform(0.3, 0.7),
                       .color = color_});
      of_box.emplace_back(std::nullopt);
    }
    std::vector<std::size_t> order(boxes.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    if (reorder_) reorder_(order);
    truth_of_box_.clear();
    for (const std::size_t i : order) {
      frame.boxes.push_back(boxes[i]);
      truth_of_box_.push_back(of_box[i]);
    }
  }
};

}  // namespace limpet
