// SPDX-License-Identifier: MIT
// What the first velocities after a dropout say of what bridged it.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "estimation/navigation/water_model.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// The first velocities after a dropout beside those that would still bridge it.
struct BridgeEnd {
  double t = 0.0;       ///< of the first of them [s]
  double length = 0.0;  ///< of the dropout [s]
  Eigen::Vector2d off_H =
      Eigen::Vector2d::Zero();  ///< bridged less measured, ahead and abeam, mean
  Eigen::Vector2d variance_H = Eigen::Vector2d::Zero();
  double yaw = 0.0;  ///< of the vehicle at the first [rad]
  int count = 0;
  bool is_open = false;  ///< they may yet turn out to be false
};

/// Holds velocities that come after a dropout against the model of the water that bridged it, as it
/// was before they taught it anything.
class BridgeEndCheck {
 public:
  /// 1-sigma of a horizontal velocity [m/s].
  explicit BridgeEndCheck(double velocity_noise) : velocity_noise_(velocity_noise) {}

  /// A dropout ends, whose time, length and yaw are `end`'s, unless the last one's end is still
  /// open: what was refused for a moment is no dropout.
  void Begin(const BridgeEnd& end, const WaterModel& bridged_by);
  /// A level velocity that was measured at `t`, north and east of the attitude [m/s], of a vehicle
  /// that was conducted so; those of the first seconds count.
  void Add(double t, const Eigen::Vector2d& v_D, const Conduct& conduct);
  /// At `t` [s] the first velocities turn out to have been false: the dropout ends here. Answers
  /// with the model before they taught it; nothing if the end is long past.
  std::optional<WaterModel> Reopen(double t, Radians yaw);
  /// They were true.
  void Close() {
    if (end_) end_->is_open = false;
  }
  /// The end of the last dropout that has ended; nothing before one.
  [[nodiscard]] const std::optional<BridgeEnd>& end() const { return end_; }

 private:
  double velocity_noise_;
  std::optional<WaterModel> bridged_by_;
  std::optional<BridgeEnd> end_;
};

}  // namespace limpet
