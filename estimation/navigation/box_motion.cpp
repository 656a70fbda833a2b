// SPDX-License-Identifier: MIT
#include "estimation/navigation/box_motion.hpp"

#include <cmath>

namespace limpet {
namespace {

constexpr double kLeastShift = 40.0;  // [px] of a stretch: ten times a box's noise
// An object is nearer than the seabed, at most by two thirds, and a size or height may be off.
constexpr double kSlower = 0.3, kFaster = 3.5;
constexpr double kAcross = 0.6;     // times as far across: a camera turned by more than 30 degrees
constexpr double kLeastPair = 0.2;  // times as far from one image to the next, of one thing
constexpr double kMostPair = 5.0;
constexpr double kPairNoise = 6.0;      // [px] of that, whatever the way
constexpr double kAlike = 0.8;          // spread of ratios that say the same
constexpr double kLeastDescent = 1e-3;  // least cosine of a ray that meets the seabed

}  // namespace

BoxMotion::BoxMotion(const CameraModel& camera)
    : camera_(camera), comparison_({.stretch = Seconds(1.0), .least = kLeastShift, .beside = 3}) {}

BoxMotion::Middles BoxMotion::MiddlesOf(const Detections& frame, double least_confidence) const {
  Middles middles;
  for (const Box& box : frame.boxes) {
    if (!(box.confidence >= least_confidence)) continue;
    const bool is_whole = !IsCut(box, camera_);
    const auto [at, is_only] = middles.try_emplace(box.color, Eigen::Vector2d(box.u, box.v));
    if (!is_only || !is_whole) at->second.reset();
  }
  return middles;
}

std::optional<Eigen::Vector2d> BoxMotion::SeenFrom(const Pose& X_DB,
                                                   const Eigen::Vector2d& at_px) const {
  const Eigen::Vector3d ray_D = RotationOf(last_->X_DB) * camera_.R_BC * camera_.RayOf(at_px);
  if (ray_D.z() < kLeastDescent) return std::nullopt;
  const Eigen::Vector3d eye_D = last_->X_DB.p_WB + RotationOf(last_->X_DB) * camera_.p_BC;
  const double below = last_->altitude + last_->X_DB.p_WB.z() - eye_D.z();
  if (!(below > 0.0)) return std::nullopt;
  return camera_.Project(camera_.InCamera(X_DB, eye_D + below / ray_D.z() * ray_D));
}

void BoxMotion::Add(const Detections& frame, const Pose& X_DB, Meters altitude,
                    double least_confidence) {
  View now{.t = frame.exposure.value(),
           .X_DB = X_DB,
           .altitude = altitude.value(),
           .middles_px = MiddlesOf(frame, least_confidence)};
  if (last_) {
    for (const auto& [color, middle_px] : now.middles_px) {
      const auto before = last_->middles_px.find(color);
      if (!middle_px || before == last_->middles_px.end() || !before->second) continue;
      const auto expected_px = SeenFrom(X_DB, *before->second);
      if (!expected_px) continue;
      const Eigen::Vector2d way = *expected_px - *before->second;
      const Eigen::Vector2d moved = *middle_px - *before->second;
      const bool is_one_thing = moved.norm() <= kMostPair * way.norm() + kPairNoise &&
                                moved.norm() >= kLeastPair * way.norm() - kPairNoise;
      if (!is_one_thing) continue;
      comparison_.Add(now.t, way, moved);
      break;  // one thing a time: ways of several do not add up to a stretch
    }
  }
  last_ = std::move(now);
}

std::optional<MotionComparison::Ratio> BoxMotion::Disagreement() const {
  const auto ratio = comparison_.ratio();
  if (!ratio || (ratio->high_H - ratio->low_H).maxCoeff() > kAlike) return std::nullopt;
  const double along = ratio->median_H.x(), across = std::abs(ratio->median_H.y());
  const bool agrees = along >= kSlower && along <= kFaster && across <= kAcross;
  return agrees ? std::nullopt : ratio;
}

}  // namespace limpet
