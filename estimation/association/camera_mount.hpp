// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "estimation/smoothing/camera_errors.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

/// 1-sigma of what a camera's file may be off.
struct CameraMountParams {
  double tilt_sigma = 0.0;   ///< about each axis [rad]
  double lever_sigma = 0.0;  ///< ahead and to starboard [m]
  double delay_sigma = 0.0;  ///< of its stamps [s]
};

/// The camera on the vehicle, with what is known of how its extrinsics and clock differ from its
/// file: two border variables of the smoother, from the first mapped object on.
class CameraMount {
 public:
  /// Slots of the mount's two variables in the smoother.
  using Slots = std::array<int, 2>;

  /// A camera that is as its file says.
  explicit CameraMount(const CameraModel& camera) : camera_(camera) {}
  /// `smoother` must outlive it.
  CameraMount(const CameraModel& camera, const CameraMountParams& params, Smoother& smoother)
      : camera_(camera), params_(params), smoother_(&smoother) {}

  /// Before the first term on the variables. Nothing to do if they are there, or if nothing is in
  /// doubt and they are not needed anyway.
  void Begin(bool is_needed = false);
  /// The variables' slots; nothing before Begin, or if nothing is in doubt.
  [[nodiscard]] const std::optional<Slots>& slots() const { return slots_; }
  /// The camera as its file says, without estimated errors.
  [[nodiscard]] const CameraModel& camera() const { return camera_; }
  [[nodiscard]] CameraErrors errors() const;
  /// The camera as estimated now, for an exposure while the body moves like this.
  [[nodiscard]] CameraModel At(const BodyMotion& motion) const;

 private:
  [[nodiscard]] bool is_in_doubt() const {
    return params_.tilt_sigma > 0.0 || params_.lever_sigma > 0.0 || params_.delay_sigma > 0.0;
  }
  CameraModel camera_;
  CameraMountParams params_{};
  Smoother* smoother_ = nullptr;
  std::optional<Slots> slots_{};
};

}  // namespace limpet
